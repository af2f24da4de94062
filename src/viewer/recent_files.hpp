// Recent files: paths of what was opened, the newest first, for lists to choose from.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace drapeau {

inline constexpr std::size_t max_recent_files = 8;

/// Puts the path in front, once, and drops the oldest.
inline void remember_file(std::vector<std::string>& files, const std::filesystem::path& file) {
    std::error_code failure;
    const std::string path = std::filesystem::absolute(file, failure).string();
    if (failure) return;
    std::erase(files, path);
    files.insert(files.begin(), path);
    if (files.size() > max_recent_files) files.resize(max_recent_files);
}

/// What a list shows for each: the file's name, or its whole path where another, or one of `others`, has that name.
inline std::vector<std::string> shown_names(const std::vector<std::string>& files, bool with_ending,
                                            const std::vector<std::string>& others = {}) {
    std::vector<std::string> names, all = others;
    for (const std::string& file : files) {
        const std::filesystem::path path = file;
        names.push_back((with_ending ? path.filename() : path.stem()).string());
        all.push_back(names.back());
    }
    for (std::size_t i = 0; i < files.size(); ++i)
        if (std::count(all.begin(), all.end(), names[i]) > 1) names[i] = files[i];
    return names;
}

}  // namespace drapeau

// SceneWatch: whether a file was written anew by another program, however that writes: over the old bytes, piece by
// piece, or by a new file that takes the old one's name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace drapeau {

class SceneWatch {
public:
    static constexpr double pause = 0.25;  // s between two looks

    /// Looks at this file from now on, as it is now; an empty path is none.
    void begin(const std::filesystem::path& file);
    const std::filesystem::path& file() const { return file_; }

    /// Whether the file is another than before, told once. `now` (s) is any clock: the file is looked at no more often
    /// than every `pause`. One that is away or empty is being written, and so is one that differs between two looks.
    bool changed(double now);

    /// The file is taken as it is now: this program wrote it.
    void accept();

private:
    struct Stamp {
        std::int64_t seconds = 0, nanoseconds = 0;  // of its last change
        std::uintmax_t bytes = 0, inode = 0, device = 0;

        bool operator==(const Stamp&) const = default;
    };
    std::optional<Stamp> look() const;  // nothing of what is no file

    std::filesystem::path file_;
    std::optional<Stamp> known_, last_;
    double looked_ = -1e9;  // s
};

}  // namespace drapeau

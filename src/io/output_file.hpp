// OutputFile: what a program writes appears complete under its name, or the old file stays as it was.
// The bytes go into a hidden file beside the target, which is flushed to the disk and then renamed over it. Links are
// followed and stay; an existing file keeps its permissions; devices and pipes are written directly.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

class OutputFile {
public:
    /// Throws InputError, having changed nothing, if `name` cannot be written: no such folder, a folder, no permission,
    /// a pipe that nobody reads.
    explicit OutputFile(const std::string& name);
    /// What is not finished is removed.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Throws InputError, for a full disk too.
    void append(std::string_view bytes);

    /// The file takes its name. Throws InputError if that fails.
    void finish();

    /// Where the bytes go until then, with the ending of the name: for another program that writes them.
    const std::filesystem::path& path() const { return path_; }

private:
    std::string name_;              // as the user gave it, for messages
    std::filesystem::path target_;  // behind all links
    std::filesystem::path path_;
    bool direct_ = false;
    bool finished_ = false;
    int descriptor_ = -1;
};

using Append = std::function<void(std::string_view)>;

/// Calls write(append) and puts what it appends into the file. The signals that end a program wait meanwhile, so that
/// an interrupted program leaves nothing behind either.
void write_file(const std::string& name, const std::function<void(const Append&)>& write);

/// Throws InputError if write_file could not begin. Leaves nothing behind.
void check_writable(const std::string& name);

/// The same place by whatever name, whether there is a file yet or not.
bool is_same_file(const std::string& one, const std::string& other);

/// A file and what asked for it, in the user's words: an option, or "the scene".
struct NamedFile {
    std::string asked_by, name;
};

/// Finds out before the work whether its results can be kept: throws InputError if an output cannot be written, or is
/// the same file as an input or another output. Devices take what they are given, twice too.
void check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace drapeau

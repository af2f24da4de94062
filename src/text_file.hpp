// Small files read whole and never more than they should be; results written whole or not at all.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace drapeau {

/// The file's bytes. Throws InputError if it cannot be read, is longer than `most_bytes` (a device may be endless) or
/// is a pipe that stays silent for 5 s.
std::string read_text_file(const std::string& name, std::size_t most_bytes);

/// Throws InputError if write_text_file could not begin: no such folder, a folder, no permission. Leaves nothing
/// behind.
void check_writable(const std::string& name);

/// Calls write(append) and puts what it appends into the file. A file appears complete, under its name, or not at all,
/// also when the program is interrupted; devices and pipes are written directly. Throws InputError, for a full disk
/// too.
using Append = std::function<void(std::string_view)>;
void write_text_file(const std::string& name, const std::function<void(const Append&)>& write);

}  // namespace drapeau

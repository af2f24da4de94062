// Small files read whole and never more than they should be; results written whole or not at all.
#pragma once

#include "io/output_file.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace drapeau {

/// The file's bytes. Throws InputError if it cannot be read, is longer than `max_bytes` (a device may be endless) or
/// is a pipe that stays silent for 5 s.
std::string read_text_file(const std::string& name, std::size_t max_bytes);

/// write_file for text.
inline void write_text_file(const std::string& name, const std::function<void(const Append&)>& write) {
    write_file(name, write);
}

}  // namespace drapeau

// Numbered name: the name of a sequence of files, with the place of their number: "frames-%04d.png" stands for
// frames-0000.png, frames-0001.png ...
#pragma once

#include <filesystem>

namespace drapeau {

/// Whether the last part of the path has a % in it: meant as the name of a sequence, right or wrong.
bool means_sequence(const std::filesystem::path& name);

/// Throws InputError unless that part has one place for a number, %d or %0Nd with N from 1 to 9.
void check_numbered(const std::filesystem::path& name);

/// The name of file `number`, counted from 0, of a sequence whose name is good.
std::filesystem::path numbered(const std::filesystem::path& name, long long number);

}  // namespace drapeau

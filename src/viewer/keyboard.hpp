// Keyboard: which shortcut a key is on any layout. Shortcuts are Latin letters, found on the keys that are labelled
// with them; a layout without a letter (Russian, Greek) has it where a US keyboard does. Symbols (. + -) are taken from
// what is typed, for many layouts have them only with Shift.
#pragma once

#include <string>
#include <vector>

namespace drapeau {

/// The letter a to z that a key stands for, or '\0'. `types`: what the key types unshifted; `us_letter`: the letter at
/// its place on a US keyboard, '\0' where there is none; `layout`: what every key types unshifted.
char shortcut_letter(const std::string& types, char us_letter, const std::vector<std::string>& layout);

}  // namespace drapeau

// Encoding: why bytes are not the UTF-8 text that was wanted, in words that help to save the file anew.
#pragma once

#include <string>
#include <string_view>

namespace drapeau {

/// What the bytes are instead ("UTF-16, not UTF-8; ..."); empty if they are UTF-8 text.
std::string encoding_fault(std::string_view bytes);

}  // namespace drapeau

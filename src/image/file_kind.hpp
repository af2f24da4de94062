// What a file is, by its first bytes; its name says nothing.
#pragma once

#include "image/decoders.hpp"

#include <string_view>

namespace drapeau {

struct FileKind {
    std::string_view name;     // "a PNG picture"
    Decode* decode = nullptr;  // null: there is no decoder
};

FileKind file_kind(Bytes bytes);

}  // namespace drapeau

#include "io/encoding.hpp"

#include "io/text.hpp"

#include <algorithm>
#include <array>

namespace drapeau {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view remedy = "; save it as UTF-8";

/// Western letters are one byte and a zero: the zeros of UTF-16 stand in every other place.
bool looks_like_utf16(std::string_view bytes) {
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    const auto [fewer, more] = std::minmax(zeros[0], zeros[1]);
    return bytes.size() % 2 == 0 && fewer == 0 && more > 0 && 4 * more >= bytes.size();
}

bool is_text_byte(char c) {
    return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

std::string in_hex(unsigned char byte) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

}  // namespace

std::string encoding_fault(std::string_view bytes) {
    // Each mark is U+FEFF; that of UTF-32 begins as the one of UTF-16.
    if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv))
        return "UTF-32, not UTF-8" + std::string(remedy);
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") || looks_like_utf16(bytes))
        return "UTF-16, not UTF-8" + std::string(remedy);
    const std::size_t good = utf8_length(bytes);
    if (good == bytes.size() && bytes.find('\0') == std::string_view::npos) return {};
    if (!std::all_of(bytes.begin(), bytes.end(), is_text_byte)) return "not a text file";

    // Latin-1 has no characters from 0x80 to 0x9F; Windows puts some there.
    const bool latin1 = std::none_of(bytes.begin(), bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 && byte < 0xA0;
    });
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(good), '\n');
    return "not UTF-8, line " + std::to_string(line) + ": byte " + in_hex(static_cast<unsigned char>(bytes[good])) +
           ", probably " + (latin1 ? "Latin-1" : "Windows-1252") + std::string(remedy);
}

}  // namespace drapeau

#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

namespace drapeau {

namespace {

template <class Number>
std::string as_chars(Number value, auto... how) {
    std::array<char, 400> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, how...).ptr;
    return {buffer.data(), end};
}

/// Bytes of the UTF-8 character that begins at `at`; 0 if none does.
std::size_t character_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    if (first < 0xC2 || first > 0xF4) return 0;
    const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    // Overlong forms, surrogates and what lies beyond Unicode.
    const unsigned char second = byte(1);
    const bool impossible = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                            (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
    return impossible ? 0 : length;
}

/// The number of a character of two or three bytes.
unsigned code_point(std::string_view character) {
    unsigned code = static_cast<unsigned char>(character[0]) & (character.size() == 2 ? 0x1Fu : 0x0Fu);
    for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
    return code;
}

/// Control characters of the second set, line and paragraph separators, embeddings and overrides of direction.
bool is_invisible(unsigned code) {
    return (code >= 0x80 && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

bool is_control(unsigned char byte) {
    return byte < 0x20 || byte == 0x7F;
}

std::string in_hex(unsigned value, int digits) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string result;
    for (int place = 4 * (digits - 1); place >= 0; place -= 4) result += hex[value >> place & 15u];
    return result;
}

/// Insertions, deletions and substitutions that turn one word into the other (Levenshtein, row by row).
std::size_t typing_errors(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t substituted = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string shortest(double value) {
    // Numbers of everyday size stay free of exponents: 1000000 and 0.0001, not 1e+06 and 1e-04.
    if (value == 0.0) return "0";
    if (std::abs(value) >= 1e-5 && std::abs(value) < 1e15) return as_chars(value, std::chars_format::fixed);
    return as_chars(value);
}

std::string shortest(float value) {
    return as_chars(value);
}

std::string rounded(double value, int digits) {
    if (!std::isfinite(value)) return as_chars(value);
    if (value == 0.0) return "0";
    // Digits after the point such that `digits` are significant, the rounding up to the next power of ten included.
    const double magnitude =
        std::abs(value) + 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
    const int power = static_cast<int>(std::floor(std::log10(magnitude)));
    if (power < -6 || power > 15) return as_chars(value, std::chars_format::scientific, digits - 1);
    return as_chars(value, std::chars_format::fixed, std::max(0, digits - 1 - power));
}

std::string quantity(double value, std::string_view unit, int digits) {
    struct Prefix {
        const char* text;
        double factor;
    };
    constexpr Prefix prefixes[] = {{"G", 1e9},  {"M", 1e6},         {"k", 1e3}, {"", 1.0},
                                   {"m", 1e-3}, {"\xc2\xb5", 1e-6}, {"n", 1e-9}};
    const char* prefix = "";
    double factor = 1.0;
    if (std::isfinite(value) && value != 0.0) {
        // Half a unit in the last digit shown must not make "1000 ms" of 0.99999 s.
        const double size = std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -digits));
        const auto* fits = std::find_if(std::begin(prefixes), std::end(prefixes) - 1,
                                        [&](const Prefix& p) { return size >= p.factor; });
        prefix = fits->text, factor = fits->factor;
    }
    const double shown = value / factor;
    const int whole = std::abs(shown) >= 100.0 ? 3 : std::abs(shown) >= 10.0 ? 2 : 1;  // digits that must be there
    return fmt::format("{:.{}g} {}{}", shown, std::max(digits, whole), prefix, unit);
}

std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

std::optional<double> number_in(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string in_quotes(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (is_control(byte)) {
            result += "\\u00" + in_hex(byte, 2);
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text, at);
        const std::string_view character = text.substr(at, std::max<std::size_t>(length, 1));
        const auto byte = static_cast<unsigned char>(character[0]);
        if (const auto named = std::string_view("\n\t\r").find(character); named != std::string_view::npos) {
            result += std::array{"\\n", "\\t", "\\r"}[named];
        } else if (length == 0 || is_control(byte)) {
            result += "\\x" + in_hex(byte, 2);
        } else if ((length == 2 || length == 3) && is_invisible(code_point(character))) {
            result += "\\u" + in_hex(code_point(character), 4);
        } else {
            result += character;
        }
        at += character.size();
    }
    return result;
}

std::string one_line(std::string_view text, std::size_t longest) {
    // No text is shorter when printable, and a character has at most four bytes.
    std::string result = printable(text.substr(0, longest + 4));
    if (result.size() <= longest) return result;
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(result[cut]) & 0xC0) == 0x80) --cut;
    return result.substr(0, cut) + "...";
}

std::size_t utf8_length(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = character_length(text, at);
        if (length == 0) break;
        at += length;
    }
    return at;
}

bool is_utf8(std::string_view text) {
    return utf8_length(text) == text.size();
}

std::string capitalised(std::string_view text) {
    std::string capital(text);
    if (!capital.empty() && capital[0] >= 'a' && capital[0] <= 'z') capital[0] += 'A' - 'a';
    return capital;
}

std::string as_sentence(std::string_view text) {
    return capitalised(text) + (text.empty() || text.ends_with('.') ? "" : ".");
}

std::string_view without_space(std::string_view text) {
    constexpr std::string_view space = " \t\r\n";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

std::string memory_text(double bytes) {
    constexpr std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    while (bytes >= 1024.0 && unit + 1 < units.size()) {
        bytes /= 1024.0;
        ++unit;
    }
    return rounded(bytes, 2) + " " + units[unit];
}

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > 40) return std::nullopt;
    std::optional<std::string_view> best;
    // Two letters that changed places are two errors.
    const std::size_t most = word.size() < 4 ? 1 : std::max<std::size_t>(2, word.size() / 3);
    std::size_t fewest = most + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t errors = typing_errors(word, candidate);
        if (errors < fewest) {
            fewest = errors;
            best = candidate;
        }
    }
    return best;
}

std::string choices(std::span<const std::string_view> names) {
    std::string result;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) result += i + 1 == names.size() ? " or " : ", ";
        result += in_quotes(names[i]);
    }
    return result;
}

}  // namespace drapeau

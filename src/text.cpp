#include "text.hpp"

#include <cstdio>
#include <iterator>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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

/// Length of the UTF-8 sequence a byte begins; 0 if it begins none.
std::size_t sequence_length(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    if (first >= 0xF0 && first < 0xF5) return 4;
    return 0;
}

bool is_control(unsigned char byte) {
    return byte < 0x20 || byte == 0x7F;
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
    char text[40];
    const char* prefix = "";
    double factor = 1.0;
    if (std::isfinite(value) && value != 0.0) {
        // Half a unit in the last digit shown must not make "1000 ms" of 0.99999 s.
        const double size = std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -digits));
        const auto* fits = std::find_if(std::begin(prefixes), std::end(prefixes) - 1,
                                        [&](const Prefix& p) { return size >= p.factor; });
        prefix = fits->text, factor = fits->factor;
    }
    std::snprintf(text, sizeof text, "%.*g", digits, value / factor);
    return text + (" " + std::string(prefix)) + std::string(unit);
}

std::optional<double> number_in(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string in_quotes(std::string_view text) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (is_control(byte)) {
            result += "\\u00";
            result += hex[byte >> 4];
            result += hex[byte & 15];
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::string one_line(std::string_view text, std::size_t longest) {
    std::string result(text.substr(0, longest));
    for (char& c : result) {
        if (is_control(static_cast<unsigned char>(c))) c = '?';
    }
    if (text.size() <= longest) return result;
    // Never cut within a character.
    while (!result.empty() && !is_utf8(result) && result.size() + 4 > longest) result.pop_back();
    return result + "...";
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const std::size_t length = sequence_length(first);
        if (length == 0 || i + length > text.size()) return false;
        for (std::size_t j = 1; j < length; ++j) {
            if ((static_cast<unsigned char>(text[i + j]) & 0xC0) != 0x80) return false;
        }
        // Overlong forms, surrogates and what lies beyond Unicode.
        const auto second = length > 1 ? static_cast<unsigned char>(text[i + 1]) : 0;
        if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) || (first == 0xF0 && second < 0x90) ||
            (first == 0xF4 && second >= 0x90)) {
            return false;
        }
        i += length;
    }
    return true;
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

// Text as programs and people exchange it: numbers that read back to the same bits, one-line messages, the nearest
// name. Nothing here depends on the locale.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace drapeau {

/// The shortest decimal that reads back as the same number.
std::string shortest(double value);
std::string shortest(float value);

/// A number for a person, with that many significant digits and no exponent where it can be helped: "0.0123", "1350".
std::string rounded(double value, int digits);

/// A quantity for a person, in the multiple of its unit that suits its size: "84.1 ns", "201 µs", "86.2 kJ".
std::string quantity(double value, std::string_view unit, int digits = 3);

/// So many things: "1 point", "12 points".
std::string counted(std::size_t count, std::string_view thing);

/// The whole text as one finite number; nothing if it is not one.
std::optional<double> number_in(std::string_view text);

/// A TOML basic string, which is also a JSON string.
std::string in_quotes(std::string_view text);

/// The text with an escape ("\n", "\x1b", "\u2028") in place of whatever is no visible character: control characters,
/// line separators, marks that turn the direction of text, bytes that are no UTF-8.
std::string printable(std::string_view text);

/// The printable text, cut to so many bytes, for a part of a message that would be too long.
std::string one_line(std::string_view text, std::size_t longest = 120);

/// The text without the spaces, tabs and line breaks around it.
std::string_view without_space(std::string_view text);

/// The text with a capital letter in front; as a sentence, with a full stop behind too.
std::string capitalised(std::string_view text);
std::string as_sentence(std::string_view text);

/// How many bytes from the beginning are whole UTF-8 characters.
std::size_t utf8_length(std::string_view text);

bool is_utf8(std::string_view text);

/// Bytes for a person: "24 MiB".
std::string memory_text(double bytes);

/// The candidate that differs by the fewest typing errors, if it is close enough to be what was meant.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "a", "b" or "c"
std::string choices(std::span<const std::string_view> names);

}  // namespace drapeau

#include "slider_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace drapeau {

double share_of(double value, const SliderScale& scale) {
    const double within = std::clamp(value, scale.low, scale.high);
    if (!(scale.high > scale.low)) return 0.0;
    if (scale.logarithmic) return std::log(within / scale.low) / std::log(scale.high / scale.low);
    return (within - scale.low) / (scale.high - scale.low);
}

double value_at(double share, const SliderScale& scale) {
    if (share <= 0.0) return scale.low;
    if (share >= 1.0) return scale.high;
    const double value = scale.logarithmic ? scale.low * std::pow(scale.high / scale.low, share)
                                           : scale.low + share * (scale.high - scale.low);
    return scale.whole ? std::round(value) : value;
}

std::string number_text(double value, const std::string& format) {
    constexpr int longest_in_full = 6;    // digits before the point
    constexpr double most_rounded = 0.1;  // of the value; 0.4 % is not "0 %"
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, format.c_str(), value);
    std::string text = buffer;
    const std::size_t digits_end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
    if (std::abs(std::strtod(buffer, nullptr) - value) > most_rounded * std::abs(value))
        return fmt::format("{:.2g}", value) + text.substr(digits_end);
    if (digits_end == text.size() || text[digits_end] != 'e' || digits_end + 3 > text.size()) return text;
    char* end = nullptr;
    const long exponent = std::strtol(text.c_str() + digits_end + 1, &end, 10);
    const std::string unit = end;
    if (exponent >= 0 && exponent < longest_in_full) return fmt::format("{:.0f}", value) + unit;
    return text.substr(0, digits_end) + "e" + std::to_string(exponent) + unit;
}

std::string unit_of(const std::string& format) {
    const std::size_t end = format.find_first_of("efg");
    std::string unit = end == std::string::npos ? "" : format.substr(end + 1);
    if (unit.starts_with(' ')) unit.erase(0, 1);
    return unit == "%%" ? "%" : unit;
}

namespace {

struct Prefix {
    std::string_view sign;
    double factor;
};
constexpr Prefix prefixes[] = {{"", 1.0},   {"n", 1e-9}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6}, {"u", 1e-6},
                               {"m", 1e-3}, {"c", 1e-2}, {"k", 1e3},         {"M", 1e6},         {"G", 1e9}};

/// Spaces and dots of products are left out where units are typed.
std::string bare(std::string_view unit) {
    std::string bare;
    for (std::size_t i = 0; i < unit.size(); ++i)
        if (unit.substr(i).starts_with("\xc2\xb7"))
            ++i;
        else if (unit[i] != ' ')
            bare += unit[i];
    return bare;
}

/// A prefix is raised to the power of what it stands before.
bool takes_prefix(std::string_view unit) {
    const std::string_view squared = "\xc2\xb2", cubed = "\xc2\xb3";
    return !unit.empty() && std::isalpha(static_cast<unsigned char>(unit[0])) && !unit.substr(1).starts_with(squared) &&
           !unit.substr(1).starts_with(cubed);
}

/// How many of `unit` one of `other` is: 0.01 for "m" and "cm"; nothing where they differ by more than a prefix.
std::optional<double> conversion(std::string_view other, std::string_view unit) {
    if (other == unit) return 1.0;
    for (const Prefix& of_other : prefixes)
        for (const Prefix& of_unit : prefixes) {
            if (!other.starts_with(of_other.sign) || !unit.starts_with(of_unit.sign)) continue;
            const std::string_view rest = other.substr(of_other.sign.size());
            if (takes_prefix(rest) && rest == unit.substr(of_unit.sign.size())) return of_other.factor / of_unit.factor;
        }
    return {};
}

}  // namespace

std::optional<double> typed_number(std::string_view text, std::string_view unit) {
    const std::size_t begin = text.find_first_not_of(" +");
    if (begin == std::string_view::npos) return {};
    double value = 0.0;
    const char* end_of_text = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + begin, end_of_text, value);
    if (error != std::errc()) return {};
    const std::string of_text = bare({end, end_of_text});
    const auto factor = of_text.empty() ? std::optional(1.0) : conversion(of_text, bare(unit));
    if (!factor || !std::isfinite(value * *factor)) return {};
    return value * *factor;
}

}  // namespace drapeau

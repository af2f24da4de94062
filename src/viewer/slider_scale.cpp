#include "slider_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    constexpr int longest_in_full = 6;  // digits before the point
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, format.c_str(), value);
    std::string text = buffer;
    const std::size_t digits_end = text.find_first_not_of("+-.0123456789");
    if (digits_end == std::string::npos || text[digits_end] != 'e' || digits_end + 3 > text.size()) return text;
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

std::optional<double> typed_number(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" +");
    if (begin == std::string_view::npos) return {};
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    return value;
}

}  // namespace drapeau

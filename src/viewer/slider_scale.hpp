// SliderScale: what a slider's bar stands for, from end to end, and how its number is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drapeau {

struct SliderScale {
    double low = 0.0, high = 1.0;                 // in the unit shown
    bool logarithmic = false;                     // both ends are greater than zero then
    std::string format = "%.3g";                  // printf, with the unit
    double shown_per_unit = 1.0;                  // 1000 shows metres as millimetres
    bool whole = false;                           // the bar gives whole numbers
    std::optional<double> least{}, most{};        // that may be typed; absent: the bar's ends
    bool at_once = false;                         // a click sets, without waiting for whether it is the first of two
    const char* widest = "1.23e-5 N\xc2\xb7s/m";  // the number's column has room for this
};

/// Where on the bar a value lies, from 0 to 1.
double share_of(double value, const SliderScale& scale);
/// The value at a place on the bar; the ends are reached exactly.
double value_at(double share, const SliderScale& scale);

/// The number with its unit: no exponent below a million, and a short one otherwise.
std::string number_text(double value, const std::string& format);

/// The unit that follows the number: "N/m"; empty if there is none.
std::string unit_of(const std::string& format);

/// The number that was typed, in `unit`: "150 cm" is 1.5 in m. The text may leave the unit out or have another prefix
/// of it (n, µ, m, c, k, M or G); nothing where it is no finite number, or in another unit.
std::optional<double> typed_number(std::string_view text, std::string_view unit = "");

}  // namespace drapeau

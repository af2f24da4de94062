// Gnuplot: pictures drawn by the program gnuplot, with what they have in common: size, fonts, colours and markers.
#pragma once

#include "drapeau/methods/list.hpp"

#include <string>

namespace drapeau::lab {

/// Finds out before the work whether a picture can be made: throws InputError for an ending other than .svg and .png,
/// or if gnuplot does not start. "" asks for none.
void check_plot(const std::string& option, const std::string& file);

/// Lets gnuplot draw by `script` and puts the picture into the file, whole or not at all. Throws InputError.
void plot(const std::string& file, const std::string& script);

/// A text of a script: shown as it is, whatever is in it.
std::string plot_text(const std::string& text);

/// A number of a script.
std::string plot_number(double value);

/// How a method is drawn, by shape and by a colour of Okabe and Ito's palette, which the colour-blind tell apart too.
struct MethodStyle {
    const char* colour;
    int filled, hollow;  // point types
};
MethodStyle style_of(Method method);

/// Colours of what belongs to no method.
inline constexpr const char* plot_black = "#000000";
inline constexpr const char* plot_grey = "#777777";

}  // namespace drapeau::lab

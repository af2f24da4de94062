// Legends: what the colours and lengths of the picture mean, in words and numbers with units.
#pragma once

#include "app_state.hpp"
#include "colour_scale.hpp"

#include <array>
#include <string>
#include <vector>

namespace drapeau {

struct Legend {
    std::string title, short_title;
    std::array<std::string, 3> labels;     // at the lower end, in the middle and at the upper end
    bool fixed = false;                    // by the user; else the range follows the run
    const ColourScale* colours = nullptr;  // null: by the length of lines

    std::string range() const { return fixed ? "fixed" : "automatic"; }
    /// In one line, for the UI map.
    std::string text() const;
};

/// Of what is shown now, from left to right.
std::vector<Legend> legends(const AppState& app);

// What ends the scales now, fixed or automatic.

double force_end(const AppState& app);    // N
double stretch_end(const AppState& app);  // share
double speed_end(const AppState& app);    // m/s

}  // namespace drapeau

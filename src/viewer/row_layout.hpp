// Row layout: how a row of the panel is divided between a label, a control, its number and the arrow back.
#pragma once

namespace drapeau {

inline constexpr float label_share = 0.40f;  // of a row's width

// All in window units, of the window of ImGui that is drawn into.
float arrow_width();
float gap_to_number();  // from the bar
/// Of the column that numbers stand in.
float number_width(const char* widest);
/// Whether a row is too narrow for its label, a switch, a bar, the number and the arrow: the label has its own line.
bool stacks();
/// Where the values of readings begin: with the controls, or sooner in a panel that is narrow.
float reading_column();

}  // namespace drapeau

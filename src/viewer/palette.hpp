// Palette: actions, buttons, settings, choices of lists, scenes and flags found by a few letters of their names.
#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

struct Action;
struct AppState;

/// The box with a text to search for and what was found.
struct Palette {
    bool open = false;
    std::string text{};
    int chosen = 0;                  // of what was found
    const Action* wanted = nullptr;  // to be carried out, by whoever has the camera
    bool begins = true;              // it has not been drawn yet
};

/// A control that the panel scrolls to and frames for a moment.
struct Mark {
    std::string control;  // its label
    int page = -1;        // that has it; -1: it is always in sight
    double seconds_left = 2.0;
    bool scrolled = false;  // it is in sight
    int tries = 0;          // to scroll there: what has just grown is longer only in the next frame
    bool framed = true;
    bool presses = false;  // it is a button, and to be pressed

    /// Whether a label of the UI map is that of the control, or of one of several that make it up.
    bool means(std::string_view label) const;
};

struct PaletteItem {
    enum class Kind { action, setting, scene, image, choice };
    Kind kind = Kind::action;
    std::string label;   // "Columns"
    std::string detail;  // its key, or "flag.columns = 45"
    const Action* action = nullptr;
    Mark mark{};                            // of a setting
    std::string path{};                     // or name, of a scene or an image
    std::function<void(AppState&)> sets{};  // of a choice, or of what a button does
    std::string keywords{};                 // by which it is found too; else its detail's first word
    std::string about{};                    // whose words it is found by after all others
};

/// Everything that can be chosen now.
std::vector<PaletteItem> palette_items(const AppState& app);

/// How well a name fits what was typed: 0 does not. Every word of it must be found, whole at the beginning of a word
/// best, letters in their order with others between least. `beginnings`: at the beginnings of words alone.
int match_score(std::string_view name, std::string_view typed, bool beginnings = false);

/// The items that fit, the best first, else in their order.
std::vector<PaletteItem> matching(std::vector<PaletteItem> items, std::string_view typed);

/// Does the action, sets the choice, opens the scene or the image, or turns to the setting's control.
void choose(const PaletteItem& item, AppState& app);

}  // namespace drapeau

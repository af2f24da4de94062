// What the galleries list: the scenes that ship, each with its sentence and picture, and the images of a person's own.
#pragma once

#include "app_state.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

/// The first sentence of the comment that a scene file opens with, on one line; empty where there is none.
std::string opening_sentence(std::string_view scene_text);

/// Of every scene that ships, in the order of shipped_scenes(). What cannot be read is left out of a card.
std::vector<SceneCard> scene_cards();

/// Notes an image that was put on the flag, unless it ships: the newest first, a dozen at most.
void remember_image(AppState& app, const std::filesystem::path& file);

}  // namespace drapeau

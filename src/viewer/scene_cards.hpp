// What the scene gallery lists: the scenes that ship, each with its sentence and picture.
#pragma once

#include "thumbnail.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

/// The first sentence of the comment that a scene file opens with, on one line; empty where there is none.
std::string opening_sentence(std::string_view scene_text);

/// Of every scene that ships, in the order of shipped_scenes(). What cannot be read is left out of a card.
std::vector<SceneCard> scene_cards();

}  // namespace drapeau

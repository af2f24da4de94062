// Thumbnail: what a gallery shows of an image file. A panel says which ones are in sight; the viewer has them made.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace drapeau {

struct Thumbnail {
    bool wanted = false;         // in sight in this frame
    bool is_made = false;        // also if the image cannot be read: then there is no texture
    std::uintptr_t texture = 0;  // as ImGui takes it; 0: none yet, or never
    int width = 0, height = 0;   // pixels
};

/// What the gallery of scenes shows of a shipped scene.
struct SceneCard {
    std::string name;               // of its file, without the ending
    std::string summary;            // the sentence its file opens with; may be empty
    std::filesystem::path picture;  // empty: there is none
};

}  // namespace drapeau

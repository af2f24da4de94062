// ThumbnailTextures: small copies of images as textures for ImGui, made as they come into sight and kept.
#pragma once

#include "gl_objects.hpp"
#include "loader.hpp"
#include "thumbnail.hpp"

#include <map>
#include <vector>

namespace drapeau {

class ThumbnailTextures {
public:
    /// Asks `loader` for those wanted and takes what it has made, at most two in a frame unless `all`.
    void serve(std::map<std::filesystem::path, Thumbnail>& thumbnails, Loader& loader, bool all);

private:
    std::vector<GlTexture> textures_;
};

}  // namespace drapeau

// The flag itself: textured or plain, lit from both sides, and its shadow.
#pragma once

#include "flag_texture.hpp"
#include "grid_textures.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class ClothPass {
public:
    void draw(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const;
    void draw_shadow(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const;

private:
    Shader cloth_{"cloth"};
    Shader cut_out_{"cloth", "cloth_cut_out"};
    Shader shadow_{"cloth_shadow", "shadow"};
    Shader cut_out_shadow_{"cloth_shadow", "shadow_cut_out"};
};

}  // namespace drapeau

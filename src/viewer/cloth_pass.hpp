// The flag itself: textured or plain, lit from both sides, and its shadow.
#pragma once

#include "cloth_surface.hpp"
#include "flag_texture.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class ClothPass {
public:
    void draw(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const;
    /// Onto the ground.
    void draw_shadow(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const;
    /// Into the sun's map.
    void draw_towards_sun(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const;

private:
    Shader cloth_{"cloth"};
    Shader cut_out_{"cloth", "cloth_cut_out"};
    Shader shadow_{"cloth_shadow", "shadow"};
    Shader cut_out_shadow_{"cloth_shadow", "shadow_cut_out"};
    Shader sun_{"cloth_sun", "shadow"};
    Shader cut_out_sun_{"cloth_sun", "shadow_cut_out"};
};

}  // namespace drapeau

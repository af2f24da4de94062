// Renderer: draws a picture of the masses. It knows positions, rest lengths and stiffnesses to colour by, no physics.
#pragma once

#include "backdrop_pass.hpp"
#include "cloth_pass.hpp"
#include "cloth_surface.hpp"
#include "flag_texture.hpp"
#include "frame_block.hpp"
#include "grid_textures.hpp"
#include "line_pass.hpp"
#include "mass_pass.hpp"
#include "person_pass.hpp"
#include "picture.hpp"
#include "render_target.hpp"
#include "solid_pass.hpp"
#include "spring_pass.hpp"
#include "stretch_map.hpp"
#include "studio_pass.hpp"
#include "sun_map.hpp"

#include "run/simulation.hpp"

#include <optional>

namespace drapeau {

class Renderer {
public:
    Renderer();

    void upload(const Snapshot& snapshot);  // by the next drawing
    void upload_reference(const Snapshot& snapshot);
    /// Whether the image has holes.
    bool wear(std::optional<Image> image);

    /// Draws into the target, unless it holds this picture of these masses already.
    void draw(const Picture& picture, RenderTarget& target);
    /// Under a picture whose background is transparent, for the eye alone.
    void draw_checkerboard(float side) const { studio_.draw_checkerboard(side); }

private:
    void send(const FrameBlock& block);
    void draw_shadow(const Picture& picture);  // and the smooth surface
    void draw_scene(const Picture& picture);
    void draw_background(const Picture& picture) const;
    void draw_lines(const Picture& picture);  // and points

    GlBuffer block_;
    GridTextures grid_, reference_;
    ClothSurface surface_;
    ClothMesh mesh_;
    StretchMap stretch_;
    SunView sun_view_;
    SunMap sun_map_;
    FlagTexture texture_;
    ClothPass cloth_;
    SolidPass solids_;
    SpringPass springs_;
    MassPass masses_;
    LinePass lines_;
    PersonPass person_;
    BackdropPass backdrop_;
    StudioPass studio_;
    FieldBuffer<float> position_;  // the newest
    bool is_uploaded_ = true;      // it is
    long long shapes_ = 0;         // counts what was uploaded and worn
};

}  // namespace drapeau

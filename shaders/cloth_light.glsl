// The light that cloth of a colour gives, seen from either side.
#include "frame.glsl"
#include "light.glsl"
#include "image.glsl"
#include "sun_reach.glsl"
#include "cloth_sewn.glsl"
#include "cloth_stretch.glsl"

uniform float dimmed;  // 1: a dark backdrop for force colours

in vec3 to_eye;
in vec3 half_way;  // between the eye and the sun
in vec3 normal;
in vec2 texture_place;
in vec3 sun_place;

out vec4 shade;

const vec3 dark = vec3(0.035, 0.043, 0.058);

vec3 lit(vec3 color) {
    vec3 n = normalize(normal);
    if (!gl_FrontFacing) n = -n;
    Cloth cloth = sewn_cloth(color, texture_place);
    color = mix(cloth.color, dark + 0.06 * cloth.color, dimmed);
    if (by_stretch == 1) color = stretch_colour(texture_place);

    // Lit side, light that comes through from behind, and a sheen that runs along folds seen at a grazing angle.
    float facing = dot(n, sun.xyz), reach = sun_reach(sun_place);
    float facing_sun = max(0.0, facing);
    float through = max(0.0, -facing) / cloth.thickness;
    float seen = max(0.0, dot(n, to_eye));
    float graze = 1.0 - seen;
    float glint = max(0.0, dot(n, half_way));
    glint *= glint;
    glint *= glint;
    glint *= glint;
    glint *= glint;

    vec3 light = ambient(n) + sun_light * reach * (0.68 * facing_sun + 0.28 * through) + 0.08 * seen;
    vec3 sheen = sky_light * (0.012 + 0.16 * graze * graze) +
                 sun_light * reach * glint * step(0.0, facing) * mix(0.05, 0.7, cloth.brass);
    return color * light + sheen;
}

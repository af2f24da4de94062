#version 330 core
#include "cloth_light.glsl"

// How much of a pixel lies within the image's outline, where alpha is a half.
float within_outline(float alpha) { return clamp((alpha - 0.5) / max(fwidth(alpha), 1e-4) + 0.5, 0.0, 1.0); }

void main() {
    vec4 texel = texture(picture, texture_place);
    float cover = within_outline(texel.a);
    if (cover < 0.125) discard;  // half of a sample
    shade = vec4(lit(texel.rgb / max(texel.a, 0.125)), cover);
}

#version 330 core

uniform float opacity;

in vec3 tint;
in float across;
flat in float half_width;
flat in float presence;

out vec4 shade;

void main() {
    float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
    shade = vec4(tint, cover * opacity * presence);
}

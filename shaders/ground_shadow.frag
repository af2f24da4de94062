#version 330 core

uniform sampler2D shadow_map;

in vec2 place;

out vec4 shade;

const vec3 color = vec3(0.008, 0.020, 0.022);

// Two mipmap levels together: a core, and a soft edge around it.
void main() {
    float shadow = 0.5 * textureLod(shadow_map, place, 1.0).r + 0.5 * textureLod(shadow_map, place, 3.0).r;
    shade = vec4(color, 0.58 * shadow);
}

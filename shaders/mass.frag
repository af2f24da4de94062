#version 330 core

in vec2 within;
flat in float pixels;

out vec4 shade;

const vec3 body = vec3(0.95, 0.62, 0.10);
const vec3 rim = vec3(0.10, 0.05, 0.01);

void main() {
    float away = length(within);
    float cover = clamp(pixels + 0.5 - away, 0.0, 1.0);
    shade = vec4(mix(body, rim, smoothstep(0.55, 0.95, away / pixels)), cover);
}

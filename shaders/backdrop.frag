#version 330 core
#include "frame.glsl"

uniform sampler2D shadow_map;

in vec3 direction;

out vec4 shade;

const vec3 zenith = vec3(0.085, 0.235, 0.56);
const vec3 upper = vec3(0.25, 0.47, 0.80);
const vec3 horizon = vec3(0.74, 0.84, 0.92);
const vec3 below = vec3(0.62, 0.73, 0.84);
const vec3 grass = vec3(0.098, 0.158, 0.050);
const vec3 stone = vec3(0.42, 0.40, 0.37);

vec3 sky(vec3 d) {
    float height = max(0.0, d.y);
    vec3 color = mix(horizon, upper, smoothstep(0.0, 0.28, height));
    color = mix(color, zenith, smoothstep(0.2, 0.95, height));
    float sunward = max(0.0, dot(d, sun.xyz));
    return color + vec3(0.20, 0.16, 0.10) * sunward * sunward * sunward * sunward * sunward * sunward;
}

float shadow(vec2 at) {
    vec2 place = (at - shadow_area.xy) * shadow_area.zw;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)))) return 0.0;
    return 0.5 * textureLod(shadow_map, place, 1.2).r + 0.5 * textureLod(shadow_map, place, 2.6).r;
}

void main() {
    vec3 d = normalize(direction);
    if (d.y > -0.0005) {
        shade = vec4(sky(d), 1.0);
        return;
    }
    if (ground.y < 0.5) {
        shade = vec4(mix(horizon, below, smoothstep(0.0, 0.5, -d.y)), 1.0);
        return;
    }

    // A meadow, mown in broad bands, fading into the haze; a stone slab carries the pole.
    float away = (ground.x - eye.y) / d.y;
    vec2 at = eye.xz + away * d.xz;
    vec2 from_foot = at - vec2(ground.z, 0.0);
    float bands = smoothstep(-0.25, 0.25, sin(at.x * 2.6 + 0.25 * sin(at.y * 0.7))) - 0.5;
    float near = exp(-away * 0.03);
    vec3 color = grass * (1.0 + 0.16 * bands * near + 0.06 * sin(at.x * 0.9) * sin(at.y * 1.3) * near);
    float slab = length(from_foot);
    float edge = 0.75 * away / max(picture_size.y, 1.0) / max(0.05, -d.y);
    vec3 paved = stone * (1.0 + 0.12 * smoothstep(0.66 * ground.w - edge, 0.66 * ground.w + edge, slab));
    color = mix(paved, color, smoothstep(ground.w - edge, ground.w + edge, slab));
    color *= 1.55 - 0.95 * shadow(at);
    shade = vec4(mix(horizon, color, exp(-away * 0.016)), 1.0);
}

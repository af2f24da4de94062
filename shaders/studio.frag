#version 330 core
#include "frame.glsl"

in vec3 ray;

out vec4 shade;

const vec3 seam = vec3(0.43, 0.45, 0.48);      // where wall and floor pass into each other
const vec3 high = vec3(0.13, 0.15, 0.18);      // the wall far up
const vec3 lit_floor = vec3(0.66, 0.67, 0.68);  // around the flag's foot

// A gradient as gentle as this one shows the steps of eight bits; a little noise hides them.
float noise(vec2 at) { return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))) - 0.5; }

void main() {
    vec3 d = normalize(ray);
    vec3 light = mix(seam, high, smoothstep(0.0, 0.75, d.y));
    if (ground.y > 0.5 && d.y < 0.0) {
        vec3 foot = vec3(ground.z, ground.x, 0.0);
        vec3 place = eye.xyz + d * ((ground.x - eye.y) / d.y);
        float away = distance(place, foot) / max(distance(eye.xyz, foot), 0.1);
        light = mix(seam, lit_floor, exp(-1.6 * away * away));
    }
    shade = vec4(light * (1.0 + 0.012 * noise(gl_FragCoord.xy)), 1.0);
}

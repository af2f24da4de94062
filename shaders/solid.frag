#version 330 core
#include "frame.glsl"
#include "light.glsl"
#include "sun_reach.glsl"

uniform vec3 color;

in vec3 place;
in vec3 normal;
in vec3 sun_place;

out vec4 shade;

void main() {
    vec3 n = normalize(normal);
    vec3 to_eye = normalize(eye.xyz - place);
    float reach = sun_reach(sun_place);
    vec3 mirrored = reflect(-to_eye, n);
    float glint = reach * pow(max(0.0, dot(mirrored, sun.xyz)), 40.0);
    vec3 light = ambient(n) + sun_light * reach * max(0.0, dot(n, sun.xyz));
    vec3 sky = mix(ground_light, sky_light, smoothstep(-0.3, 0.5, mirrored.y));
    shade = vec4(color * (0.65 * light + 0.9 * sky) + sun_light * 0.6 * glint, 1.0);
}

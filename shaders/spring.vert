#version 330 core
#include "frame.glsl"
#include "grid.glsl"
#include "image.glsl"
#include "colour_scale.glsl"

uniform ivec2 offset;     // columns and rows from a spring's one end to the other
uniform int per_row;      // springs of this kind in a row
uniform float rest;       // L, m
uniform float stiffness;  // k, N/m
uniform float width;      // at most, in units of line width
uniform float lift;       // m towards the eye, so that the cloth does not hide its own springs
uniform int by_force;
uniform float force_scale;  // N
uniform float slack_presence;
uniform vec3 color;
uniform int on_picture;   // 1: light on dark parts of the picture and dark on light ones
uniform ivec2 grid;       // columns, rows
uniform float casing;     // a dark line on either side, in units of line width

out vec3 tint;
out float across;  // pixels from the line's middle
out float length_share;  // 0 at the one end, 1 at the other
flat out float half_width;
flat out float presence;  // slack springs before dark cloth stand back, so that those that pull stand out

const vec3 dark = vec3(0.012, 0.015, 0.022);
const vec3 light = vec3(0.93, 0.92, 0.88);
const float thinnest = 0.8;       // in units of line width
const float share_of_cell = 0.15; // a line's width at most, so that small cells stay open
const float coarse = 2.0;         // mipmap level at which the picture's brightness is looked up

vec3 contrast(vec2 mass) {
    vec3 below = on_cloth(textureLod(picture, mass / vec2(max(grid - 1, ivec2(1))), coarse));
    return dot(below, vec3(0.2126, 0.7152, 0.0722)) > 0.18 ? dark : light;
}

vec4 lifted(vec3 point) { return to_clip * vec4(point + lift * normalize(eye.xyz - point), 1.0); }

void main() {
    ivec2 mass = ivec2(gl_InstanceID % per_row + max(0, -offset.x), gl_InstanceID / per_row);
    vec3 a = position(mass);
    vec3 b = position(mass + offset);

    // |k (l - L)|
    float force = abs(stiffness * (distance(a, b) - rest));
    float share = clamp(force / force_scale, 0.0, 1.0);
    tint = by_force == 1 ? colour_at(share) : color;
    presence = by_force == 1 ? mix(slack_presence, 1.0, sqrt(share)) : 1.0;
    if (on_picture == 1) tint = contrast(vec2(mass) + 0.5 * vec2(offset));

    vec4 ends[2] = vec4[2](lifted(a), lifted(b));
    if (ends[0].w < 1e-3 || ends[1].w < 1e-3) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // behind the eye
        return;
    }
    vec2 half_size = 0.5 * picture_size.xy;
    vec2 along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * half_size;
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1.0, 0.0);

    float pixels_per_metre = length(vec3(to_clip[0][1], to_clip[1][1], to_clip[2][1])) * half_size.y / ends[0].w;
    half_width = 0.5 * clamp(share_of_cell * rest * pixels_per_metre, thinnest * picture_size.z, width * picture_size.z);
    float side = float(gl_VertexID % 2) * 2.0 - 1.0;
    across = side * (half_width + casing * picture_size.z + 1.0);
    length_share = float(gl_VertexID / 2);
    gl_Position = ends[gl_VertexID / 2];
    gl_Position.xy += vec2(-along.y, along.x) * across / half_size * gl_Position.w;
}

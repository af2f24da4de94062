#version 330 core
#include "frame.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float strength;

uniform vec2 widths;     // at both ends, in units of line width
uniform vec2 opacities;
uniform float casing;    // a dark line on either side, in units of line width
uniform float lift;      // m towards the eye

out float across;  // pixels from the line's middle
out float half_width;
out float presence;

vec4 lifted(vec3 point) { return to_clip * vec4(point + lift * normalize(eye.xyz - point), 1.0); }

void main() {
    vec4 ends[2] = vec4[2](lifted(from), lifted(to));
    if (ends[0].w < 1e-3 || ends[1].w < 1e-3) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // behind the eye
        return;
    }
    vec2 half_size = 0.5 * picture_size.xy;
    vec2 along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * half_size;
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1.0, 0.0);

    int end = gl_VertexID / 2;
    half_width = 0.5 * widths[end] * picture_size.z;
    presence = opacities[end] * strength;
    float side = float(gl_VertexID % 2) * 2.0 - 1.0;
    across = side * (half_width + casing * picture_size.z + 1.0);
    gl_Position = ends[end];
    gl_Position.xy += vec2(-along.y, along.x) * across / half_size * gl_Position.w;
}

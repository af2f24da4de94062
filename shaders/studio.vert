#version 330 core
#include "frame.glsl"

out vec3 ray;  // from the eye

// One triangle over the whole picture, behind everything.
void main() {
    vec2 place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 far = to_world * vec4(place, 1.0, 1.0);
    ray = far.xyz / far.w - eye.xyz;
    gl_Position = vec4(place, 1.0, 1.0);
}

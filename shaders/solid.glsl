// A rod between two points, or a ball, as a strip of facets made from the vertex number alone.
uniform int ball;
uniform vec3 from, to;
uniform float radius;

const float around = 28.0;
const float rings = 14.0;
const float pi = 3.14159265;

vec3 solid_normal;

vec3 solid_place() {
    float turn = 2.0 * pi * float(gl_VertexID / 2) / around;
    float far_end = float(gl_VertexID % 2);
    if (ball == 1) {
        float tilt = pi * (float(gl_InstanceID) + far_end) / rings;
        solid_normal = vec3(sin(tilt) * cos(turn), cos(tilt), sin(tilt) * sin(turn));
        return from + radius * solid_normal;
    }
    vec3 axis = normalize(to - from);
    vec3 side = normalize(cross(axis, abs(axis.y) > 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0)));
    solid_normal = side * cos(turn) + cross(axis, side) * sin(turn);
    return mix(from, to, far_end) + radius * solid_normal;
}

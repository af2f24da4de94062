const float degenerate = 1e-14;  // m2; where the cloth has no extent it has no normal of its own

// The normal of a surface with these tangents along the fly and up the hoist; +z for the flag at rest.
vec3 whole_normal(vec3 along, vec3 up) {
    vec3 normal = cross(along, up);
    float size = length(normal);
    return size > degenerate ? normal / size : vec3(0.0, 0.0, 1.0);
}

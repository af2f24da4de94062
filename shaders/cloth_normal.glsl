// The cloth's normal at a mass, from the neighbours on both sides (one-sided at borders); +z for the flag at rest.
const float degenerate = 1e-14;  // m2; masses on top of each other have no normal of their own

vec3 cloth_normal(ivec2 mass, ivec2 grid) {
    vec3 along = position(ivec2(min(mass.x + 1, grid.x - 1), mass.y)) - position(ivec2(max(mass.x - 1, 0), mass.y));
    vec3 up = position(ivec2(mass.x, max(mass.y - 1, 0))) - position(ivec2(mass.x, min(mass.y + 1, grid.y - 1)));
    vec3 normal = cross(along, up);
    float size = length(normal);
    return size > degenerate ? normal / size : vec3(0.0, 0.0, 1.0);
}

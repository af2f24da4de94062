// A point of the cloth's mesh: a mass, or a point of the smooth surface through them (ClothSurface).
#include "grid.glsl"
#include "cloth_normal.glsl"

uniform ivec2 points;  // columns and rows of the mesh
uniform int smooth_surface;
uniform sampler2D surface_place, surface_normal;

ivec2 point_number() { return ivec2(gl_VertexID % points.x, gl_VertexID / points.x); }
vec3 point_place(ivec2 at) { return smooth_surface == 1 ? texelFetch(surface_place, at, 0).xyz : position(at); }
vec3 point_normal(ivec2 at) {
    return smooth_surface == 1 ? texelFetch(surface_normal, at, 0).xyz : cloth_normal(at, points);
}
vec2 place_on_texture(ivec2 at) { return vec2(at) / vec2(max(points - 1, ivec2(1))); }

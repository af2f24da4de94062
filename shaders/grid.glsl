// The masses: (column, row) is a texel of three single-channel textures, the simulation's own arrays.
uniform sampler2D position_x, position_y, position_z;

vec3 position(ivec2 mass) {
    return vec3(texelFetch(position_x, mass, 0).r, texelFetch(position_y, mass, 0).r, texelFetch(position_z, mass, 0).r);
}

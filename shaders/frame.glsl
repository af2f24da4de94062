// The constants of this frame, the same for every shader.
layout(std140) uniform Frame {
    mat4 to_clip;
    mat4 to_world;
    vec4 eye;
    vec4 sun;      // towards the sun
    vec4 picture_size;  // width and height in pixels, pixels per unit of line width
    vec4 ground;   // height, 1 if there is ground
    vec4 shadow_area;   // x, z of the shadow texture's corner on the ground and 1 / its sides
    mat4 to_sun_map;
    vec4 sun_pixel;     // of the sun's map: in m, and as a share of its side
};

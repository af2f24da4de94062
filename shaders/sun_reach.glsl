// How much of the sun reaches a place of its map: several looks, each at the four pixels around it, soften the edge.
uniform sampler2DShadow sun_map;

const vec2 looks[8] = vec2[8](vec2(0.7, 1.1), vec2(-0.7, -1.1), vec2(-1.9, 0.7), vec2(1.9, -0.7),
                              vec2(0.5, 2.9), vec2(-0.5, -2.9), vec2(2.6, 1.5), vec2(-2.6, -1.5));

float sun_reach(vec3 place) {
    float reach = 0.0;
    int count = int(sun_pixel.z);
    for (int i = 0; i < count; ++i) reach += texture(sun_map, vec3(place.xy + sun_pixel.y * looks[i], place.z));
    return reach / sun_pixel.z;
}

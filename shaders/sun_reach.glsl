// How much of the sun reaches a place of its map. Several looks, each at the four pixels around it, soften the edge; a
// processor that draws the picture by itself has time for one.
uniform sampler2DShadow sun_map;

const vec2 looks[8] = vec2[8](vec2(0.7, 1.1), vec2(-0.7, -1.1), vec2(-1.9, 0.7), vec2(1.9, -0.7),
                              vec2(0.5, 2.9), vec2(-0.5, -2.9), vec2(2.6, 1.5), vec2(-2.6, -1.5));

float sun_reach(vec3 place) {
#if DRAWN_BY_PROCESSOR
    return texture(sun_map, place);
#else
    float reach = 0.0;
    for (int i = 0; i < 8; ++i) reach += texture(sun_map, vec3(place.xy + sun_pixel.y * looks[i], place.z));
    return reach / 8.0;
#endif
}

// How much of the sun reaches a place of its map: four looks, each at the four pixels around it, soften the edge.
uniform sampler2DShadow sun_map;

float sun_reach(vec3 place) {
    vec2 a = sun_pixel.y * vec2(0.7, 1.9), b = sun_pixel.y * vec2(-1.9, 0.7);
    return 0.25 * (texture(sun_map, vec3(place.xy + a, place.z)) + texture(sun_map, vec3(place.xy + b, place.z)) +
                   texture(sun_map, vec3(place.xy - a, place.z)) + texture(sun_map, vec3(place.xy - b, place.z)));
}

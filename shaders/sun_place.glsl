// The place in the sun's map of a point with this normal, a little towards the sun, so that what it belongs to does not
// shade itself. Either side of cloth may be lit.
#if DRAWN_BY_PROCESSOR
const float pixels_off = 2.0;
#else
const float pixels_off = 4.0;  // as many as the looks reach
#endif

vec3 sun_place_of(vec3 point, vec3 normal) {
    float facing = dot(normal, sun.xyz);
    vec3 off = pixels_off * sun_pixel.x * (normal * (facing < 0.0 ? -1.0 : 1.0) + 0.5 * sun.xyz);
    return 0.5 + 0.5 * (to_sun_map * vec4(point + off, 1.0)).xyz;
}

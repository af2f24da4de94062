// A colour scale: 33 colours in linear light at equal distances (src/viewer/colour_scale.hpp).
uniform vec3 scale_colours[33];

vec3 colour_at(float share) {
    float at = clamp(share, 0.0, 1.0) * 32.0;
    int below = min(int(at), 31);
    return mix(scale_colours[below], scale_colours[below + 1], at - float(below));
}

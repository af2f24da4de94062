// A line of a colour between two dark ones, so that it can be read on light ground too.
const vec3 casing_colour = vec3(0.012, 0.015, 0.022);
const float casing_opacity = 0.7;

// `away`, `half_width`, `casing`: in pixels from the line's middle.
vec4 cased(vec3 color, float away, float half_width, float casing, float opacity) {
    float core = clamp(half_width + 0.5 - away, 0.0, 1.0);
    float around = casing > 0.0 ? casing_opacity * clamp(half_width + casing + 0.5 - away, 0.0, 1.0) : 0.0;
    float cover = core + (1.0 - core) * around;
    return vec4(mix(casing_colour, color, core / max(cover, 1e-4)), cover * opacity);
}

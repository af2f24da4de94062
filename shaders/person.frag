#version 330 core

in vec2 place;

out vec4 shade;

const vec3 slate = vec3(0.060, 0.080, 0.105);
const float blend = 0.035;  // m, how softly parts of the body join

// Distance (m) from a limb that is thicker at one end than at the other.
float limb(vec2 at, vec2 from, vec2 to, float thick, float thin) {
    vec2 along = to - from;
    float share = clamp(dot(at - from, along) / dot(along, along), 0.0, 1.0);
    return distance(at, from + share * along) - mix(thick, thin, share);
}

float joined(float a, float b) {
    float near = max(blend - abs(a - b), 0.0) / blend;
    return min(a, b) - 0.25 * near * near * blend;
}

void main() {
    vec2 at = vec2(abs(place.x), place.y);  // both halves are alike
    float body = limb(at, vec2(0.0, 1.36), vec2(0.0, 0.98), 0.150, 0.130);
    body = joined(body, limb(at, vec2(0.0, 1.385), vec2(0.155, 1.37), 0.070, 0.062));
    body = joined(body, limb(at, vec2(0.0, 1.40), vec2(0.0, 1.56), 0.062, 0.048));
    body = joined(body, limb(at, vec2(0.078, 0.94), vec2(0.098, 0.05), 0.085, 0.045));
    float arm = joined(body, limb(at, vec2(0.185, 1.37), vec2(0.265, 0.84), 0.050, 0.034));
    float head = limb(at, vec2(0.0, 1.645), vec2(0.0, 1.61), 0.105, 0.095);
    float away = min(arm, joined(head, body));
    float cover = clamp(0.5 - away / max(fwidth(place.y), 1e-6), 0.0, 1.0);
    if (cover < 0.125) discard;  // half of a sample
    shade = vec4(slate, cover);
}

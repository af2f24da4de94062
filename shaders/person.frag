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
    float body = limb(at, vec2(0.0, 1.36), vec2(0.0, 0.98), 0.128, 0.112);
    body = joined(body, limb(at, vec2(0.0, 1.385), vec2(0.150, 1.37), 0.066, 0.056));
    body = joined(body, limb(at, vec2(0.0, 1.40), vec2(0.0, 1.56), 0.062, 0.048));
    body = joined(body, limb(at, vec2(0.068, 0.94), vec2(0.088, 0.05), 0.076, 0.042));
    float arm = joined(body, limb(at, vec2(0.165, 1.36), vec2(0.235, 0.84), 0.044, 0.030));
    float head = limb(at, vec2(0.0, 1.645), vec2(0.0, 1.60), 0.100, 0.088);
    float away = min(arm, joined(head, body));
    float cover = clamp(0.5 - away / max(fwidth(place.y), 1e-6), 0.0, 1.0);
    if (cover < 0.125) discard;  // half of a sample
    shade = vec4(slate, cover);
}

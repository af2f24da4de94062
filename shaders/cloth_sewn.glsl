// What is sewn on cloth: a hem along its edges, a white tape at the hoist with a brass grommet at either end; and the
// threads themselves, seen close up only.
uniform vec2 cloth_size;  // m
uniform int sewn;         // 1: a hem; 2: a tape at the hoist too

struct Cloth {
    vec3 color;
    float thickness;  // in layers
    float brass;      // 1: metal
};

const vec3 canvas = vec3(0.78, 0.77, 0.72);
const vec3 brass = vec3(0.72, 0.50, 0.16);
const vec3 hole = vec3(0.02);
const float hem_share = 0.011;     // of the longer side
const float tape_share = 0.030;
const float thread = 0.0016;       // m
const float stitch = 0.0016, stitch_length = 0.010;  // m

// How much of a pixel of this width lies where `inside` (m) is positive.
float cover(float inside, float pixel) { return clamp(0.5 + inside / pixel, 0.0, 1.0); }

float seam(float away, float along, float pixel) {
    float dash = mix(cover(0.3 * stitch_length - abs(fract(along / stitch_length) - 0.5) * stitch_length, pixel), 0.6,
                     clamp(pixel / stitch_length, 0.0, 1.0));
    return dash * cover(0.5 * stitch - abs(away), pixel) * min(1.0, 1.6 * stitch / pixel);
}

Cloth sewn_cloth(vec3 color, vec2 share) {
    vec2 at = share * cloth_size, from_edges = min(at, cloth_size - at);  // m
    vec2 across = fwidth(at);
    float pixel = max(max(across.x, across.y), 1e-6), size = max(cloth_size.x, cloth_size.y);
    Cloth cloth = Cloth(color, 1.0, 0.0);

    float weave = clamp(1.5 - 4.0 * pixel / thread, 0.0, 1.0);
    vec2 threads = sin(3.14159265 / thread * at);
    cloth.color *= 1.0 + 0.16 * weave * (threads.x * threads.y - 0.4 * max(abs(threads.x), abs(threads.y)));
    if (sewn == 0) return cloth;

    float hem = hem_share * size, edge = min(from_edges.x, from_edges.y);
    float doubled = cover(hem - edge, pixel);
    cloth.thickness += doubled;
    cloth.color *= 1.0 - 0.10 * doubled - 0.30 * seam(edge - 0.8 * hem, from_edges.x < from_edges.y ? at.y : at.x, pixel);
    if (sewn == 1) return cloth;

    float tape = tape_share * size, taped = cover(tape - at.x, pixel);
    cloth.color = mix(cloth.color, canvas * (1.0 - 0.35 * seam(at.x - 0.9 * tape, at.y, pixel)), taped);
    cloth.thickness += 2.0 * taped;
    float away = distance(vec2(at.x, from_edges.y), vec2(0.5 * tape, 0.75 * tape));
    cloth.brass = cover(0.34 * tape - away, pixel);
    cloth.color = mix(cloth.color, mix(brass, hole, cover(0.17 * tape - away, pixel)), cloth.brass);
    return cloth;
}

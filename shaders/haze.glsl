// What distance turns into.
const vec3 horizon = vec3(0.74, 0.84, 0.92);

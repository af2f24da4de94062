// Daylight: a warm sun, a blue sky, light thrown back by the ground, and a weak fill from the viewer's side.
const vec3 sun_light = vec3(1.02, 0.97, 0.88);
const vec3 sky_light = vec3(0.30, 0.36, 0.46);
const vec3 ground_light = vec3(0.17, 0.17, 0.14);

vec3 ambient(vec3 normal) { return mix(ground_light, sky_light, 0.5 + 0.5 * normal.y); }

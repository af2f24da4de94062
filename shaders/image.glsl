// The image on the flag: light already multiplied by alpha, and alpha.
uniform sampler2D picture;

const vec3 undyed = vec3(0.83);  // cloth that shows where the image is transparent

vec3 on_cloth(vec4 texel) { return texel.rgb + (1.0 - texel.a) * undyed; }

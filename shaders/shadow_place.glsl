// Where a point's shadow falls, as a place in the shadow texture (clip coordinates).
vec4 shadow_place(vec3 point) {
    vec3 foot = point - sun.xyz * ((point.y - ground.x) / sun.y);
    return vec4((foot.xz - shadow_area.xy) * shadow_area.zw * 2.0 - 1.0, 0.0, 1.0);
}

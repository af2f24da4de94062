#include <drapeau/drapeau.hpp>

#include <cstdio>

int main() {
    using namespace drapeau;

    // 1.5 m x 1 m of 45 x 30 masses of 0.1 g, held along the hoist, in a gusty wind.
    Flag<float, StructuralSprings, DiagonalSprings, SpringDamping, Gravity, AirDrag, UniformWind> flag(
        spread(45, 30, 1.5, 1.0), Attach::hoist, 1e-4, StructuralSprings{.k = 200}, DiagonalSprings{.k = 100},
        SpringDamping{.c = 0.002}, Gravity{}, AirDrag{.d = 6e-4},
        UniformWind{{.mean = {6, 0, 1}, .gusts = {2, 0.5, 2}, .period = 1.5, .seed = 1}});

    const double dt = 0.9 * flag.largest_stable_step(SemiImplicitEuler{});
    for (int frame = 0; frame < 60; ++frame) flag.advance(SemiImplicitEuler{}, dt, std::lround(1.0 / 60 / dt));

    const auto tip = flag.cloth().position(44, 15);
    std::printf("after %.2f s the fly end is at (%.2f, %.2f, %.2f) m; greatest stretch %.1f %%\n", flag.time(), tip.x,
                tip.y, tip.z, 100 * flag.energy().greatest_stretch);
}

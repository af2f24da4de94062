#include <drapeau/drapeau.hpp>

#include <cstdio>

int main() {
    using namespace drapeau;

    // 1.5 m x 1 m of 45 x 30 masses of 0.1 g, held along the hoist, in gusts that run along the flag.
    Flag<float, Leapfrog, DiagonalSprings, SpringDamping, Gravity, AirDrag, Wind> flag(
        spread(45, 30, 1.5, 1.0), Attach::hoist, {.mass = 1e-4, .stiffness = 200}, DiagonalSprings{.k = 100},
        SpringDamping{.c = 0.002}, Gravity{}, AirDrag{.d = 6e-4},
        Wind{.velocity = {6, 0, 1}, .gusts = {2, 0.5, 2}, .travelling = true});
    flag.use_threads(2);  // the result is the same for any number

    for (int frame = 0; frame < 60; ++frame) flag.advance_batches(1);  // 1/60 s each, at a step that is stable

    const auto tip = flag.position(44, 15);
    std::printf("after %.2f s the fly end is at (%.2f, %.2f, %.2f) m; greatest stretch %.1f %%\n", flag.time(), tip.x,
                tip.y, tip.z, 100 * flag.measure().max_stretch);

    flag.set(Wind{.velocity = {0, 0, 9}});  // strengths change as it flies
    flag.advance_batches(60);
    std::printf("after %.2f s, in a wind from behind, at z = %.2f m\n", flag.time(), flag.position(44, 15).z);
}

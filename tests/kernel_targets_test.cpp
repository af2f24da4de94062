#include "catch.hpp"

#include "error.hpp"
#include "kernels/kernels.hpp"
#include "run/simulation.hpp"

#include <cmath>
#include <cstdlib>

using namespace drapeau;

namespace {

/// Sets DRAPEAU_TARGET for as long as it lives.
struct ForcedTarget {
    explicit ForcedTarget(const std::string& name) { setenv("DRAPEAU_TARGET", name.c_str(), 1); }
    ~ForcedTarget() { unsetenv("DRAPEAU_TARGET"); }
};

Scene small_flag(Precision precision) {
    Scene scene;
    scene.flag.columns = 19;  // no multiple of any register
    scene.flag.rows = 13;
    scene.flag.width = 0.6;
    scene.flag.height = 0.4;
    scene.springs.diagonal_stiffness = 100.0;
    scene.springs.damping = 0.002;
    scene.springs.drag = 6e-4;
    scene.gravity = GravitySettings{};
    scene.wind = WindSettings{.velocity = {6.0, 0.0, 1.0}, .gusts = {2.0, 0.5, 2.0}};
    scene.time.precision = precision;
    return scene;
}

std::vector<double> flown(const Scene& scene, int batches) {
    Simulation simulation(scene);
    for (int n = 0; n < batches; ++n) REQUIRE_FALSE(simulation.advance_batch());
    return simulation.state();
}

double greatest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double most = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
    return most;
}

}  // namespace

TEST_CASE("every instruction set computes the same motion") {
    // 6 batches are 0.1 s and some 230 steps, too few for the flag to forget its start: rounding grows with the number
    // of steps, one unit in the last place of a speed of about 3 m/s each (2^-52 * 3), stiff springs spread it over a
    // few masses. 1e-11 m leaves a factor of some fifty; a wrong lane or a missed spring shows at 1e-3.
    const auto expected = flown(small_flag(Precision::double_precision), 6);
    REQUIRE_FALSE(kernel_targets().empty());
    for (const auto& name : kernel_targets()) {
        const ForcedTarget forced(name);
        INFO(name);
        REQUIRE(kernel_target() == name);
        CHECK(greatest_difference(flown(small_flag(Precision::double_precision), 6), expected) < 1e-11);
        // The same argument in float: 2^-24 * 3 m/s * 230 steps is 4e-5.
        CHECK(greatest_difference(flown(small_flag(Precision::single_precision), 6), expected) < 2e-3);
    }
}

TEST_CASE("an instruction set that is not there is refused by name") {
    const ForcedTarget forced("x86-64-v99");
    try {
        kernel_target();
        FAIL("it was accepted");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("x86-64-v99") != std::string::npos);
        CHECK(std::string(error.what()).find(kernel_targets().front()) != std::string::npos);
    }
}

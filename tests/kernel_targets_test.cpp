#include "catch.hpp"

#include "io/error.hpp"
#include "kernels/kernels.hpp"
#include "physics_sheet.hpp"

#include <cstdlib>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

/// Sets DRAPEAU_TARGET for as long as it lives.
struct ForcedTarget {
    explicit ForcedTarget(const std::string& name) { setenv("DRAPEAU_TARGET", name.c_str(), 1); }
    ~ForcedTarget() { unsetenv("DRAPEAU_TARGET"); }
};

/// A small flag, its width no multiple of any register, after 230 steps in the wind: 0.1 s, in which it does not
/// forget its start.
template <class Real>
Points flown(Method method, const Springs& springs) {
    const Model model(
        spread(19, 13, 0.6, 0.4), springs, Attach::hoist,
        Terms().add(Gravity{}).add(AirDrag{6e-4}).add(Wind{{6.0, 0.0, 1.0}, {2.0, 0.5, 2.0}, 1.5, true, 1}));
    Stepper<Real> stepper(model, find_kernels<Real>(method, model.has_diagonals(), model.is_damped()));
    const Clock clock{0.0, 0, 0.1 / 230};
    stepper.advance(clock, 0, 230);
    return points_of(stepper.position());
}

}  // namespace

TEST_CASE("every instruction set computes the same motion with every method") {
    REQUIRE_FALSE(kernel_targets().empty());
    for (const auto& springs : all_springs(1e-4, 200.0, 100.0, 0.002))
        for (std::size_t n = 0; n < method_count; ++n) {
            const auto method = static_cast<Method>(n);
            // Rounding grows with the number of steps, one unit in the last place of a speed of about 3 m/s each
            // (2^-52 * 3), stiff springs spread it over a few masses. 1e-11 m leaves a factor of some fifty; a wrong
            // lane or a missed spring shows at 1e-3. Forward Euler multiplies errors as it does everything: it is
            // compared for being finite or not.
            const auto expected = flown<double>(method, springs);
            if (!std::isfinite(root_mean_square(expected))) continue;
            const bool grows = method == method_id<ForwardEuler>;
            for (const auto& name : kernel_targets()) {
                const ForcedTarget forced(name);
                INFO(name << ", method " << n);
                REQUIRE(kernel_target() == name);
                if (grows) continue;
                CHECK(distance(flown<double>(method, springs), expected) < 1e-11);
                // The same argument in float: 2^-24 * 3 m/s * 230 steps is 4e-5.
                CHECK(distance(flown<float>(method, springs), expected) < 2e-3);
            }
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

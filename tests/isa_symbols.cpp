// What is compiled for two instruction sets, to see that the two share no symbols of the core: a flag for who embeds
// it, and kernels as the programs compile them.
#include "drapeau/drapeau.hpp"

using namespace drapeau;

// Both objects have to be able to stand in one program, so their own entries have names of their own.
double DRAPEAU_ENTRY(float wind);
double DRAPEAU_ENTRY(float wind) {
    Flag<float, Leapfrog, SpringDamping, Gravity, AirDrag, Wind, StretchLimit> flag(
        spread(5, 4, 0.4, 0.3), Attach::hoist, {}, SpringDamping{0.002}, Gravity{}, AirDrag{6e-4},
        Wind{.velocity = {wind, 0.0, 1.0}, .travelling = true}, StretchLimit{0.1});
    flag.use_threads(2);
    flag.advance_batches(1);
    static constexpr Kernels<double> kernels = kernels_of<Vector<double>, SemiImplicitEuler, true, true>();
    Stepper<double> stepper(flag.model(), kernels);
    stepper.set(crumpled_start(flag.model(), 0.0, 1));
    Ledger ledger;
    ledger.open(0.0, stepper.measure(0.0).total(), 0.0);
    return flag.position(4, 3).x + ledger.created_share() + automatic_share(flag.model());
}

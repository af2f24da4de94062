// Energy: what a flag holds, the work done on it, and the ledger that tells energy a method creates.
//
// E = elastic + kinetic. Every force but the springs' elasticity counts its work W by the method's own quadrature, passes
// after the move the energy they change. What is left over, C = E - E_0 - W, was created (or lost) by the method: on
// smooth motion a share of a per cent, in a run that is garbage a good part of all there is. Height is not in E: gravity
// works.
#pragma once

#include "drapeau/isa.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <deque>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// What a cloth holds at one instant. Held masses do not move and count for nothing in kinetic energy.
struct Measurement {
    double kinetic = 0.0;       // J; of staggered methods sum m v-.v+ / 2, of the velocities before and after the kick
    double elastic = 0.0;       // J, sum of k (l - L)^2 / 2
    double max_stretch = -1.0;  // share, max (l - L) / L; negative where every spring is compressed
    double mean_stretch = 0.0;  // share, mean |l - L| / L
    double max_force = 0.0;     // N, max |k (l - L)|
    double rms_force = 0.0;     // N, root mean square of k (l - L)
    double half_kick = 0.0;     // s, how far velocities lag: dt/2 of staggered methods
    double power = 0.0;         // W, of all but elasticity, at the velocity stored
    glm::dvec3 moment{0.0};     // kg m, sum of m x over the masses that are free: gravity's energy is -g . moment

    double total() const { return kinetic + elastic; }
    /// What elastic forces and the work counted step by step balance: velocities half a kick back.
    double balance() const { return total() - half_kick * power; }
};

/// Work done on a flag (J).
struct Work {
    double external = 0.0;  // by gravity, drag, wind, friction
    double damping = 0.0;   // by the springs' dampers
    double passes = 0.0;    // energy that passes after the move added

    double all() const { return external + damping + passes; }
};

/// Energy created since the settings last changed, against all there could be.
struct Ledger {
    // Measured: good runs stay below 0.02, garbage above 0.4.
    static constexpr double broken_share = 0.3;
    static constexpr double window = 1.0;  // s, for creation that long runs would dilute

    double initial = 0.0;   // J
    double external = 0.0;  // J, of spans in which the work of external forces was positive
    double created = 0.0;   // J
    double rounding = 0.0;  // J, what rounding may have made
    double energy = 0.0;    // J, when last looked

    /// Opens it on what a flag holds at time `now` (s).
    void open(double now, double joules) {
        *this = {};
        initial = energy = joules;
        looks_.push_back({now, 0.0, 0.0, 0.0, joules});
    }

    /// Takes in the span up to `now` in which `external_work` and `created_energy` (J) were counted.
    void add(double now, double joules, double external_work, double created_energy, double rounding_energy) {
        external += std::max(0.0, external_work);
        created += created_energy;
        rounding += rounding_energy;
        energy = joules;
        looks_.push_back({now, external, created, rounding, joules});
        while (looks_.size() > 2 && looks_[1].time <= now - window) looks_.pop_front();
    }

    double scale() const { return std::max(initial + external, energy) + rounding; }

    /// Created energy over all that there could be: since the ledger was opened or in the last second, the greater.
    double created_share() const {
        const auto& then = looks_.front();
        const double here = std::max(then.energy + external - then.external, energy) + rounding - then.rounding;
        return std::max(share(created, scale()), share(created - then.created, here));
    }
    /// Energy over all that was there or came in.
    double energy_share() const { return share(energy, initial + external + rounding); }

    bool is_finite() const { return std::isfinite(energy) && std::isfinite(created); }
    /// `creates`: the method creates energy by nature or the step is past its limit, so that only its energy counts.
    bool is_broken(bool creates) const {
        return !is_finite() || energy_share() > 1.0 + broken_share || (!creates && created_share() > broken_share);
    }

private:
    struct Look {
        double time, external, created, rounding, energy;
    };
    static double share(double part, double whole) { return part > 0.0 ? part / whole : 0.0; }

    std::deque<Look> looks_;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

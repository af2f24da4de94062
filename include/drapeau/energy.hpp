// Energy: what a flag holds, the work done on it, and the ledger that tells energy a method creates.
//
// E = elastic + kinetic. Every force but the springs' elasticity counts its work W by the method's own quadrature,
// passes after the move the energy they change. What is left over, C = E - E_0 - W, was created (or lost) by the
// method: on smooth motion a share of a per cent, in a run that is garbage a good part of all there is. Height is not
// in E: gravity works; as its work is the change of its potential, it is known without being summed.
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
    double kinetic_now = 0.0;   // J, of the velocities at the positions' time: what there is to see
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
    double external = 0.0;  // by drag, friction and terms that push, but those that store energy
    double stored = 0.0;    // that those stored: gravity's work is -stored
    double damping = 0.0;   // by the springs' dampers
    double passes = 0.0;    // energy that passes after the move added

    /// Of all but terms that store energy.
    double but_stored() const { return external + damping + passes; }
    double all() const { return but_stored() - stored; }
    double gross() const { return std::abs(external) + std::abs(stored) + std::abs(damping) + std::abs(passes); }
    void add(const Work& other) {
        external += other.external, stored += other.stored, damping += other.damping, passes += other.passes;
    }
};

/// A sum of which only samples are known: its value and the variance of that value.
struct Estimate {
    double value = 0.0, variance = 0.0;

    void add(const Estimate& other) { value += other.value, variance += other.variance; }
    double doubt() const { return 3.0 * std::sqrt(variance); }  // three standard errors
};

/// Energy created since the settings last changed, against all there could be.
struct Ledger {
    // Measured: good runs stay far below, garbage far above.
    static constexpr double broken_share = 0.3;
    static constexpr double window = 1.0;  // s, for creation that long runs would dilute

    double initial = 0.0;   // J
    Estimate external;      // J, what external forces brought in, summed over batches in which that was positive
    double fallen = 0.0;    // J, the most that gravity has given since the beginning
    Estimate created;       // J
    double rounding = 0.0;  // J, what rounding may have made
    double energy = 0.0;    // J, when last looked

    /// Opens it on what a flag holds at time `now` (s), `potential` (J) being gravity's.
    void open(double now, double joules, double potential) {
        *this = {};
        initial = energy = joules;
        potential_ = potential;
        looks_.push_back({now, joules, potential, 0.0, {}, {}});
    }

    /// Takes in the span up to `now` (s) at whose end there are `joules`: what came in, what was created and what
    /// rounding may have made in it (J).
    void add(double now, double joules, double potential, const Estimate& came_in, const Estimate& made,
             double rounding_energy) {
        external.add(came_in);
        fallen = std::max(fallen, potential_ - potential);
        created.add(made);
        rounding += rounding_energy;
        energy = joules;
        looks_.push_back({now, joules, potential, rounding, external, created});
        while (looks_.size() > 2 && looks_[1].time <= now - window) looks_.pop_front();
    }

    double scale(bool in_doubt = true) const { return std::max(brought(in_doubt), energy) + rounding; }

    /// Created energy (lost, if negative) over all that there could be: since the ledger was opened or in the last
    /// second, the greater. What is in doubt is left out, or not.
    double created_share(bool in_doubt = true) const {
        const double all = share(in_doubt ? certain(created) : created.value, scale(in_doubt));
        const double last = created_lately(in_doubt);
        return std::abs(last) > std::abs(all) ? last : all;
    }
    /// The same in the last second.
    double created_lately(bool in_doubt = true) const {
        const auto& then = looks_.front();
        const Estimate lately{created.value - then.created.value, created.variance - then.created.variance};
        double lowest = then.potential;
        for (const auto& look : looks_) lowest = std::min(lowest, look.potential);
        const double doubt = in_doubt ? external.doubt() - then.external.doubt() : 0.0;
        const double came_in = external.value - then.external.value + doubt + then.potential - lowest;
        const double here = std::max(then.energy + came_in, energy) + rounding - then.rounding;
        return share(in_doubt ? certain(lately) : lately.value, here);
    }
    /// Energy over all that was there or came in.
    double energy_share(bool in_doubt = true) const { return share(energy, brought(in_doubt) + rounding); }

    bool is_finite() const { return std::isfinite(energy) && std::isfinite(created.value); }
    /// `creates`: the method creates energy by nature, so that what it created is judged by the energy there is.
    /// `in_doubt`: what is in doubt is left out; without, it may well be no more than that.
    bool is_broken(bool creates, bool in_doubt = true) const {
        const double made = created_share(in_doubt);
        return !is_finite() || energy_share(in_doubt) > 1.0 + broken_share || made < -broken_share ||
               (!creates && made > broken_share);
    }

private:
    struct Look {
        double time, energy, potential, rounding;
        Estimate external, created;
    };
    double brought(bool in_doubt) const {
        return initial + fallen + external.value + (in_doubt ? external.doubt() : 0.0);
    }
    static double share(double part, double whole) { return part != 0.0 ? part / whole : 0.0; }
    static double certain(const Estimate& e) {
        return std::copysign(std::max(0.0, std::abs(e.value) - e.doubt()), e.value);
    }

    std::deque<Look> looks_;
    double potential_ = 0.0;  // J, when opened
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

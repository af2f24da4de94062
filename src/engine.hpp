// Engine: a scene's masses in one precision, moved by the kernel of its composition. Simulation chooses among engines.
#pragma once

#include "simulation.hpp"

#include "drapeau/energy.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/stability.hpp"

#include <glm/vec3.hpp>

#include <atomic>

namespace drapeau {

/// The physics of a scene, sorted for the core.
struct Physics {
    Grid grid;
    Attach attach;
    Material material;
    Gravity gravity;  // zero where the scene lists none: it folds into one vector with the wind
    AirDrag drag;
    Friction friction;
    UniformWind wind;
    Method method;

    explicit Physics(const Scene& scene);
    Rates rates() const;
    double largest_step() const;  // s; 0 if the method has no stable step
};

/// When each step of a run begins: a whole number of steps times dt, never a running sum.
struct Clock {
    double start = 0.0;   // s, the beginning of step `first`
    long long first = 0;  // since the run began
    double dt = 0.0;      // s

    double at(long long step) const { return start + static_cast<double>(step - first) * dt; }
};

/// Position and velocity of every mass in double, row by row: what passes from one engine to another.
struct Masses {
    std::vector<glm::dvec3> x, v;
};

class Engine {
public:
    virtual ~Engine() = default;

    /// Takes the steps first <= n < last of the clock. Looks at `abandon` every few hundredths of a second and returns
    /// false, somewhere in between, once it is set.
    virtual bool advance(const Clock& clock, long long first, long long last,
                         const std::atomic<bool>* abandon = nullptr) = 0;
    /// How many threads may share the work; small cloths stay on one, where a second would not pay.
    virtual void use_threads(int threads) = 0;
    /// Keeps the state aside, and returns to what was kept.
    virtual void keep() = 0;
    virtual void return_to_kept() = 0;

    virtual Energy energy() const = 0;
    /// Total displacement since keep(), summed over the masses (m): what uniform forces did work along.
    virtual glm::dvec3 moved_since_kept() const = 0;
    virtual Masses masses() const = 0;
    virtual void set(const Masses& masses) = 0;
    virtual void snapshot(Snapshot& into) const = 0;
    virtual std::uint64_t state_hash() const = 0;
};

/// An engine with all masses at rest at the origin; give it masses with set().
std::unique_ptr<Engine> make_engine(const Physics& physics, Precision precision);

}  // namespace drapeau

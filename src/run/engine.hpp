// Engine: a model's masses in one precision, moved by the kernels of a method. Simulation chooses among engines.
#pragma once

#include "drapeau/energy.hpp"
#include "drapeau/fastest_mode.hpp"
#include "drapeau/stepper.hpp"
#include "scene/scene.hpp"

#include <atomic>
#include <cmath>
#include <memory>

namespace drapeau {

/// Everything that the steps to come depend on, of one moment, kept outside the engine; never changed.
class EngineState {
public:
    virtual ~EngineState() = default;
    virtual void snapshot(FieldBuffer<float>& into) const = 0;  // positions (m) as the picture takes them
    virtual void velocity(FieldBuffer<float>& into) const = 0;  // m/s, as stored
    virtual std::size_t bytes() const = 0;
};

class Engine {
public:
    virtual ~Engine() = default;

    /// Takes the steps first <= n < last of the clock; `report` gets what they did, work in the step `accounted`. Looks
    /// at `abandon` every few hundredths of a second and stops early once it is set. Returns the step it stands at.
    virtual long long advance(const Clock& clock, long long first, long long last, long long accounted, Report& report,
                              const std::atomic<bool>* abandon) = 0;
    /// How many threads may share the work; small cloths stay on one, where a second would not pay. Throws InputError
    /// where the system gives no more threads.
    virtual void use_threads(int threads) = 0;
    /// Takes over strengths; the grid and what is listed stay.
    virtual void refill(const Model& model) = 0;
    /// Lets the method start anew at time `now` (s), after a change.
    virtual void synchronise(double now) = 0;
    /// From time `now` (s) on moves what is held upwards, at `speed` (m/s).
    virtual void haul(double now, double speed) = 0;
    virtual double hauled() const = 0;  // m/s, that speed
    /// From this step of the clock on a hand pulls like this, or none does (pull.hpp).
    virtual void pull(long long step, const std::optional<Pull>& by) = 0;

    virtual const Model& model() const = 0;
    virtual double step_cost() const = 0;
    virtual Measurement measure(double now) = 0;
    /// Whether every mass and every reading is finite.
    bool is_finite(double now) {
        const Measurement here = measure(now);
        return std::isfinite(here.total() + here.kinetic_now + here.rms_force);
    }
    virtual double kinetic() = 0;           // J, of the velocities stored
    virtual double epsilon() const = 0;     // of the precision
    virtual glm::dvec3 corner() const = 0;  // m, where mass (0, 0) is
    /// The fastest mode of the springs and the air as they are, after so many more looks at it (fastest_mode.hpp).
    virtual Oscillator fastest_mode(double damping_weight, double on_mass_weight, double dt, int looks, double now) = 0;
    /// How far from the origin (m) masses are at most, as long as no spring is much longer than at rest.
    double reach() const { return reach(corner()); }
    double reach(const glm::dvec3& far) const {
        const Grid& grid = model().grid;
        return std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y) +
               std::sqrt(far.x * far.x + far.y * far.y + far.z * far.z);
    }

    /// Position and velocity at the same time.
    virtual State<double> state(double now) = 0;
    virtual void set(const State<double>& state) = 0;
    /// Positions as the picture takes them.
    virtual void snapshot(FieldBuffer<float>& into) const = 0;
    virtual void velocity(FieldBuffer<float>& into) const = 0;  // m/s, as stored
    virtual std::uint64_t state_hash() const = 0;

    /// Everything that the steps to come depend on, kept aside in one of a few places.
    virtual void save(int place) = 0;
    virtual void restore(int place) = 0;

    /// The same outside: of now, and of what a place holds (null where that is empty).
    virtual std::shared_ptr<const EngineState> keep() const = 0;
    virtual std::shared_ptr<const EngineState> kept_in(int place) = 0;
    /// Goes back to what an engine of the same model, method and precision kept.
    virtual void restore(const EngineState& kept) = 0;
    virtual void put_in(int place, std::shared_ptr<const EngineState> kept) = 0;
};

/// What a step costs, in steps of one mass of a large cloth (some nanoseconds).
double step_cost(const Model& model, Method method);

/// An engine with all masses at rest at their places in the grid. `half_kick_start`: semi-implicit Euler begins half a
/// kick back; others take no notice.
std::unique_ptr<Engine> make_engine(const Model& model, Method method, Precision precision,
                                    bool half_kick_start = false);

}  // namespace drapeau

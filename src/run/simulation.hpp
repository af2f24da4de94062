// Simulation: one run of a scene, its method, terms and precision chosen at run time.
// Time advances in batches of 1/60 s; the state is single-owner (one thread at a time), never shared.
#pragma once

#include "run/error_watch.hpp"
#include "scene/scene.hpp"

#include "drapeau/energy.hpp"
#include "drapeau/flag.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace drapeau {

/// Where every mass is at a moment, as the picture takes it.
struct Snapshot {
    FieldBuffer<float> position;  // m
    FieldBuffer<float> velocity;  // m/s; without masses unless it was asked for (Simulation::velocity)
    double time = 0.0;            // s of simulated time
    long long steps = 0;          // since the run began
};

/// Sizes of a moment, for panels and files. All of the same instant.
struct Readings {
    double kinetic_energy = 0.0;    // J
    double spring_energy = 0.0;     // J
    double gravity_energy = 0.0;    // J, zero at y = 0
    double max_stretch = 0.0;       // share: 0.05 is 5 % longer than rest; over all springs
    double mean_stretch = 0.0;      // share, mean of |l - L| / L
    double max_spring_force = 0.0;  // N, max |k (l - L)|
    double rms_spring_force = 0.0;  // N
    // Of the energy there could be, what the method created (see energy.hpp); absent where the method does not know
    // what forces did.
    std::optional<double> created_share{};
    PassReport limit;   // of the passes after the move, in the last batch
    double time = 0.0;  // s, when it was measured
};

/// A run that diverged. The run then stands on the last state that was good.
struct Divergence {
    enum class Cause { past_the_limit, energy_created, too_soft, energy_lost, float_rounding, beyond_precision };

    long long step = 0;       // the step (since the run began) that broke it
    double time = 0.0;        // s
    int column = 0, row = 0;  // where
    double dt = 0.0;          // s, the step in use
    StableStep limit;         // the largest step the closed stability bound guarantees
    double safe_dt = 0.0;     // s, a step that was tried from the same state and held; 0 if none was found
    Cause cause = Cause::past_the_limit;
    std::string message;  // one line for a person
};

/// A moment of a run, whole: positions, velocities and all else that the flight from there depends on, its scene
/// included. Never changed.
class KeptRun {
public:
    struct Parts;
    explicit KeptRun(std::unique_ptr<const Parts> parts);
    ~KeptRun();

    double time() const;  // s
    const Scene& scene() const;
    void snapshot(Snapshot& into) const;
    void velocity(Snapshot& into) const;  // of the same moment too; see Simulation
    /// Every part with the memory it takes (bytes); moments that follow each other share some.
    void each_part(const std::function<void(const void* part, std::size_t bytes)>& visit) const;

private:
    friend class Simulation;
    std::unique_ptr<const Parts> parts_;
};

class Simulation {
public:
    /// Builds the start state. Throws InputError (see check_scene, and "auto" where the method has no stable step). A
    /// flag that starts hanging may take some seconds to settle; if `abandon` is set meanwhile, throws
    /// SettlingAbandoned (settle.hpp).
    explicit Simulation(const Scene& scene, const std::atomic<bool>* abandon = nullptr);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    const Scene& scene() const;
    const Model& model() const;

    /// Goes on from these masses instead, wherever they are; held ones stay where they are put. The time becomes
    /// `time` (s), or stays what it is. Throws InputError where float leaves nothing of a given step there.
    void put(const State<double>& state, std::optional<double> time = {});

    /// Takes new settings over between batches; position, velocity and time go on. Strengths are refilled in place; a
    /// new grid or size is interpolated in the flag's own coordinates. Throws InputError and changes nothing if the
    /// scene is impossible. Where the flag must start anew it settles as above.
    void change(const Scene& scene, const std::atomic<bool>* abandon = nullptr);

    /// Advances 1/60 s in steps_per_batch() equal steps. If the run diverges it is put back to the last good state.
    /// With an automatic step, energy created by the method takes the run back and repeats it with a smaller step
    /// instead. If `abandon` is set meanwhile it gives up within a few hundredths of a second, between two steps.
    std::optional<Divergence> advance_batch(const std::atomic<bool>* abandon = nullptr);

    /// Advances `count` steps of exactly dt() (the laboratory's way, and the window's single step).
    std::optional<Divergence> advance_steps(long long count, const std::atomic<bool>* abandon = nullptr);

    /// Looks at the energy once more, at the end of a run: whether it is good up to now. An automatic step that is not
    /// is answered as by advance_batch.
    std::optional<Divergence> check();

    /// A hand that pulls at the cloth from the next batch on (pull.hpp), or none. What it brings in counts as brought
    /// in. Errors are not measured meanwhile.
    void pull(const std::optional<Pull>& by);
    /// N, the mean of its force over the steps last asked for.
    double pull_force() const;

    /// The laboratory uses a numeric dt as given instead of rounding it to a whole number of steps a batch.
    void use_exact_dt();

    /// How many threads may share a step (1 at first); the bits are the same for any number. Throws InputError where
    /// the system gives no more.
    void use_threads(int threads);

    double time() const;  // s
    long long steps() const;
    double dt() const;  // s, the step in use
    long long steps_per_batch() const;
    StableStep stability_limit() const;  // the closed bound for this scene and method
    /// The limit here and now, within a few per cent: above it motion is certain to break (see fastest_mode.hpp). None
    /// of methods whose limit does not follow from one mode, or that are stable at any step.
    std::optional<StableStep> live_limit() const;
    /// That the step is past it, and how fast noise grows; empty where it is not.
    std::string limit_remark() const;
    /// What the method does to the motion by nature at this step (see method_remark.hpp); empty where it does nothing.
    std::string method_remark() const;
    const Solves& solves() const;  // what solving took since the settings last changed, of methods that solve
    /// Why an automatic step is smaller than its usual share of the bound; empty where it is not.
    std::string lowered_because() const;

    /// What the step in use was chosen by: "limit: stiffness of the springs", "limit: 0.8 of 1 mm/s asked".
    std::string step_reason() const;

    /// Whether errors are measured as the run goes on. With a tolerance they always are, and waited for.
    void watch_error(ErrorWatch::Mode mode);
    /// What its tolerance needs is computed by the thread that advances it: see ErrorWatch.
    void use_own_thread();
    /// The newest of them, for the step in use; empty after a change until the next is there.
    const std::optional<ErrorEstimate>& error() const;
    /// This moment, for the next.
    ErrorWindow error_window() const;
    /// The error of steps of dt() since then.
    ErrorEstimate error_since(const ErrorWindow& begin) const;

    Precision precision() const;  // in use: double where float could not honour an automatic step
    /// Why that is not the scene's, or how little of the motion float honours at a given step; empty where all is well.
    std::string precision_remark() const;

    /// How far a flag that starts hanging was from rest, where settling it took too much work; empty where all is well.
    const std::string& start_remark() const;

    void snapshot(Snapshot& into) const;
    /// Its velocities too, as the method keeps them: those of staggered methods are half a step back.
    void velocity(Snapshot& into) const;
    Readings readings() const;
    /// Those of at most a few batches ago, so that they cost a hundredth of the steps.
    const Readings& recent_readings();
    std::uint64_t state_hash() const;  // of the bits of x and v as stored, padding excluded

    /// Position and velocity of every mass at the same time. Reading it does not alter the run.
    State<double> state() const;

    /// This moment, to go on from at any time later: in the run that kept it or in another, with any number of threads,
    /// to the same bits. Throws std::bad_alloc.
    std::shared_ptr<const KeptRun> keep() const;
    /// Goes back (or on) to a moment and its scene. Throws where there is no memory for it, and changes nothing.
    void restore(const KeptRun& kept);

private:
    struct Run;
    void rebuild(const Scene& scene, const std::atomic<bool>* abandon);
    std::unique_ptr<Run> run_;
};

}  // namespace drapeau

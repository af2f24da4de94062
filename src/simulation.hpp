// Simulation: one run of a scene, its composition of terms, method and precision chosen at run time.
// Time advances in batches of 1/60 s; the state is single-owner (one thread at a time), never shared.
#pragma once

#include "scene.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

inline constexpr double batch_seconds = 1.0 / 60.0;

/// The component arrays of a moment. Mass (column i, row j) is element j * stride + i; stride >= columns, the rest is
/// padding.
struct Snapshot {
    int columns = 0;
    int rows = 0;
    int stride = 0;
    std::vector<float> x, y, z;     // m, rows * stride each
    std::vector<float> vx, vy, vz;  // m/s, the same shape
    double time = 0.0;              // s of simulated time
    long long steps = 0;            // since the run began
};

/// Sizes of a moment, for panels and files. All of the same instant.
struct Readings {
    double kinetic_energy = 0.0;         // J
    double spring_energy = 0.0;          // J
    double gravity_energy = 0.0;         // J, zero at y = 0
    double greatest_stretch = 0.0;       // share: 0.05 is 5 % longer than rest; over all springs
    double mean_stretch = 0.0;           // share, mean of |l - L| / L
    double greatest_spring_force = 0.0;  // N, max |k (l - L)|
};

/// A run that came apart. The run then stands on the last good batch.
struct Divergence {
    long long step = 0;       // the step (since the run began) that broke it
    double time = 0.0;        // s
    int column = 0, row = 0;  // where
    double dt = 0.0;          // s, the step in use
    double limit = 0.0;       // s, largest step the closed stability bound guarantees; 0 if there is none
    double safe_dt = 0.0;     // s, 0.9 of the limit; 0 if there is none
    std::string message;      // one line for a person
};

class Simulation {
public:
    /// Builds the start state. Throws InputError (see check_scene, and "auto" where the method has no stable step).
    explicit Simulation(const Scene& scene);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    const Scene& scene() const;

    /// Takes new settings over between batches; position, velocity and time go on. A new grid, size or attachment is
    /// interpolated in the flag's own coordinates. Throws InputError and changes nothing if the scene is impossible.
    void change(const Scene& scene);

    /// Advances 1/60 s in steps_per_batch() equal steps. If the run diverges it is put back to the batch's beginning.
    /// If `abandon` is set meanwhile it gives up within a few hundredths of a second, as if it had never begun.
    std::optional<Divergence> advance_batch(const std::atomic<bool>* abandon = nullptr);

    /// Advances `count` steps of exactly dt() (the laboratory's way, and the window's single step).
    std::optional<Divergence> advance_steps(long long count);

    /// The laboratory uses a numeric dt as given instead of rounding it to a whole number of steps a batch.
    void use_exact_dt();

    /// How many threads may share a step (1 at first); the bits are the same for any number.
    void use_threads(int threads);

    double time() const;  // s
    long long steps() const;
    double dt() const;  // s, the step in use
    int steps_per_batch() const;
    double stability_limit() const;  // s, the closed bound for this scene and method; 0 if there is no stable step

    void snapshot(Snapshot& into) const;
    Readings readings() const;
    std::uint64_t state_hash() const;  // of the bits of x and v, padding excluded

    /// Position and velocity of every mass in double, rows * columns each, row by row: x y z vx vy vz.
    std::vector<double> state() const;

private:
    struct Run;
    std::unique_ptr<Run> run_;
};

/// dt such that a whole number of equal steps fill a batch, none longer than `dt`: (1/60) / ceil((1/60) / dt).
double whole_steps_per_batch(double dt);

}  // namespace drapeau

// Flight: a stretch of a scene's time flown by one method, seen at sample times: what flights are compared by.
#pragma once

#include "run/engine.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace drapeau {

/// From a state on, so many batches of 1/60 s. Samples are taken every `every` batches, the last one included.
struct Stretch {
    State<double> start;
    double time = 0.0;  // s, of that state: the wind is a function of it
    long long batches = 0;
    long long every = 1;
    int every_mass = 1;  // of a row and of a column, that positions are kept of: to compare grids at masses they share

    double seconds() const { return static_cast<double>(batches) * batch_length; }
    bool is_sample(long long batch) const { return (batches - batch) % every == 0; }

    static constexpr double batch_length = 1.0 / 60.0;  // s
};

/// What a moment is compared by, besides where the masses are.
struct Reading {
    double energy = 0.0;   // J: kinetic, of springs, and of height
    double stretch = 0.0;  // share, of the most stretched spring
};

/// Reads states of one model, whatever moved them.
class Yardstick {
public:
    explicit Yardstick(const Model& model);
    Reading read(const State<double>& state, double time);

private:
    std::unique_ptr<Engine> engine_;
};

struct Flight {
    std::vector<FieldBuffer<double>> positions;  // m, at each sample
    std::vector<Reading> readings;               // at each sample
    std::vector<glm::dvec3> tip, tip_velocity;   // m and m/s, after every batch
    State<double> end{1, 1};

    /// Takes in the state after a batch.
    void see(const Stretch& stretch, long long batch, State<double> state, Yardstick& yardstick);
};

/// The column and row of the mass whose motion stands for the flag's: the fly end's middle, a chain's end, or what is
/// free instead.
struct Tip {
    int column = 0, row = 0;
};
Tip tip_of(const Model& model);

/// Flies the stretch, in so many equal steps a batch; nothing if a value was not finite on the way, or `may_go_on()`
/// was false after a batch. `look` sees the whole state at each sample.
std::optional<Flight> fly(const Model& model, Method method, long long steps_a_batch, const Stretch& stretch,
                          Yardstick& yardstick, const std::function<bool()>& may_go_on = {},
                          Precision precision = Precision::double_precision,
                          const std::function<void(const State<double>&)>& look = {});

/// Whether the stretch limit moved masses at a sample: some spring was as long as it allows.
bool is_limit_active(const Model& model, const Flight& flight);

/// Two flights without what their errors have in common that shrinks with step^order, `fine` having half the step of
/// `coarse`.
Flight extrapolated(const Flight& coarse, const Flight& fine, int order);

/// How far one flight is from another. Distances are over the masses that are free.
struct Apart {
    double at_end = 0.0;     // m, root mean square at the end
    double over_time = 0.0;  // m, root mean square over all samples
    double greatest = 0.0;   // m, of any mass at any sample
    double energy = 0.0;     // J, the greatest at any sample
    double stretch = 0.0;    // share, likewise of the greatest stretch

    /// What a tolerance is asked of.
    double distance() const { return at_end > over_time ? at_end : over_time; }
};

/// Compares flights of one model sample by sample, so that only one of them must be kept.
class Comparison {
public:
    Comparison(const Model& model, const Flight& truth) : model_(model), truth_(truth) {}
    /// The next sample.
    void take(const FieldBuffer<double>& position, const Reading& reading);
    Apart result() const;

private:
    const Model& model_;
    const Flight& truth_;
    std::size_t sample_ = 0;
    double last_ = 0.0, squares_ = 0.0;  // mean squares, m^2
    Apart apart_;
};

Apart apart(const Model& model, const Flight& one, const Flight& truth);

}  // namespace drapeau

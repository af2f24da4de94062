#include "run/error_estimate.hpp"

#include "io/text.hpp"

#include "drapeau/precision.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <string>

namespace drapeau {
namespace {

using Verdict = ErrorEstimate::Verdict;

std::string mm_per_s(double metres_per_second) {
    return rounded(1e3 * metres_per_second, 2) + " mm/s";
}

/// Root mean square (m) over the masses that are free of what `of(i, j)` gives for each.
template <class Of>
double rms_of_free(const Model& model, const Of& of) {
    double squares = 0.0;
    long long free = 0;
    for (int j = 0; j < model.grid.rows; ++j)
        for (int i = 0; i < model.grid.columns; ++i) {
            if (model.held(i, j)) continue;
            const glm::dvec3 d = of(i, j);
            squares += d.x * d.x + d.y * d.y + d.z * d.z;
            ++free;
        }
    return free > 0 ? std::sqrt(squares / static_cast<double>(free)) : 0.0;
}

/// What the three ends of a window in one precision say (m, but for the flags).
struct Halvings {
    FieldBuffer<double> x1;
    double first = 0.0, second = 0.0, residue = 0.0;  // x1 - x2, x2 - x4, and R
    double corrected = 0.0;                           // the error of x1, if R is of the next order
    double rounding = 0.0;                            // what rounding may make of them
    bool limited = false, finite = true, abandoned = false;

    double estimate(int order) const { return first / (1.0 - std::pow(0.5, order)); }
    /// Whether that is right to a tenth (derived in the header).
    bool resolve(int order) const {
        constexpr double wrong = 0.1;
        const double two = std::pow(2.0, order), f = two / (two - 1.0), noise = (1.0 + wrong) * (1.0 + wrong) - 1.0;
        const double noise_squared = noise / (2.0 * f * f - 1.0 - noise);
        const double most = std::sqrt(noise_squared * (1.0 + (1.0 + two) * (1.0 + two) + two * two) /
                                      (1.0 / (f * f) + 2.0 * noise_squared));
        return residue <= most * first && std::abs(estimate(order) - corrected) <= wrong * corrected;
    }
    /// Whether a smaller step brings the end closer at all: by half an order at least.
    bool shrink() const { return first > std::sqrt(2.0) * second; }
    bool below_rounding() const { return second <= rounding; }
};

int order_in(const Model& model, Method method, bool half_kick_start) {
    const bool damped = model.springs.damping.value_or(0.0) > 0.0 || model.damping_on_mass(1.0) > 0.0 || model.air() ||
                        (model.bending() && model.bending()->damping);
    return half_kick_start && method == method_id<SemiImplicitEuler> && !damped ? 2 : order_of(method);
}

long long steps_in(const ErrorWindow& window, double dt) {
    return std::max(1LL, std::llround(window.seconds / dt));
}

/// Where the masses are at the end of a window, each step taken in so many parts; nothing where it was abandoned.
std::optional<FieldBuffer<double>> end_of(Engine& engine, const ErrorWindow& window, double dt, int parts,
                                          PassReport& limit, const std::atomic<bool>* abandon) {
    const Clock clock{window.time, 0, dt / parts};
    const long long steps = parts * steps_in(window, dt);
    Report report;
    engine.set(window.state);
    if (engine.advance(clock, 0, steps, no_step, report, abandon) < steps) return {};
    limit.add(report.limit);
    return engine.state(clock.at(steps)).position;
}

Halvings halvings(const Model& model, Method method, Precision precision, const ErrorWindow& window, double dt,
                  const std::atomic<bool>* abandon, bool half_kick_start) {
    Halvings found;
    const auto engine = make_engine(model, method, precision, half_kick_start);
    PassReport limit;
    FieldBuffer<double> ends[3];
    for (int halved = 0; halved < 3; ++halved) {
        auto end = end_of(*engine, window, dt, 1 << halved, limit, abandon);
        found.abandoned = !end;
        if (!end) return found;
        ends[halved] = std::move(*end);
    }
    found.limited = limit.sweeps > 0;
    const double two = std::pow(2.0, order_in(model, method, half_kick_start));
    const FieldBuffer<double>&x1 = ends[0], &x2 = ends[1], &x4 = ends[2];
    const auto first = [&](int i, int j) { return x1.at(i, j) - x2.at(i, j); };
    const auto second = [&](int i, int j) { return x2.at(i, j) - x4.at(i, j); };
    const auto residue = [&](int i, int j) { return first(i, j) - two * second(i, j); };
    found.first = rms_of_free(model, first);
    found.second = rms_of_free(model, second);
    found.residue = rms_of_free(model, residue);
    found.corrected = rms_of_free(model, [&](int i, int j) {
        return two / (two - 1.0) * (first(i, j) - 2.0 / (2.0 * two - 1.0) * residue(i, j));
    });
    found.finite = std::isfinite(found.first + found.second);
    // Half a unit in the last place of a position for each step (precision.hpp).
    found.rounding = 0.5 * engine->epsilon() * engine->reach() * static_cast<double>(4 * steps_in(window, dt));
    found.x1 = std::move(ends[0]);
    return found;
}

/// The state as float holds it.
State<double> narrowed(const State<double>& state) {
    State<float> narrow(state.columns(), state.rows());
    narrow.position.take(state.position), narrow.velocity.take(state.velocity);
    State<double> same(state.columns(), state.rows());
    same.position.take(narrow.position), same.velocity.take(narrow.velocity);
    return same;
}

ErrorEstimate judged(const Model& model, Method method, Precision precision, const ErrorWindow& given, double dt,
                     const std::atomic<bool>* abandon, bool half_kick_start) {
    const bool is_float = precision == Precision::single_precision;
    const ErrorWindow window{is_float ? narrowed(given.state) : given.state, given.time, given.seconds};
    ErrorEstimate estimate;
    const int p = estimate.order = order_in(model, method, half_kick_start);
    const double seconds = estimate.seconds = static_cast<double>(steps_in(window, dt)) * dt;
    estimate.dt = dt;
    const auto conclude = [&](Verdict verdict) {
        estimate.verdict = verdict;
        if (verdict == Verdict::resolved) estimate.rate = estimate.by_method = estimate.apart;
        return estimate;
    };
    const auto why_not = [](const Halvings& halved) { return halved.shrink() ? Verdict::coarse : Verdict::chaos; };

    const Halvings here = halvings(model, method, precision, window, dt, abandon, half_kick_start);
    if (here.abandoned) return estimate;
    if (!here.finite) return conclude(Verdict::not_finite);
    estimate.apart = here.estimate(p) / seconds;
    const bool resolves = here.resolve(p);
    if (!resolves && here.limited) return conclude(Verdict::limit);
    if (!is_float)
        return conclude(resolves ? Verdict::resolved : here.below_rounding() ? Verdict::rounding : why_not(here));

    // What float makes of the motion, double tells. Three ends that do not move at all agree too.
    const auto parted = [&](const FieldBuffer<double>& exact) {
        return rms_of_free(model, [&](int i, int j) { return here.x1.at(i, j) - exact.at(i, j); }) / seconds;
    };
    if (resolves) {
        PassReport ignored;
        const auto engine = make_engine(model, method, Precision::double_precision, half_kick_start);
        const auto end = end_of(*engine, window, dt, 1, ignored, abandon);
        if (!end) return estimate;
        estimate.by_rounding = parted(*end);
        if (estimate.by_rounding <= estimate.apart) return conclude(Verdict::resolved);
    }
    const Halvings wide = halvings(model, method, Precision::double_precision, window, dt, abandon, half_kick_start);
    if (wide.abandoned) return estimate;
    if (!wide.resolve(p) && !wide.below_rounding()) return conclude(why_not(wide));
    if (wide.resolve(p)) estimate.by_method = wide.estimate(p) / seconds;
    estimate.by_rounding = parted(wide.x1);
    return conclude(Verdict::rounding);
}

}  // namespace

int order_of(Method method) {
    return with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::order; });
}

ErrorEstimate measure_error(const Model& model, Method method, Precision precision, const ErrorWindow& window,
                            double dt, const std::atomic<bool>* abandon, bool half_kick_start) {
    try {
        return judged(model, method, precision, window, dt, abandon, half_kick_start);
    } catch (const std::bad_alloc&) {
        ErrorEstimate none{.verdict = Verdict::no_memory};
        none.dt = dt, none.order = order_of(method);
        return none;
    }
}

std::optional<double> ErrorEstimate::best_float_step() const {
    if (!(by_rounding > 0.0) || !(by_method > 0.0)) return {};
    return dt * std::pow(by_rounding / (order * by_method), 1.0 / (order + 1));
}

std::string ErrorEstimate::reason() const {
    switch (verdict) {
        case Verdict::resolved:
            return "";
        case Verdict::unmeasured:
            return "not measured yet";
        case Verdict::coarse:
            return "step too coarse";
        case Verdict::chaos:
            return "coarse or chaotic";
        case Verdict::rounding:
            return by_rounding > 0.0 ? "float rounding" : "below rounding";
        case Verdict::limit:
            return "stretch limit";
        case Verdict::not_finite:
            return "diverges";
        case Verdict::no_memory:
            break;
    }
    return "no memory";
}

std::string ErrorEstimate::explanation() const {
    switch (verdict) {
        case Verdict::resolved:
            return "";
        case Verdict::unmeasured:
            return "the run is shorter than the time it takes to measure";
        case Verdict::coarse:
            return "the step is too coarse: halving it does not shrink the error as the method's order says";
        case Verdict::chaos:
            return "half the step leads elsewhere: the motion is chaotic, or the step far too coarse for it";
        case Verdict::rounding:
            return by_rounding > 0.0 ? "float rounding hides the error of the step; it moves masses by " +
                                           mm_per_s(by_rounding) + " itself"
                                     : "the error of the step is below the rounding of double";
        case Verdict::limit:
            return "the stretch limit acts: a pass after the move has no order";
        case Verdict::not_finite:
            return "the run diverges";
        case Verdict::no_memory:
            break;
    }
    return "there is not enough memory to run it again";
}

}  // namespace drapeau

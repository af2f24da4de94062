#include "measure/reference_flight.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/work_clock.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace drapeau {

namespace {

/// Whether halving the step has ceased to help: rounding, or motion that is not smooth. Where it is chaotic, large
/// steps all lead elsewhere, and only much smaller ones agree: that is waited for.
class Stagnation {
public:
    explicit Stagnation(const Model& model) : tiny_(1e-9 * std::min(model.grid.pitch_x, model.grid.pitch_y)) {}

    /// Takes in how far two flights are apart, those before them having been `before` apart (m).
    bool is_over(double before, double now) {
        constexpr double least_shrink = 1.3;
        constexpr int patience = 4;
        halvings_ = now * least_shrink > before ? halvings_ + 1 : 0;
        return halvings_ >= (now <= tiny_ ? 1 : patience);
    }

private:
    double tiny_;       // m: what rounding may make
    int halvings_ = 0;  // in vain, in a row
};

double rms_apart(const Model& model, const FieldBuffer<double>& a, const FieldBuffer<double>& b) {
    double squares = 0.0;
    long long free = 0;
    for (int j = 0; j < a.rows(); ++j)
        for (int i = 0; i < a.columns(); ++i) {
            if (model.held(i, j)) continue;
            const glm::dvec3 d = a.at(i, j) - b.at(i, j);
            squares += d.x * d.x + d.y * d.y + d.z * d.z;
            ++free;
        }
    return free > 0 ? std::sqrt(squares / static_cast<double>(free)) : 0.0;
}

class Search {
public:
    Search(const Model& model, const Stretch& stretch, Yardstick& yardstick, const ReferenceLimits& limits)
        : model_(model), stretch_(stretch), yardstick_(yardstick), limits_(limits) {}

    ReferenceFlight find() {
        ReferenceFlight reference;
        by_rk4(reference);
        by_leapfrog(reference);
        return reference;
    }

    Growth growth() {
        long long steps = 0;
        const Flight one = coarsest_by_rk4(steps);
        Stretch aside = stretch_;
        aside.start = pushed_aside(model_, stretch_.start, Growth::first);
        const auto other = flown(method_id<Rk4>, steps, aside);
        return other ? growth_of(model_, stretch_, one, *other) : Growth{};
    }

private:
    bool has_time_for(double seconds) const { return clock_.spent() + seconds <= limits_.seconds; }
    /// A flight takes a few seconds at most before the progress bar moves; three times its share of time ends it.
    std::optional<Flight> flown(Method method, long long steps, const Stretch& stretch) {
        const double before = clock_.spent(), a_batch = static_cast<double>(steps) * step_cost(model_, method);
        auto flight = fly(model_, method, steps, stretch, yardstick_, [&] {
            clock_.count(a_batch);
            if (limits_.tick) limits_.tick();
            return has_time_for(-2.0 * limits_.seconds);
        });
        last_cost_ = clock_.spent() - before;
        return flight;
    }

    /// At a quarter of the largest stable step, or the first half of that which holds.
    Flight coarsest_by_rk4(long long& steps) {
        constexpr double first_share = 0.25;
        const double stable = stable_step(method_id<Rk4>, model_).seconds();
        steps = std::max(4LL, static_cast<long long>(std::ceil(batch_seconds / (first_share * stable))));
        auto flight = flown(method_id<Rk4>, steps, stretch_);
        while (!flight && has_time_for(4.0 * last_cost_)) flight = flown(method_id<Rk4>, steps *= 2, stretch_);
        if (flight) return std::move(*flight);
        throw InputError("no reference: in double, rk4 does not hold at steps of " +
                         quantity(batch_seconds / static_cast<double>(steps), "s") +
                         ", or there is no time for smaller ones; allow more with --budget");
    }

    void by_rk4(ReferenceFlight& reference) {
        reference.by_rk4 = coarsest_by_rk4(reference.rk4_steps);
        reference.rk4_error = INFINITY;
        double before = INFINITY;
        Stagnation stagnation(model_);
        do {
            auto fine = flown(method_id<Rk4>, 2 * reference.rk4_steps, stretch_);
            if (!fine) break;
            const double now = apart(model_, *fine, reference.by_rk4).distance();
            const bool is_over = stagnation.is_over(before, now);
            if (is_over && now > before) break;  // the coarser one was as good
            reference.rk4_error = error_left(before, now, Rk4::order);
            reference.by_rk4 = std::move(*fine);
            reference.rk4_steps *= 2;
            if (is_over || reference.rk4_error <= limits_.goal) break;
            before = now;
        } while (has_time_for(2.0 * last_cost_ + leapfrog_share * 2.0 * last_cost_));
    }

    /// Steps h, h/2 and h/4, without the errors of orders 2 and 3.
    void by_leapfrog(ReferenceFlight& reference) {
        constexpr Method leapfrog = method_id<Leapfrog>;
        long long steps = std::max(1LL, reference.rk4_steps / 4);
        auto one = flown(leapfrog, steps, stretch_);
        while (!one && has_time_for(4.0 * last_cost_)) one = flown(leapfrog, steps *= 2, stretch_);
        auto two = one ? flown(leapfrog, 2 * steps, stretch_) : std::nullopt;
        auto four = two ? flown(leapfrog, 4 * steps, stretch_) : std::nullopt;
        if (!four)
            throw InputError("no reference: in double, leapfrog does not hold at steps of " +
                             quantity(batch_seconds / static_cast<double>(4 * steps), "s") +
                             ", or there is no time for smaller ones; allow more with --budget");
        Stagnation stagnation(model_);
        for (double before = INFINITY;;) {
            Flight second = extrapolated(*two, *four, 2);
            Flight third = extrapolated(extrapolated(*one, *two, 2), second, 3);
            const double now = apart(model_, third, second).distance();
            const bool is_over = stagnation.is_over(before, now);
            if (is_over && now > before) break;
            reference.leapfrog_error = now;
            reference.by_leapfrog = std::move(third);
            reference.leapfrog_steps = 4 * steps;
            reference.methods_apart = apart(model_, reference.by_leapfrog, reference.by_rk4).distance();
            if (reference.methods_apart <= std::max(limits_.goal, reference.rk4_error) || is_over ||
                !has_time_for(2.0 * last_cost_))
                break;
            auto finer = flown(leapfrog, 8 * steps, stretch_);
            if (!finer) break;
            before = now;
            steps *= 2;
            one = std::move(two), two = std::move(four), four = std::move(finer);
        }
        if (!std::isfinite(reference.rk4_error)) reference.rk4_error = reference.methods_apart;
    }

    static constexpr double leapfrog_share = 0.5;  // of what the finest flight of rk4 takes

    const Model& model_;
    const Stretch& stretch_;
    Yardstick& yardstick_;
    const ReferenceLimits& limits_;
    WorkClock clock_{limits_.unit};
    double last_cost_ = 0.0;  // s, of the last flight
};

}  // namespace

double error_left(double before, double now, int order) {
    const double shrink = std::clamp(before / now, 1.0, std::pow(2.0, order));
    return shrink > 1.5 ? now / (shrink - 1.0) : now;
}

double ReferenceFlight::error() const {
    return std::max(methods_apart, rk4_error);
}

const Flight& ReferenceFlight::judge_of(Method method) const {
    return method == method_id<Rk4> ? by_leapfrog : by_rk4;
}

double Growth::horizon(double distance) const {
    return rate > 0.0 ? std::max(0.0, std::log(distance / first) / rate) : INFINITY;
}

Growth find_growth(const Model& model, const Stretch& stretch, Yardstick& yardstick, const ReferenceLimits& limits) {
    return Search(model, stretch, yardstick, limits).growth();
}

double Growth::amplification(double seconds) const {
    return std::max(1.0, is_seen() ? std::min(std::exp(rate * seconds), last / first) : last / first);
}

State<double> pushed_aside(const Model& model, State<double> state, double distance) {
    std::mt19937_64 random(1);
    const auto component = [&] { return static_cast<double>(random()) * 0x1p-63 - 1.0; };  // mean square 1/3
    for (int j = 0; j < state.rows(); ++j)
        for (int i = 0; i < state.columns(); ++i) {
            if (model.held(i, j)) continue;
            const double x = component(), y = component(), z = component();
            state.position.set(i, j, state.position.at(i, j) + distance * glm::dvec3(x, y, z));
        }
    return state;
}

/// The slope of ln(distance) over time, by least squares, while the distances are small enough to grow freely. The
/// first fifth of that is left out: there the push dies out in the fastest modes. Where too few samples are left, from
/// the first distance that is larger.
Growth growth_of(const Model& model, const Stretch& stretch, const Flight& one, const Flight& other) {
    constexpr double left_out = 0.2, seen_from = 100.0;
    const double free_below = 0.01 * std::min(model.grid.pitch_x, model.grid.pitch_y);
    Growth growth;
    double greatest = 0.0, ends = 0.0;            // m; s, the last moment of free growth
    std::vector<std::pair<double, double>> free;  // s, ln m
    for (std::size_t k = 0; k < one.positions.size(); ++k) {
        const double distance = rms_apart(model, one.positions[k], other.positions[k]);
        const long long batch = stretch.batches - static_cast<long long>(one.positions.size() - 1 - k) * stretch.every;
        const double t = static_cast<double>(batch) * batch_seconds;
        growth.last = distance;
        const bool was_free = greatest <= free_below;
        greatest = std::max(greatest, distance);
        if (!was_free || !(distance > 0.0)) continue;
        ends = t;
        free.emplace_back(t, std::log(distance));
    }
    if (greatest <= seen_from * Growth::first) return growth;

    double n = 0.0, t_sum = 0.0, y_sum = 0.0, tt = 0.0, ty = 0.0;
    for (const auto& [t, y] : free) {
        if (t < left_out * ends || y > std::log(free_below)) continue;
        n += 1.0, t_sum += t, y_sum += y, tt += t * t, ty += t * y;
    }
    growth.rate = n >= 4.0 ? (ty - t_sum * y_sum / n) / (tt - t_sum * t_sum / n)
                           : (free.back().second - std::log(Growth::first)) / ends;
    growth.rate = std::max(0.0, growth.rate);
    return growth;
}

ReferenceFlight find_reference(const Model& model, const Stretch& stretch, Yardstick& yardstick,
                               const ReferenceLimits& limits) {
    return Search(model, stretch, yardstick, limits).find();
}

}  // namespace drapeau

#include "batch_track.hpp"

#include "drapeau/stability.hpp"

#include <utility>

namespace drapeau {

namespace {

constexpr double same_time = 1e-6 * batch_seconds;  // s

}  // namespace

void between(const State<double>& before, double t0, const State<double>& after, double t1, double time,
             FieldBuffer<float>& into) {
    const double h = t1 - t0, s = (time - t0) / h;
    const double x0 = (2.0 * s - 3.0) * s * s + 1.0, v0 = ((s - 2.0) * s + 1.0) * s * h;
    const double x1 = (3.0 - 2.0 * s) * s * s, v1 = (s - 1.0) * s * s * h;
    if (into.columns() != before.columns() || into.rows() != before.rows())
        into = FieldBuffer<float>(before.columns(), before.rows());
    for (int row = 0; row < before.rows(); ++row)
        for (int column = 0; column < before.columns(); ++column)
            into.set(column, row,
                     x0 * before.position.at(column, row) + v0 * before.velocity.at(column, row) +
                         x1 * after.position.at(column, row) + v1 * after.velocity.at(column, row));
}

void velocity_between(const State<double>& before, double t0, const State<double>& after, double t1, double time,
                      FieldBuffer<float>& into) {
    const double share = (time - t0) / (t1 - t0);
    for (int row = 0; row < into.rows(); ++row)
        for (int column = 0; column < into.columns(); ++column)
            into.set(column, row,
                     (1.0 - share) * before.velocity.at(column, row) + share * after.velocity.at(column, row));
}

BatchTrack::BatchTrack(Simulation& run) : run_(run), before_time_(run.time()), after_time_(run.time()) {}

std::optional<Divergence> BatchTrack::follow(double time, Snapshot& into, const std::atomic<bool>& abandon) {
    while (run_.time() < time - same_time) {
        // States cost a copy of every mass: only those on both sides of a frame are taken.
        before_.reset();
        if (time < run_.time() + batch_seconds - same_time)
            before_ = after_ ? std::move(after_) : std::optional(run_.state());
        after_.reset();
        before_time_ = run_.time();
        if (const auto divergence = run_.advance_batch(&abandon)) return divergence;
        after_time_ = run_.time();
        if (abandon) return {};
    }
    run_.snapshot(into);
    run_.velocity(into);
    if (run_.time() <= time + same_time || !before_) return {};
    if (!after_) after_ = run_.state();
    between(*before_, before_time_, *after_, after_time_, time, into.position);
    velocity_between(*before_, before_time_, *after_, after_time_, time, into.velocity);
    into.time = time;
    return {};
}

}  // namespace drapeau

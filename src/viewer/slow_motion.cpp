#include "slow_motion.hpp"

#include <algorithm>

namespace drapeau {

namespace {

bool alike(const Snapshot& a, const Snapshot& b) {
    return a.position.columns() == b.position.columns() && a.position.rows() == b.position.rows();
}

void mix(const FieldBuffer<float>& from, const FieldBuffer<float>& to, float weight, FieldBuffer<float>& into) {
    for (int c = 0; c < 3; ++c) {
        const auto& early = from.component(c);
        std::transform(early.begin(), early.end(), to.component(c).begin(), into.component(c).begin(),
                       [weight](float a, float b) { return a + weight * (b - a); });
    }
}

}  // namespace

void interpolate(const Snapshot& from, const Snapshot& to, double share, Snapshot& into) {
    into = to;
    if (!alike(from, to) || share >= 1.0) return;
    const float weight = float(std::max(0.0, share));
    mix(from.position, to.position, weight, into.position);
    if (from.velocity.columns() == to.velocity.columns() && from.velocity.rows() == to.velocity.rows())
        mix(from.velocity, to.velocity, weight, into.velocity);
    into.time = from.time + share * (to.time - from.time);
}

void SlowMotion::add(const Snapshot& newest) {
    if (!empty() && (newest.time < waiting_.back().time || !alike(newest, waiting_.back()))) forget();
    if (empty()) time_ = newest.time;
    if (!empty() && newest.time == waiting_.back().time)
        waiting_.back() = newest;
    else
        waiting_.push_back(newest);
}

void SlowMotion::pass(double seconds) {
    if (empty()) return;
    time_ = std::min(time_ + seconds, waiting_.back().time);
    while (waiting_.size() > 1 && waiting_[1].time <= time_) waiting_.pop_front();
}

void SlowMotion::show(Snapshot& into) const {
    if (waiting_.size() == 1) {
        into = waiting_.front();
        return;
    }
    const double from = waiting_[0].time, to = waiting_[1].time;
    interpolate(waiting_[0], waiting_[1], (time_ - from) / (to - from), into);
}

}  // namespace drapeau

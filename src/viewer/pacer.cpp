#include "pacer.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>

namespace drapeau {

namespace {

constexpr int max_waiting = 3;       // batches not done when more are asked for: settings take effect at once
constexpr int max_asked = 15;        // batches at once, after a slow frame
constexpr double min_window = 0.25;  // s before a factor is shown
constexpr double window = 1.0;       // s the averages run over

}  // namespace

int Pacer::batches(double seconds, int backlog, double speed) {
    owed_ += seconds;
    const int due = int(owed_ / batch_seconds);
    const int granted = backlog >= max_waiting * std::max(1.0, speed) ? 0 : std::min(due, max_asked);
    owed_ -= granted * batch_seconds;
    owed_ = std::min(owed_, batch_seconds);
    return granted;
}

void Pacer::observe(double wall, double simulated) {
    if (!samples_.empty() && simulated < samples_.back().simulated) forget();
    samples_.push_back({wall, simulated});
    while (samples_.size() > 2 && wall - samples_.front().wall > window) samples_.pop_front();
    const double span = wall - samples_.front().wall;
    if (span < min_window) return;
    factor_ = (simulated - samples_.front().simulated) / span;
    frame_ = span / double(samples_.size() - 1);
}

void Pacer::forget() {
    samples_.clear();
    factor_ = 0.0;
}

}  // namespace drapeau

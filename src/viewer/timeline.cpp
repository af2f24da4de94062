#include "timeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drapeau {

namespace {

constexpr double dense_seconds = 2.0;     // the age at which gaps are about twice as long as now
constexpr double same_time = 1e-7;        // s: times that differ by rounding
constexpr double shortest_history = 5.0;  // s, that a budget is to last for at least

}  // namespace

bool Timeline::wants(double time) const {
    if (moments_.empty()) return true;
    const double share = double(bytes_) / double(moments_.size()) / double(budget_);  // of one moment
    return time >= last() + std::max(frame, shortest_history * share) - 1e-3 * frame;
}

void Timeline::add(KeptMomentPtr moment) {
    drop_after(moment->time() - 2.0 * same_time);
    count(*moment, 1);
    moments_.push_back(std::move(moment));
    while (moments_.size() > 2 && last() - first() > span_) {
        count(*moments_.front(), -1);
        moments_.pop_front();
    }
    while (moments_.size() > 2 && bytes_ > budget_) thin();
}

void Timeline::drop_after(double time) {
    while (!moments_.empty() && last() > time + same_time) {
        count(*moments_.back(), -1);
        moments_.pop_back();
    }
}

void Timeline::clear() {
    moments_.clear();
    parts_.clear();
    bytes_ = 0;
}

void Timeline::shrink() {
    budget_ = std::max<std::size_t>(1, std::min(budget_, bytes_) / 2);
    while (moments_.size() > 2 && bytes_ > budget_) thin();
}

KeptMomentPtr Timeline::nearest(double time) const {
    const KeptMomentPtr early = at_or_before(time), late = after(time);
    if (!early || !late) return early ? early : late;
    return time - early->time() <= late->time() - time ? early : late;
}

KeptMomentPtr Timeline::before(double time) const {
    return at_or_before(time - 2.0 * same_time);
}

KeptMomentPtr Timeline::after(double time) const {
    const auto found = first_after(time);
    return found == moments_.end() ? nullptr : *found;
}

KeptMomentPtr Timeline::at_or_before(double time) const {
    const auto found = first_after(time);
    return found == moments_.begin() ? nullptr : *std::prev(found);
}

std::vector<Sample> Timeline::samples(double from) const {
    std::vector<Sample> samples;
    for (auto moment = first_after(from - 2.0 * same_time); moment != moments_.end(); ++moment)
        samples.push_back((*moment)->sample);
    return samples;
}

std::deque<KeptMomentPtr>::const_iterator Timeline::first_after(double time) const {
    return std::upper_bound(moments_.begin(), moments_.end(), time + same_time,
                            [](double t, const KeptMomentPtr& moment) { return t < moment->time(); });
}

/// What a moment holds is counted once, however many hold it.
void Timeline::count(const KeptMoment& moment, int change) {
    moment.run->each_part([&](const void* which, std::size_t bytes) {
        Part& part = parts_[which];
        if (part.users == 0) part.bytes = bytes;
        const int before = std::exchange(part.users, part.users + change);
        if (before == 0) bytes_ += part.bytes;
        if (part.users > 0) return;
        bytes_ -= part.bytes;
        parts_.erase(which);
    });
}

/// Neither the oldest nor the newest goes.
void Timeline::thin() {
    double least = std::numeric_limits<double>::infinity();
    auto goes = moments_.begin() + 1;
    for (auto moment = goes; moment + 1 != moments_.end(); ++moment) {
        const double gap = (*(moment + 1))->time() - (*(moment - 1))->time();
        const double age = last() - (*moment)->time();
        const double left = gap / (age + dense_seconds);
        if (left < least) least = left, goes = moment;
    }
    count(**goes, -1);
    moments_.erase(goes);
}

}  // namespace drapeau

// Pull history: which hand held the cloth in which step, so that steps that are taken again are pulled as they were.
#pragma once

#include "drapeau/pull.hpp"

#include <algorithm>
#include <deque>
#include <limits>

namespace drapeau {

class PullHistory {
public:
    /// From this step on, instead of what was said of it and of later ones before.
    void set(long long step, const std::optional<Pull>& pull) {
        while (!changes_.empty() && changes_.back().step >= step) changes_.pop_back();
        if (at(step) == pull) return;
        changes_.push_back({step, pull});
        // A state to return to is at most some hundreds of batches old, and a batch brings one change.
        constexpr std::size_t most = 1024;
        if (changes_.size() > most) changes_.pop_front();
    }
    void clear() { changes_.clear(); }

    std::optional<Pull> at(long long step) const {
        const auto later = after(step);
        return later == changes_.begin() ? std::nullopt : std::prev(later)->pull;
    }
    /// The first step after this one at which that changes, at most `last`.
    long long until(long long step, long long last) const {
        const auto later = after(step);
        return later == changes_.end() ? last : std::min(last, later->step);
    }

private:
    struct Change {
        long long step;
        std::optional<Pull> pull;
    };
    std::deque<Change>::const_iterator after(long long step) const {
        return std::find_if(changes_.begin(), changes_.end(), [&](const Change& change) { return change.step > step; });
    }

    std::deque<Change> changes_;  // the earliest first
};

}  // namespace drapeau

// Timeline: the moments of a flight that are kept, the newest last, within a budget of memory.
//
// Where there is no more room the moment goes whose loss leaves the smallest gap for its age: the last seconds stay
// frame by frame, older ones grow sparser, and what is older than the span goes first.
#pragma once

#include "run/simulation.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

namespace drapeau {

struct Moment;

/// What is plotted of a moment.
struct Sample {
    double time = 0.0;     // s
    double read_at = 0.0;  // s: energy and stretch may be a few frames older
    double energy = 0.0;   // J: of motion, of springs and of height
    double stretch = 0.0;  // share, of the longest spring
    double height = 0.0;   // m, of the tip
    double error = 0.0;    // m/s; NAN while it is not known
    double step = 0.0;     // share of the limit; NAN where there is none
};

/// A moment as it was: all that the flight goes on from, and what the window showed of it.
struct KeptMoment {
    std::shared_ptr<const KeptRun> run;
    std::shared_ptr<const Moment> moment;  // without the snapshot, which the run holds
    Sample sample;

    double time() const { return sample.time; }
};
using KeptMomentPtr = std::shared_ptr<const KeptMoment>;

class Timeline {
public:
    static constexpr std::size_t usual_budget = std::size_t(256) << 20;  // bytes
    static constexpr double longest = 600.0;                             // s
    static constexpr double frame = 1.0 / 60.0;                          // s

    explicit Timeline(std::size_t budget = usual_budget, double span = longest) : budget_(budget), span_(span) {}

    /// Whether a moment at `time` (s) is one to keep: a frame after the last, or more where so large a flag would fill
    /// the budget within five seconds.
    bool wants(double time) const;
    /// The newest from now on; those at its time and later are no part of the flight any more.
    void add(KeptMomentPtr moment);
    void drop_after(double time);  // s
    void clear();
    /// Less memory from now on: half of what is used now.
    void shrink();

    bool empty() const { return moments_.empty(); }
    std::size_t size() const { return moments_.size(); }
    std::size_t bytes() const { return bytes_; }
    double first() const { return moments_.empty() ? 0.0 : moments_.front()->time(); }  // s
    double last() const { return moments_.empty() ? 0.0 : moments_.back()->time(); }    // s

    // Each null where there is none.
    KeptMomentPtr nearest(double time) const;
    KeptMomentPtr before(double time) const;         // the last that is earlier
    KeptMomentPtr after(double time) const;          // the first that is later
    KeptMomentPtr at_or_before(double time) const;   // the last that is no later
    std::vector<Sample> samples(double from) const;  // from that time (s) on

private:
    struct Part {
        std::size_t bytes = 0;
        int users = 0;
    };

    std::deque<KeptMomentPtr>::const_iterator first_after(double time) const;
    void count(const KeptMoment& moment, int change);
    void thin();

    std::size_t budget_, bytes_ = 0;
    double span_;  // s
    std::deque<KeptMomentPtr> moments_;
    std::unordered_map<const void*, Part> parts_;  // several moments may share one
};

}  // namespace drapeau

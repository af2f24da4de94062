// Reference run: the same flag from the same moment on, under the same wind, computed far more accurately on a spare
// thread, and how far the run that it follows has gone from it. The two are compared at equal times: where the run was
// is kept until the reference has come as far.
#pragma once

#include "run/simulation.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace drapeau {

class ReferenceRun {
public:
    /// What is known of the two at a moment.
    struct Gap {
        Snapshot snapshot;      // of the reference
        double since = 0.0;     // s, when both were the same
        double dt = 0.0;        // s, the reference's step
        double rms = 0.0;       // m, root mean square over the masses that are free
        double greatest = 0.0;  // m, of any mass
    };

    /// Begins where the run is at `time` (s). What goes wrong is told by trouble().
    ReferenceRun(const Scene& scene, State<double> start, double time);
    /// Ends promptly, whatever is under way.
    ~ReferenceRun();
    ReferenceRun(const ReferenceRun&) = delete;
    ReferenceRun& operator=(const ReferenceRun&) = delete;

    /// Where the run is now, at the end of a batch. While many moments wait, further ones are not compared.
    void follow(const Snapshot& run);
    bool take(Gap& newest);       // false if nothing is new since the last call
    bool behind() const;          // whether moments wait to be compared
    void wait();                  // until none does
    std::string trouble() const;  // why it does not go on; empty while it does

private:
    void work(const Scene& scene, const State<double>& start, double time);
    bool catch_up(Simulation& reference, const Snapshot& run);

    mutable std::mutex mutex_;
    std::condition_variable wanted_, finished_;
    std::deque<Snapshot> waiting_;  // of the run, the oldest first
    std::optional<Gap> newest_;
    std::string trouble_;
    std::atomic<bool> ending_{false};
    double since_;
    std::thread thread_;
};

/// The scene as its reference is computed: by rk4 in double, at half of its automatic step. Throws InputError where
/// rk4 has none.
Scene reference_of(Scene scene);

}  // namespace drapeau

// Film flight: flies a scene on a thread of its own and gives the masses of a film's frames, a few ahead.
#pragma once

#include "film_plan.hpp"
#include "run/simulation.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace drapeau {

/// Where a run is between two batches: what a copy of it goes on from.
struct Fork {
    Scene scene;
    State<double> state;
    double time = 0.0;  // s
};

struct FilmFrame {
    Snapshot snapshot;
    double force_scale = 1.0;  // N, of the reddest force colour
};

/// Where the masses are on the way from one of two places to the other: `share` of the second.
void blend(FieldBuffer<float>& position, const FieldBuffer<float>& other, double share);

class FilmFlight {
public:
    /// From the scene's start, or from a fork of a run.
    FilmFlight(const FilmPlan& plan, const Scene& scene, std::optional<Fork> start);
    /// Ends promptly, whatever is under way.
    ~FilmFlight();
    FilmFlight(const FilmFlight&) = delete;
    FilmFlight& operator=(const FilmFlight&) = delete;

    std::optional<FilmFrame> take();  // the next frame, if it is there
    void wait(double seconds);        // until it is, or trouble; at most so long
    std::string trouble() const;      // why there are no more; empty while there are
    bool diverged() const;

private:
    void work(const Scene& scene, std::optional<Fork> start);
    void fly(const Scene& scene, std::optional<Fork> start);
    void give(FilmFrame frame);

    FilmPlan plan_;
    std::atomic<bool> ending_{false};

    mutable std::mutex mutex_;
    std::condition_variable wanted_, given_;
    std::deque<FilmFrame> ready_;
    std::string trouble_;
    bool diverged_ = false;
    std::thread thread_;
};

}  // namespace drapeau

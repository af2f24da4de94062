// SimulationThread: the run on a thread of its own, in batches of 1/60 s that the render loop asks for. Settings go in
// and the newest moment comes out between batches, so nothing the simulation does stalls the picture.
#pragma once

#include "run/simulation.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace drapeau {

/// What the simulation made of the last request. All of one moment.
struct Moment {
    Snapshot snapshot;
    Readings readings;
    double dt = 0.0;  // s, the step in use
    int steps_per_batch = 0;
    double stability_limit = 0.0;          // s; 0: no step is stable
    double step_seconds = 0.0;             // wall-clock of one step, averaged over the last batch
    Scene scene;                           // the scene that runs
    long long revision = 0;                // of that scene, as given to apply or restart
    std::optional<Divergence> divergence;  // the run stands until the scene changes or starts again
    std::string refusal;                   // why the last scene given was refused; empty if it was taken
    long long refused_revision = -1;
};

class SimulationThread {
public:
    explicit SimulationThread(Simulation simulation);
    ~SimulationThread();
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    void apply(const Scene& scene, long long revision);    // the run goes on with these settings
    void restart(const Scene& scene, long long revision);  // from the scene's start
    void ask_batches(int count);
    void ask_step();

    int backlog() const;        // batches asked for and not done
    bool take(Moment& newest);  // false if nothing is new since the last call
    void wait();                // until all that was asked is done

private:
    struct Change {
        Scene scene;
        long long revision = 0;
        bool from_start = false;
    };

    void ask_change(const Scene& scene, long long revision, bool from_start);
    void work();
    void carry_out(const Change& change);
    bool advance(bool single_step);
    void publish();

    Simulation simulation_;  // only the thread touches it once it runs
    Moment now_;

    mutable std::mutex mutex_;
    std::condition_variable wanted_, finished_;
    std::optional<Change> change_;
    int batches_ = 0;
    int single_steps_ = 0;
    bool busy_ = false;
    bool ending_ = false;
    std::atomic<bool> abandon_{false};  // the batch under way is not worth finishing
    std::optional<Moment> newest_;

    std::thread thread_;
};

}  // namespace drapeau

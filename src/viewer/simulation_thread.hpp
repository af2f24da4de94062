// SimulationThread: the run on a thread of its own, in batches of 1/60 s that the render loop asks for. Settings go in
// and the newest moment comes out between batches, so nothing the simulation does stalls the picture.
#pragma once

#include "film_flight.hpp"
#include "picture.hpp"
#include "run/reference_run.hpp"
#include "run/simulation.hpp"
#include "thread_choice.hpp"
#include "timeline.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace drapeau {

/// What the simulation made of the last request. All of one moment.
struct Moment {
    Snapshot snapshot;
    Readings readings;
    double dt = 0.0;  // s, the step in use
    long long steps_per_batch = 0;
    StableStep stability_limit;            // of the closed bound
    std::optional<StableStep> live_limit;  // here and now; see Simulation
    std::string limit_remark;              // that the step is past it; empty where it is not
    std::string method_remark;             // what the method does by nature at this step; empty where nothing
    std::string step_reason;               // what the step in use was chosen by
    std::optional<ErrorEstimate> error;    // the newest, of the step in use
    std::string lowered_because;           // why an automatic step is smaller than usual; empty where it is not
    std::string precision_remark;          // what float cannot honour; empty where all is well
    std::string start_remark;              // what a start is not that it may seem; empty where all is well
    double pull_force = 0.0;               // N, of the hand that holds the cloth, mean of the last batch
    double step_seconds = 0.0;             // wall-clock of one step, averaged over the last batch
    SpringKinds kinds;                     // of springs, as they are drawn
    Scene scene;                           // the scene that runs
    long long revision = 0;                // of that scene, as given to apply or restart
    std::optional<Divergence> divergence;  // the run stands until the scene changes or starts again
    std::string refusal;                   // why the last scene given was refused; empty if it was taken
    long long refused_revision = -1;
    std::string failure;  // why the run stands for another reason than divergence, until a scene is taken
    long long failed_revision = -1;

    bool stands() const { return divergence || !failure.empty(); }
};

/// How many threads the simulation may use on so many processors (0: unknown): one is left to the picture.
int simulation_threads(unsigned processors);

class SimulationThread {
public:
    /// At most `threads` share a step, whatever the scene becomes: as many of them as are fastest (see ThreadChoice);
    /// it stays on one where the system gives no more. Errors are measured on a spare one; whether they are waited for,
    /// so that every run shows the same, `errors` says.
    explicit SimulationThread(Simulation simulation, int threads = 1,
                              ErrorWatch::Mode errors = ErrorWatch::Mode::aside);
    /// Ends promptly, whatever is under way.
    ~SimulationThread();
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    void apply(const Scene& scene, long long revision);    // the run goes on with these settings
    void restart(const Scene& scene, long long revision);  // from the scene's start
    /// From a kept moment, as it was but for these settings; what came after it is dropped, and so is what was asked.
    void go_on_from(KeptMomentPtr from, const Scene& scene, long long revision);
    void ask_batches(int count);
    void ask_step();
    void ask_part(long long steps);  // of a batch, for slow motion

    /// The flight as far as it is kept. Asking never waits for the simulation.
    struct History {
        double from = 0.0, to = 0.0;  // s
        std::size_t moments = 0, bytes = 0;
    };
    History history() const;
    /// A question to the timeline, at once: `ask(const Timeline&)`.
    template <class Ask>
    auto kept(Ask&& ask) const {
        const std::lock_guard lock(mutex_);
        return ask(std::as_const(timeline_));
    }
    /// A hand that pulls at the cloth in the batches to come, or none; a reference begins anew when it lets go.
    void pull(const std::optional<Pull>& by);
    /// Whether a reference run follows, from where the run is when it begins. It begins anew with every change.
    void follow_reference(bool wanted);
    void restart_reference();
    /// The present moment once more, its readings its own: while time passes they are a few batches old.
    void ask_now();
    /// Whether moments come with velocities, from the present one on.
    void give_velocities(bool wanted);
    bool take_reference(ReferenceRun::Gap& newest);  // false if nothing is new since the last call
    std::string reference_trouble() const;           // why it does not go on; empty while it does

    /// Asks for where the run is between two batches, for a copy that flies on by itself.
    void ask_fork();
    std::optional<Fork> take_fork();  // none until it is there

    int backlog() const;        // batches asked for and not done
    bool idle() const;          // nothing is asked for, under way or new
    bool settling() const;      // whether a flag that starts hanging has been coming to rest for a moment
    bool take(Moment& newest);  // false if nothing is new since the last call
    void wait();                // until all that was asked is done

private:
    struct Change {
        Scene scene;
        long long revision = 0;
        bool from_start = false;
        KeptMomentPtr from{};  // the moment to go on from; null: the present one
    };

    void ask_change(Change change);
    void work();
    bool carry_out(const std::optional<Change>& change, long long steps);
    void take_over(const Change& change);
    void put_back(const Change& change);
    void share_as_chosen();
    void go_back(const KeptMomentPtr& from);
    void keep(bool whatever_the_time) noexcept;
    bool advance(long long steps);
    void begin_reference();
    void give_fork() noexcept;
    void give_now() noexcept;
    bool gives_velocities() const;
    void publish(bool fresh);
    void fail(std::string_view why) noexcept;

    ThreadChoice threads_;  // of a step
    int sharing_;           // of them, now
    ErrorWatch::Mode errors_;
    Simulation simulation_;  // only the thread touches it and the next two once it runs
    Moment now_;
    bool failed_ = false;

    mutable std::mutex mutex_;
    std::condition_variable wanted_, finished_;
    std::optional<Change> change_;
    std::optional<Pull> pull_;
    std::shared_ptr<ReferenceRun> reference_;  // only the thread replaces it
    bool reference_wanted_ = false, reference_asked_ = false;
    bool velocities_wanted_ = false, now_asked_ = false;
    Timeline timeline_;
    bool fork_asked_ = false;
    std::optional<Fork> fork_;
    int batches_ = 0;
    int single_steps_ = 0;
    long long part_ = 0;  // steps
    bool busy_ = false;
    std::optional<std::chrono::steady_clock::time_point> settles_since_;  // a start that may be hanging
    bool ending_ = false;
    std::atomic<bool> abandon_{false};  // the batch under way is not worth finishing
    std::optional<Moment> newest_;
    std::string failure_;  // told with whatever moment is at hand: there may be no memory for another
    long long failed_revision_ = -1;
    bool failure_new_ = false;  // not taken yet

    std::thread thread_;
};

}  // namespace drapeau

#include "simulation_thread.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace drapeau {

SimulationThread::SimulationThread(Simulation simulation) : simulation_(std::move(simulation)) {
    now_.scene = simulation_.scene();
    publish();
    thread_ = std::thread([this] { work(); });
}

SimulationThread::~SimulationThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        abandon_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

void SimulationThread::apply(const Scene& scene, long long revision) {
    ask_change(scene, revision, false);
}
void SimulationThread::restart(const Scene& scene, long long revision) {
    ask_change(scene, revision, true);
}

void SimulationThread::ask_change(const Scene& scene, long long revision, bool from_start) {
    {
        const std::lock_guard lock(mutex_);
        from_start = from_start || (change_ && change_->from_start);
        change_ = Change{.scene = scene, .revision = revision, .from_start = from_start};
        abandon_ = true;
    }
    wanted_.notify_one();
}

void SimulationThread::ask_batches(int count) {
    {
        const std::lock_guard lock(mutex_);
        batches_ += count;
    }
    wanted_.notify_one();
}

void SimulationThread::ask_step() {
    {
        const std::lock_guard lock(mutex_);
        ++single_steps_;
    }
    wanted_.notify_one();
}

int SimulationThread::backlog() const {
    const std::lock_guard lock(mutex_);
    return batches_;
}

bool SimulationThread::take(Moment& newest) {
    const std::lock_guard lock(mutex_);
    if (!newest_) return false;
    newest = std::move(*newest_);
    newest_.reset();
    return true;
}

void SimulationThread::wait() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return !busy_ && !change_ && batches_ == 0 && single_steps_ == 0; });
}

// One request at a time, a change before any time passes; others may ask meanwhile.
void SimulationThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wanted_.wait(lock, [this] { return ending_ || change_ || batches_ > 0 || single_steps_ > 0; });
        if (ending_) return;
        busy_ = true;
        const std::optional<Change> change = std::exchange(change_, std::nullopt);
        const bool single = !change && single_steps_ > 0;
        abandon_ = false;
        lock.unlock();
        bool advanced = false;
        if (change)
            carry_out(*change);
        else
            advanced = advance(single);
        publish();
        lock.lock();
        if (now_.divergence)
            batches_ = single_steps_ = 0;
        else if (advanced)
            --(single ? single_steps_ : batches_);
        busy_ = false;
        finished_.notify_all();
    }
}

void SimulationThread::carry_out(const Change& change) {
    try {
        if (change.from_start)
            simulation_ = Simulation(change.scene);
        else
            simulation_.change(change.scene);
        now_.scene = change.scene;
        now_.revision = change.revision;
        now_.divergence.reset();
        now_.refusal.clear();
        now_.refused_revision = -1;
    } catch (const std::exception& refused) {
        now_.refusal = refused.what();
        now_.refused_revision = change.revision;
    }
}

// False if it was abandoned for something that matters more.
bool SimulationThread::advance(bool single_step) {
    if (now_.divergence) return false;
    const auto steps_before = simulation_.steps();
    const auto begin = std::chrono::steady_clock::now();
    now_.divergence = single_step ? simulation_.advance_steps(1) : simulation_.advance_batch(&abandon_);
    if (simulation_.steps() == steps_before) return false;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    now_.step_seconds = passed.count() / (single_step ? 1 : simulation_.steps_per_batch());
    return true;
}

void SimulationThread::publish() {
    simulation_.snapshot(now_.snapshot);
    now_.readings = simulation_.readings();
    now_.dt = simulation_.dt();
    now_.steps_per_batch = simulation_.steps_per_batch();
    now_.stability_limit = simulation_.stability_limit();
    const std::lock_guard lock(mutex_);
    newest_ = now_;
}

}  // namespace drapeau

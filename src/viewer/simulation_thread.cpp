// The window's side of the simulation thread: what is asked of it and what it gives. Nothing here waits for a batch but
// wait().
#include "simulation_thread.hpp"

#include <chrono>
#include <utility>

namespace drapeau {

void SimulationThread::apply(const Scene& scene, long long revision) {
    ask_change({.scene = scene, .revision = revision});
}
void SimulationThread::restart(const Scene& scene, long long revision) {
    ask_change({.scene = scene, .revision = revision, .from_start = true});
}
void SimulationThread::go_on_from(KeptMomentPtr from, const Scene& scene, long long revision) {
    ask_change({.scene = scene, .revision = revision, .from = std::move(from)});
}

void SimulationThread::ask_change(Change change) {
    {
        const std::lock_guard lock(mutex_);
        if (change.from) batches_ = 0, single_steps_ = 0, part_ = 0;
        if (change_ && !change.from) {  // what was asked for before it and is not begun
            change.from_start = change.from_start || change_->from_start;
            if (!change.from_start) change.from = std::move(change_->from);
        }
        change_ = std::move(change);
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

void SimulationThread::ask_part(long long steps) {
    {
        const std::lock_guard lock(mutex_);
        part_ = steps;
    }
    wanted_.notify_one();
}

void SimulationThread::pull(const std::optional<Pull>& by) {
    {
        const std::lock_guard lock(mutex_);
        const bool let_go = pull_ && !by;
        pull_ = by;
        if (!let_go || !reference_wanted_) return;
        reference_asked_ = true;
    }
    wanted_.notify_one();
}

SimulationThread::History SimulationThread::history() const {
    const std::lock_guard lock(mutex_);
    return {timeline_.first(), timeline_.last(), timeline_.size(), timeline_.bytes()};
}

void SimulationThread::follow_reference(bool wanted) {
    {
        const std::lock_guard lock(mutex_);
        if (wanted == reference_wanted_) return;
        reference_wanted_ = wanted;
        reference_asked_ = true;
    }
    wanted_.notify_one();
}

void SimulationThread::restart_reference() {
    {
        const std::lock_guard lock(mutex_);
        reference_asked_ = true;
    }
    wanted_.notify_one();
}

void SimulationThread::ask_now() {
    {
        const std::lock_guard lock(mutex_);
        now_asked_ = true;
    }
    wanted_.notify_one();
}

void SimulationThread::give_velocities(bool wanted) {
    {
        const std::lock_guard lock(mutex_);
        if (wanted == velocities_wanted_) return;
        velocities_wanted_ = wanted;
        now_asked_ = now_asked_ || wanted;
    }
    wanted_.notify_one();
}

bool SimulationThread::gives_velocities() const {
    const std::lock_guard lock(mutex_);
    return velocities_wanted_;
}

bool SimulationThread::take_reference(ReferenceRun::Gap& newest) {
    const std::lock_guard lock(mutex_);
    return reference_ && reference_->take(newest);
}

std::string SimulationThread::reference_trouble() const {
    const std::lock_guard lock(mutex_);
    return reference_ ? reference_->trouble() : "";
}

void SimulationThread::ask_fork() {
    {
        const std::lock_guard lock(mutex_);
        fork_asked_ = true;
    }
    wanted_.notify_one();
}

std::optional<Fork> SimulationThread::take_fork() {
    const std::lock_guard lock(mutex_);
    return std::exchange(fork_, std::nullopt);
}

int SimulationThread::backlog() const {
    const std::lock_guard lock(mutex_);
    return batches_ + (part_ > 0 ? 1 : 0);
}

bool SimulationThread::idle() const {
    const std::lock_guard lock(mutex_);
    return !busy_ && !change_ && batches_ == 0 && single_steps_ == 0 && part_ == 0 && !newest_ && !failure_new_ &&
           !reference_asked_ && !now_asked_ && !fork_asked_ && !(reference_ && reference_->behind());
}

bool SimulationThread::settling() const {
    constexpr std::chrono::milliseconds a_moment(150);
    const std::lock_guard lock(mutex_);
    return settles_since_ && std::chrono::steady_clock::now() - *settles_since_ > a_moment;
}

bool SimulationThread::take(Moment& newest) {
    const std::lock_guard lock(mutex_);
    if (!newest_ && !failure_new_) return false;
    if (newest_) newest = std::move(*newest_);
    newest.failure = failure_;
    newest.failed_revision = failed_revision_;
    newest_.reset();
    failure_new_ = false;
    return true;
}

void SimulationThread::wait() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] {
        return !busy_ && !change_ && batches_ == 0 && single_steps_ == 0 && part_ == 0 && !reference_asked_ &&
               !now_asked_;
    });
    const std::shared_ptr<ReferenceRun> reference = reference_;
    lock.unlock();
    if (reference) reference->wait();
}

// One request at a time, a change before any time passes; others may ask meanwhile.

}  // namespace drapeau

// The simulation thread's own side: what it does with what was asked.
#include "simulation_thread.hpp"

#include "findings.hpp"

#include "io/error.hpp"
#include "measure/flight.hpp"
#include "run/settle.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace drapeau {

namespace {

constexpr std::size_t longest_failure = 240;  // bytes; reserved, so that a lack of memory can be told

std::string refusal_for_lack_of_memory(const FlagSettings& flag) {
    return "not enough memory for this flag: " + std::to_string(flag.columns) + " x " + std::to_string(flag.rows) +
           " masses; fewer columns or rows need less";
}

// Fewer threads are slower and give the same flag: no reason to refuse it.
void share_among(Simulation& simulation, int threads) {
    try {
        simulation.use_threads(threads);
    } catch (const InputError&) {
        simulation.use_threads(1);
    }
}

SpringKinds kinds_of(const Model& model) {
    const Grid& grid = model.grid;
    const auto kind = [](bool exists, double rest, double stiffness) {
        return exists ? SpringKind{float(rest), float(stiffness)} : SpringKind{};
    };
    const double k = model.springs.stiffness, diagonal = model.springs.diagonal_stiffness.value_or(0.0);
    return {.fly = kind(grid.columns > 1, grid.pitch_x, k),
            .hoist = kind(grid.rows > 1, grid.pitch_y, model.springs.along_hoist * k),
            .diagonal = kind(model.has_diagonals(), grid.pitch_diagonal(), diagonal)};
}

Sample sample_of(const Moment& moment, const Model& model) {
    const Tip tip = tip_of(model);
    const Readings& r = moment.readings;
    const auto share_of = [&](const StableStep& limit) {
        return limit.is_finite() ? moment.dt / limit.seconds() : NAN;
    };
    return {.time = moment.snapshot.time,
            .read_at = r.time,
            .energy = r.kinetic_energy + r.spring_energy + r.gravity_energy,
            .stretch = r.max_stretch,
            .height = moment.snapshot.position.at(tip.column, tip.row).y,
            .error = moment.error && moment.error->resolved() ? moment.error->rate : NAN,
            .step = share_of(moment.live_limit && moment.live_limit->is_finite() ? *moment.live_limit
                                                                                 : moment.stability_limit)};
}

}  // namespace

int simulation_threads(unsigned processors) {
    return std::max(1, static_cast<int>(processors) - 1);
}

SimulationThread::SimulationThread(Simulation simulation, int threads, ErrorWatch::Mode errors)
    : threads_(threads), sharing_(threads_.threads()), errors_(errors), simulation_(std::move(simulation)) {
    share_among(simulation_, sharing_);
    simulation_.watch_error(errors_);
    failure_.reserve(longest_failure);
    now_.scene = simulation_.scene();
    publish(true);
    keep(true);
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

void SimulationThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wanted_.wait(lock, [this] {
            return ending_ || change_ || batches_ > 0 || single_steps_ > 0 || part_ > 0 || reference_asked_ ||
                   now_asked_ || fork_asked_;
        });
        if (ending_) return;
        busy_ = true;
        const bool reference_only = !change_ && batches_ == 0 && single_steps_ == 0 && part_ == 0;
        const bool moves = std::exchange(now_asked_, false);
        const bool begins = std::exchange(reference_asked_, false), forks = std::exchange(fork_asked_, false);
        const std::optional<Change> change = std::exchange(change_, std::nullopt);
        if (change && change->scene.flag.start == Start::hanging) settles_since_ = std::chrono::steady_clock::now();
        int* const asked = change ? nullptr : single_steps_ > 0 ? &single_steps_ : batches_ > 0 ? &batches_ : nullptr;
        const long long steps = asked == &single_steps_ ? 1 : asked || change ? 0 : part_;
        abandon_ = false;
        simulation_.pull(pull_);
        lock.unlock();
        if (begins) begin_reference();  // whatever becomes of a change, which begins one of its own
        if (forks) give_fork();
        if (moves && reference_only) give_now();
        const bool advanced = !reference_only && carry_out(change, steps);
        lock.lock();
        if (now_.divergence || failed_)
            batches_ = single_steps_ = 0, part_ = 0;
        else if (advanced && asked && *asked > 0)
            --*asked;
        else if (advanced && !asked)
            part_ = 0;
        settles_since_.reset();
        busy_ = false;
        finished_.notify_all();
    }
}

// Whatever goes wrong becomes a message; the program goes on. True if time advanced.
bool SimulationThread::carry_out(const std::optional<Change>& change, long long steps) {
    bool advanced = false;
    try {
        // Readings of a few batches ago do while the flag plays, not where somebody looks at one moment.
        const bool fresh = change || steps > 0;
        if (change)
            take_over(*change);
        else
            advanced = advance(steps);
        publish(fresh || now_.divergence);
        keep(change || steps == 1 || now_.divergence);
    } catch (const SettlingAbandoned&) {
        put_back(*change);
    } catch (const std::bad_alloc&) {
        fail("not enough memory to go on with this flag; fewer columns or rows need less");
    } catch (const std::exception& failure) {
        fail(failure.what());
    } catch (...) {
        fail("the simulation failed for an unknown reason");
    }
    return advanced;
}

// A scene that is refused leaves the run as it was.
void SimulationThread::take_over(const Change& change) {
    try {
        if (change.from_start) {
            Simulation next(change.scene, &abandon_);
            share_among(next, sharing_);
            next.watch_error(errors_);
            simulation_ = std::move(next);
            const std::lock_guard lock(mutex_);
            timeline_.clear();
        } else {
            if (change.from) go_back(change.from);
            if (!change.from || physics_of(change.scene) != physics_of(simulation_.scene()))
                simulation_.change(change.scene, &abandon_);
        }
    } catch (const std::bad_alloc&) {
        now_.refusal = refusal_for_lack_of_memory(change.scene.flag);
        now_.refused_revision = change.revision;
        return;
    } catch (const std::exception& refused) {
        now_.refusal = refused.what();
        now_.refused_revision = change.revision;
        return;
    }
    threads_.forget();
    now_.scene = change.scene;
    now_.revision = change.revision;
    now_.divergence.reset();
    begin_reference();
    now_.refusal.clear();
    now_.refused_revision = -1;
    failed_ = false;
}

/// Masses, settings and readings as they were; what came after is no part of the flight.
void SimulationThread::go_back(const KeptMomentPtr& from) {
    simulation_.restore(*from->run);
    const long long revision = now_.revision, refused = now_.refused_revision;
    now_ = *from->moment;
    now_.revision = revision;
    now_.refused_revision = refused;
    failed_ = false;
    const std::lock_guard lock(mutex_);
    timeline_.drop_after(from->time());
}

/// The present moment as one to come back to. It goes without where there is no memory for it.
void SimulationThread::keep(bool whatever_the_time) noexcept {
    {
        const std::lock_guard lock(mutex_);
        if (failed_ || !(whatever_the_time || timeline_.wants(simulation_.time()))) return;
    }
    const Sample sample = sample_of(now_, simulation_.model());
    Snapshot aside = std::exchange(now_.snapshot, {});  // the run holds the same in full
    KeptMomentPtr kept;
    try {
        kept =
            std::make_shared<KeptMoment>(KeptMoment{simulation_.keep(), std::make_shared<const Moment>(now_), sample});
    } catch (const std::exception&) {
    }
    now_.snapshot = std::move(aside);
    const std::lock_guard lock(mutex_);
    try {
        if (kept) return timeline_.add(std::move(kept));
    } catch (const std::bad_alloc&) {
    }
    timeline_.shrink();
}

/// A start that was abandoned for a newer change is one that the newer change still wants.
void SimulationThread::put_back(const Change& change) {
    const std::lock_guard lock(mutex_);
    if (change_ && change.from_start) change_->from_start = true;
}

/// Where the system has no more threads, or no memory for them, it goes on with those it has.
void SimulationThread::share_as_chosen() {
    if (threads_.threads() == sharing_) return;
    try {
        simulation_.use_threads(threads_.threads());
        sharing_ = threads_.threads();
    } catch (const std::exception&) {
        threads_.forget();
    }
}

// So many steps, or a batch where that is 0. False if it was abandoned for something that matters more.
bool SimulationThread::advance(long long steps) {
    if (now_.divergence || failed_) return false;
    share_as_chosen();
    const auto steps_before = simulation_.steps();
    const auto begin = std::chrono::steady_clock::now();
    now_.divergence = steps > 0 ? simulation_.advance_steps(steps, &abandon_) : simulation_.advance_batch(&abandon_);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    const auto taken = simulation_.steps() - steps_before;
    // None or fewer: abandoned, or put back to a good state.
    if (taken > 0) now_.step_seconds = passed.count() / double(taken);
    if (taken > 0 && steps == 0) threads_.took(now_.step_seconds);
    return taken != 0;
}

/// From where the run is, or none. What it needs may be refused to it alone: the run goes on.
void SimulationThread::begin_reference() {
    std::shared_ptr<ReferenceRun> next;
    {
        const std::lock_guard lock(mutex_);
        if (!reference_wanted_ && !reference_) return;
        std::swap(next, reference_);
        if (!reference_wanted_) return;
    }
    next.reset();  // ends before the other begins
    try {
        next = std::make_shared<ReferenceRun>(simulation_.scene(), simulation_.state(), simulation_.time());
        Snapshot here;
        simulation_.snapshot(here);
        next->follow(here);
    } catch (const std::exception&) {  // no memory or no thread
        return;
    }
    const std::lock_guard lock(mutex_);
    reference_ = std::move(next);
}

/// Without memory for it there is none: whoever asked may ask again.
void SimulationThread::give_fork() noexcept {
    try {
        Fork fork{.scene = now_.scene, .state = simulation_.state(), .time = simulation_.time()};
        const std::lock_guard lock(mutex_);
        fork_ = std::move(fork);
    } catch (const std::exception&) {
    }
}

/// The present moment again, with what is asked of it now.
void SimulationThread::give_now() noexcept {
    try {
        publish(true);
    } catch (const std::exception&) {  // it comes with the next batch
    }
}

void SimulationThread::publish(bool fresh) {
    simulation_.snapshot(now_.snapshot);
    if (gives_velocities())
        simulation_.velocity(now_.snapshot);
    else
        now_.snapshot.velocity = {};
    now_.readings = fresh ? simulation_.readings() : simulation_.recent_readings();
    now_.dt = simulation_.dt();
    now_.steps_per_batch = simulation_.steps_per_batch();
    now_.stability_limit = simulation_.stability_limit();
    now_.live_limit = simulation_.live_limit();
    now_.limit_remark = simulation_.limit_remark();
    now_.method_remark = simulation_.method_remark();
    now_.step_reason = simulation_.step_reason();
    now_.error = simulation_.error();
    now_.lowered_because = simulation_.lowered_because();
    now_.precision_remark = simulation_.precision_remark();
    now_.start_remark = simulation_.start_remark();
    now_.pull_force = simulation_.pull_force();
    now_.kinds = kinds_of(simulation_.model());
    if (reference_) reference_->follow(now_.snapshot);
    Moment moment = now_;
    const std::lock_guard lock(mutex_);
    newest_ = std::move(moment);
    if (!failed_) failure_.clear();
}

// Takes no memory: what was reserved holds the beginning of any text.
void SimulationThread::fail(std::string_view why) noexcept {
    failed_ = true;
    const std::lock_guard lock(mutex_);
    failure_.assign(why.substr(0, longest_failure));
    failed_revision_ = now_.revision;
    failure_new_ = true;
}

}  // namespace drapeau

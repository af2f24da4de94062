#include "run/reference_run.hpp"

#include "io/error.hpp"
#include "run/step_aside.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace drapeau {
namespace {

constexpr double same_time = 1e-3 * batch_seconds;  // s

std::size_t most_waiting(const Snapshot& run) {
    constexpr std::size_t most_bytes = 64 << 20;
    const auto masses =
        static_cast<std::size_t>(run.position.columns()) * static_cast<std::size_t>(run.position.rows());
    return std::max<std::size_t>(2, most_bytes / (3 * sizeof(float) * masses));
}

void measure(const Model& model, const FieldBuffer<float>& run, ReferenceRun::Gap& gap) {
    double squares = 0.0, greatest = 0.0;
    long long free = 0;
    for (int j = 0; j < run.rows(); ++j)
        for (int i = 0; i < run.columns(); ++i) {
            if (model.held(i, j)) continue;
            const glm::dvec3 d = glm::dvec3(run.at(i, j)) - glm::dvec3(gap.snapshot.position.at(i, j));
            const double square = d.x * d.x + d.y * d.y + d.z * d.z;
            squares += square;
            greatest = std::max(greatest, square);
            ++free;
        }
    gap.rms = free > 0 ? std::sqrt(squares / static_cast<double>(free)) : 0.0;
    gap.greatest = std::sqrt(greatest);
}

}  // namespace

Scene reference_of(Scene scene) {
    constexpr double finer = 0.5;
    scene.time = {.method = method_id<Rk4>, .dt = {}, .precision = Precision::double_precision};
    scene.flag.start = Start::flat;  // how it starts takes time and does not matter
    scene.flag.disturbance = 0.0;
    scene.time.dt = finer * Simulation(scene).dt();
    return scene;
}

ReferenceRun::ReferenceRun(const Scene& scene, State<double> start, double time)
    : since_(time), thread_([this, scene, start = std::move(start), time] { work(scene, start, time); }) {}

ReferenceRun::~ReferenceRun() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

void ReferenceRun::follow(const Snapshot& run) {
    {
        const std::lock_guard lock(mutex_);
        if (!trouble_.empty() || waiting_.size() >= most_waiting(run)) return;
        waiting_.push_back(run);
    }
    wanted_.notify_one();
}

bool ReferenceRun::take(Gap& newest) {
    const std::lock_guard lock(mutex_);
    if (!newest_) return false;
    newest = std::move(*newest_);
    newest_.reset();
    return true;
}

bool ReferenceRun::behind() const {
    const std::lock_guard lock(mutex_);
    return !waiting_.empty();
}

void ReferenceRun::wait() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return waiting_.empty(); });
}

std::string ReferenceRun::trouble() const {
    const std::lock_guard lock(mutex_);
    return trouble_;
}

// One moment of the run after the other; the last word of a reference that cannot go on is why.
void ReferenceRun::work(const Scene& scene, const State<double>& start, double time) {
    step_aside();
    std::string trouble;
    try {
        Simulation reference(reference_of(scene));
        reference.put(start, time);
        std::unique_lock lock(mutex_);
        while (trouble.empty()) {
            wanted_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (ending_) return;
            const Snapshot run = waiting_.front();
            lock.unlock();
            const bool goes_on = catch_up(reference, run);
            lock.lock();
            if (ending_) return;
            waiting_.pop_front();
            if (!goes_on) trouble = "it diverged itself";
            finished_.notify_all();
        }
    } catch (const InputError& refused) {
        trouble = refused.what();
    } catch (const std::exception&) {
        trouble = "there is not enough memory";
    }
    const std::lock_guard lock(mutex_);
    trouble_ = trouble;
    waiting_.clear();
    finished_.notify_all();
}

/// Goes on until the run's moment and compares the two there. A moment that lies between two batches, or before where
/// the reference is, is passed over. False if the reference diverged.
bool ReferenceRun::catch_up(Simulation& reference, const Snapshot& run) {
    while (reference.time() < run.time - same_time)
        if (reference.advance_batch(&ending_) || ending_) return ending_.load();
    if (reference.time() > run.time + same_time) return true;
    Gap gap;
    gap.since = since_;
    gap.dt = reference.dt();
    reference.snapshot(gap.snapshot);
    measure(reference.model(), run.position, gap);
    const std::lock_guard lock(mutex_);
    newest_ = std::move(gap);
    return true;
}

}  // namespace drapeau

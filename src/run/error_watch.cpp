#include "run/error_watch.hpp"

#include "run/step_aside.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace drapeau {
namespace {

using namespace std::chrono_literals;

template <class Job>
bool is_done(const Job& job) {
    return job.result.wait_for(0s) != std::future_status::timeout;
}

}  // namespace

void ErrorWatch::restart() {
    batch_ = 0;
    std::erase_if(dropped_, [](const Job& job) { return is_done(job); });
    if (!job_) return;
    *job_->stop = true;
    dropped_.push_back(std::move(*job_));
    job_.reset();
}

std::optional<ErrorEstimate> ErrorWatch::take(Mode mode, const std::atomic<bool>* abandon, bool& abandoned) {
    if (!job_ || batch_ < job_->batch + delay) return {};
    while (mode == Mode::awaited && job_->result.wait_for(10ms) == std::future_status::timeout) {
        if (!abandon || !abandon->load(std::memory_order_relaxed)) continue;
        abandoned = true;
        return {};
    }
    if (mode != Mode::awaited && !is_done(*job_)) return {};
    const ErrorEstimate estimate = job_->result.get();
    job_.reset();
    return estimate;
}

void ErrorWatch::begin_batch(Mode mode, Engine& engine, const TimeSettings& settings, Precision precision,
                             const Progress& now) {
    if (mode == Mode::off || job_ || batch_ % period != first) return;
    auto stop = std::make_unique<std::atomic<bool>>(false);
    const bool aside = mode == Mode::aside;
    auto work = [aside, settings, precision, dt = now.clock.dt, model = engine.model(), stop = stop.get(),
                 window = ErrorWindow{engine.state(now.time()), now.time()}] {
        if (aside) step_aside();
        return measure_error(model, settings.method, precision, window, dt, stop, settings.half_kick_start);
    };
    try {
        // Without a thread to spare, what is waited for is computed when it is asked for.
        const auto policy = !spare_thread_ ? std::launch::deferred
                            : aside        ? std::launch::async
                                           : std::launch::async | std::launch::deferred;
        job_ = Job{std::move(stop), std::async(policy, std::move(work)), batch_};
    } catch (const std::system_error&) {
    }
}

}  // namespace drapeau

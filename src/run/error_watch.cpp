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
    ask(mode,
        std::make_shared<Question>(Question{.method = settings.method,
                                            .half_kick_start = settings.half_kick_start,
                                            .precision = precision,
                                            .dt = now.clock.dt,
                                            .model = engine.model(),
                                            .window = {engine.state(now.time()), now.time()}}),
        batch_);
}

void ErrorWatch::ask(Mode mode, std::shared_ptr<const Question> question, long long batch) {
    auto stop = std::make_unique<std::atomic<bool>>(false);
    const bool aside = mode == Mode::aside;
    auto work = [aside, question, stop = stop.get()] {
        if (aside) step_aside();
        return question->answer(stop);
    };
    try {
        // Without a thread to spare, what is waited for is computed when it is asked for.
        const auto policy = !spare_thread_ ? std::launch::deferred
                            : aside        ? std::launch::async
                                           : std::launch::async | std::launch::deferred;
        auto result = std::async(policy, std::move(work));
        job_ = Job{std::move(question), std::move(stop), std::move(result), batch};
    } catch (const std::system_error&) {
    }
}

ErrorWatch::Kept ErrorWatch::keep() const {
    return {batch_, job_ ? job_->batch : 0, job_ ? job_->question : nullptr};
}

void ErrorWatch::restore(const Kept& kept, Mode mode) {
    restart();
    batch_ = kept.batch;
    if (kept.question) ask(mode, kept.question, kept.asked);
}

ErrorEstimate ErrorWatch::Question::answer(const std::atomic<bool>* stop) const {
    return measure_error(model, method, precision, window, dt, stop, half_kick_start);
}

std::size_t ErrorWatch::Question::bytes() const {
    std::size_t sum = sizeof *this;
    for (const auto* field : {&window.state.position, &window.state.velocity})
        for (int c = 0; c < 3; ++c) sum += field->component(c).size() * sizeof(double);
    return sum;
}

}  // namespace drapeau

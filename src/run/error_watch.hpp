// Error watch: estimates of a run's error made on a spare thread while it goes on.
//
// Every 60 batches the state is copied and the window that follows is run again (error_estimate.hpp). What comes of it
// takes effect 30 batches later: where the step depends on it the run waits for it then, so that the same scene takes
// the same steps on any machine; where it is only shown, it is shown when it is there.
#pragma once

#include "run/error_estimate.hpp"
#include "run/watch.hpp"

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

namespace drapeau {

class ErrorWatch {
public:
    enum class Mode { off, aside, awaited };

    static constexpr long long period = 60, delay = 30;  // batches
    // A change of settings is followed by others while a slider is dragged: nothing is begun until it rests.
    static constexpr long long first = 6;  // batch

    ErrorWatch() = default;
    ErrorWatch(const ErrorWatch&) = delete;
    ~ErrorWatch() { restart(); }

    /// Estimates that are waited for are computed by the thread that asks, when it asks: its processor time is then all
    /// that the run takes.
    void use_own_thread() { spare_thread_ = false; }
    /// What is under way is of no use any more; batches are counted anew.
    void restart();

    /// At the beginning of a batch: the estimate that takes effect now, if one does. Waits for it if `mode` says so,
    /// unless `abandon` is set meanwhile: `abandoned` is then true.
    std::optional<ErrorEstimate> take(Mode mode, const std::atomic<bool>* abandon, bool& abandoned);
    /// After that: copies the state if a window begins with this batch.
    void begin_batch(Mode mode, Engine& engine, const TimeSettings& settings, Precision precision, const Progress& now);
    void end_batch() { ++batch_; }

    /// All that an estimate follows from.
    struct Question {
        Method method{};
        bool half_kick_start = false;
        Precision precision{};
        double dt = 0.0;  // s
        Model model;
        ErrorWindow window;

        ErrorEstimate answer(const std::atomic<bool>* stop) const;
        std::size_t bytes() const;
    };
    /// Where the watch stands at a moment, to go on from there: what is under way is asked again.
    struct Kept {
        long long batch = 0, asked = 0;
        std::shared_ptr<const Question> question;  // null: none is under way
    };
    Kept keep() const;
    void restore(const Kept& kept, Mode mode);

private:
    struct Job {
        std::shared_ptr<const Question> question;
        std::unique_ptr<std::atomic<bool>> stop;
        std::future<ErrorEstimate> result;
        long long batch = 0;
    };

    void ask(Mode mode, std::shared_ptr<const Question> question, long long batch);

    bool spare_thread_ = true;
    long long batch_ = 0;
    std::optional<Job> job_;
    std::vector<Job> dropped_;  // told to stop; their end is not waited for until the watch's own
};

}  // namespace drapeau

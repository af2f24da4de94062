// Measuring: what settings cost and how wrong they are, and what each part of a scene does, found out on a thread of
// its own, which lets others go first, while the flag flies.
#pragma once

#include "measure/price_study.hpp"
#include "measure/trade_sweep.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace drapeau {

/// Settings of one scene, each flown for a tenth of a second: the span that the window's error is of.
struct MeasuredTrade {
    Scene scene;
    double since = 0.0, seconds = 0.0;  // s, where what was compared began, and how long it was
    std::vector<Measured> points;
    std::vector<std::size_t> front;  // the efficient ones, the cheapest first
    std::vector<char> automatic;     // of each point: an automatic step may be as long
};

/// What each part of a scene costs and matters.
struct MeasuredPrices {
    Scene scene;
    double since = 0.0, seconds = 0.0;  // s, as above
    std::vector<Priced> parts;          // those that a scene can be without
    double ms_per_second = NAN;         // of the scene as given
};

enum class MeasuringSubject { trade, prices };

/// What became of a measurement.
struct MeasuredScene {
    std::optional<MeasuredTrade> trade;
    std::optional<MeasuredPrices> prices;
    std::string trouble;  // why there is neither
    MeasuringSubject subject{};
};

class Measuring {
public:
    using Subject = MeasuringSubject;

    Measuring();
    /// Ends promptly, whatever is under way.
    ~Measuring();
    Measuring(const Measuring&) = delete;
    Measuring& operator=(const Measuring&) = delete;

    /// In place of what is under way.
    void measure(Subject subject, const Scene& scene);
    void stop();  // what is ready and was not taken is forgotten too

    /// What is under way or waited for, and the share of it that is done.
    std::optional<Subject> under_way() const;
    double share() const;
    /// What is ready and was not taken yet.
    std::optional<MeasuredScene> take();
    void wait();  // until nothing is under way

private:
    struct Wanted {
        Subject subject{};
        Scene scene;
    };

    void work(const std::stop_token& ending);
    MeasuredScene measured(const Wanted& wanted, const std::stop_token& stop);
    Tick tick(const std::stop_token& stop);

    mutable std::mutex mutex_;
    std::condition_variable_any begun_;
    std::condition_variable finished_;
    std::optional<Wanted> wanted_;  // not begun
    std::optional<Subject> now_;    // under way
    std::stop_source abandon_;      // what is under way
    double share_ = 0.0;
    std::optional<MeasuredScene> ready_;

    std::jthread thread_;  // the last member: it is joined first
};

}  // namespace drapeau

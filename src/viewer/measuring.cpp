#include "measuring.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/budget.hpp"
#include "measure/setting_choice.hpp"
#include "measure/trade_analysis.hpp"
#include "run/step_aside.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace drapeau {

namespace {

constexpr double budget = 60.0;         // s
constexpr double for_flights = 0.6;     // s of those, of points flown once: the dear ones are left out
constexpr long long error_batches = 6;  // of 1/60 s: a tenth of a second
constexpr double resolved = 1e-9;       // m
constexpr double settle = 2.0;          // s that the scene swings in before

/// Nobody waits for what is measured any more.
struct Abandoned {};

MeasuredScene trouble(const std::string& why) {
    MeasuredScene failed;
    failed.trouble = why;
    return failed;
}

MeasuredScene diverged(const std::string& how) {
    return trouble("the scene diverges before anything can be compared: " + how);
}

/// The points that there is time for, the cheapest first.
std::vector<std::size_t> affordable(const TradeSweep& sweep) {
    std::vector<std::size_t> places;
    double seconds = 0.0;
    for (const std::size_t n : sweep.cheapest_first()) {
        seconds += sweep.seconds_of_flight(n);
        if (seconds > for_flights && !places.empty()) break;
        places.push_back(n);
    }
    return places;
}

/// Their errors, then rounds of all of them for what they cost.
std::vector<Measured> measured_points(const TradeSweep& sweep, const std::vector<std::size_t>& order,
                                      double share_before, const Tick& tick) {
    constexpr double for_errors = 0.5;  // of the time, about
    const double all = std::max(sweep.seconds_of_points(order), 1e-9);
    double share = share_before;
    const auto go_on = [&](double by) { tick(share += by * (1.0 - share_before)); };
    std::vector<Measured> points(sweep.count());
    for (std::size_t n = 0; n < points.size(); ++n) points[n].point = sweep.point(n);
    int rounds = 0;
    for (const std::size_t n : order) {
        points[n] = sweep.measure_one(n, [&](double) { tick(share); });
        if (points[n].is_measured()) rounds += TradeSweep::rounds_of(points[n]);
        go_on(for_errors * sweep.seconds_of_points({n}) / all);
    }
    std::vector<int> timed(points.size(), 0);
    for (int done = 0; done < rounds;)
        for (const std::size_t n : order) {
            Measured& point = points[n];
            if (!point.is_measured() || timed[n]++ >= TradeSweep::rounds_of(point)) continue;
            point.ms_per_second = std::min(point.ms_per_second, sweep.time_again(point));
            go_on((1.0 - for_errors) / rounds);
            ++done;
        }
    return points;
}

MeasuredScene measured_trade(const Scene& scene, const Tick& tick) {
    TradeRequest request;
    request.scene = scene;
    request.settle = settle;
    request.batches = error_batches;
    request.batches_are_given = true;
    request.budget = budget;
    request.enough = resolved;
    request.counts_work = true;  // the picture and the run take time too
    TradeSweep sweep(request);
    const std::vector<std::size_t> places = affordable(sweep);
    const double before = sweep.seconds_before();
    const double share_before = before / (before + sweep.seconds_of_points(places));
    if (const auto how = sweep.prepare([&](double share) { tick(share * share_before); })) return diverged(*how);
    if (sweep.is_beyond_horizon())
        return trouble("within a tenth of a second the motion is chaotic: no setting is nearer to it than another");
    MeasuredTrade trade;
    trade.scene = scene;
    trade.since = sweep.grounds().front().stretch.time;
    trade.seconds = sweep.grounds().front().stretch.seconds();
    trade.points = measured_points(sweep, places, share_before, tick);
    trade.front = efficient_front(trade.points);
    trade.automatic = within_automatic_step(scene, trade.points);
    MeasuredScene measurement;
    measurement.trade = std::move(trade);
    return measurement;
}

MeasuredScene measured_prices(const Scene& scene, const Tick& tick) {
    constexpr double prepared = 0.2, flown = 0.7;  // shares of the work, about
    PriceRequest request;
    request.scene = scene;
    request.settle = settle;
    request.budget = budget;
    request.counts_work = true;
    double share = 0.0;
    PriceStudy study(request, [&](double) { tick(share); });
    std::vector<std::size_t> places;
    for (std::size_t n = 0; n < study.parts().size(); ++n)
        if (study.parts()[n].impossible.empty()) places.push_back(n);
    if (const auto how = study.prepare(places.size())) return diverged(*how);
    if (study.is_beyond_horizon()) return trouble("the motion is chaotic: it is another one whatever is left out");
    MeasuredPrices found;
    found.scene = scene;
    found.since = study.ground().stretch.time;
    found.seconds = study.ground().stretch.seconds();
    share = prepared;
    for (const std::size_t n : places) {
        found.parts.push_back(study.measure_one(n));
        tick(share += (flown - prepared) / static_cast<double>(places.size()));
    }
    const std::vector<PartCost> costs = study.time(places);
    for (std::size_t n = 0; n < costs.size(); ++n) found.parts[n].cost = costs[n];
    if (!costs.empty()) found.ms_per_second = costs.front().scene_ms;
    MeasuredScene measurement;
    measurement.prices = std::move(found);
    return measurement;
}

}  // namespace

Measuring::Measuring() : thread_([this](const std::stop_token& ending) { work(ending); }) {}

Measuring::~Measuring() {
    const std::lock_guard lock(mutex_);
    abandon_.request_stop();
    thread_.request_stop();
}

void Measuring::measure(Subject subject, const Scene& scene) {
    {
        const std::lock_guard lock(mutex_);
        abandon_.request_stop();
        ready_.reset();
        wanted_ = Wanted{subject, scene};
        share_ = 0.0;
    }
    begun_.notify_one();
}

void Measuring::stop() {
    const std::lock_guard lock(mutex_);
    abandon_.request_stop();
    wanted_.reset();
    ready_.reset();
}

std::optional<Measuring::Subject> Measuring::under_way() const {
    const std::lock_guard lock(mutex_);
    if (wanted_) return wanted_->subject;
    return now_ && !abandon_.stop_requested() ? now_ : std::nullopt;
}

double Measuring::share() const {
    const std::lock_guard lock(mutex_);
    return share_;
}

std::optional<MeasuredScene> Measuring::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(ready_, std::nullopt);
}

void Measuring::wait() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return !wanted_ && !now_; });
}

Tick Measuring::tick(const std::stop_token& stop) {
    return [this, stop](double share) {
        if (stop.stop_requested()) throw Abandoned{};
        const std::lock_guard lock(mutex_);
        share_ = std::max(share_, share);
    };
}

MeasuredScene Measuring::measured(const Wanted& wanted, const std::stop_token& stop) {
    try {
        return wanted.subject == Subject::trade ? measured_trade(wanted.scene, tick(stop))
                                                : measured_prices(wanted.scene, tick(stop));
    } catch (const BudgetError& wrong) {
        return trouble("swinging in alone would take about " + quantity(wrong.least(), "s", 2) +
                       "; a coarser grid takes less, and drapeau-lab as long as it is given");
    } catch (const std::bad_alloc&) {
        return trouble("not enough memory");
    } catch (const std::exception& wrong) {
        return trouble(wrong.what());
    }
}

void Measuring::work(const std::stop_token& ending) {
    step_aside(3);  // somebody waits for it
    std::unique_lock lock(mutex_);
    while (begun_.wait(lock, ending, [this] { return wanted_.has_value(); }) && !ending.stop_requested()) {
        const Wanted wanted = *std::exchange(wanted_, std::nullopt);
        now_ = wanted.subject;
        abandon_ = {};
        share_ = 0.0;
        const std::stop_token stop = abandon_.get_token();
        lock.unlock();
        std::optional<MeasuredScene> found;
        try {
            found = measured(wanted, stop);
            found->subject = wanted.subject;
        } catch (const Abandoned&) {
        }
        lock.lock();
        now_.reset();
        if (found && !stop.stop_requested()) ready_ = std::move(found);
        finished_.notify_all();
    }
}

}  // namespace drapeau

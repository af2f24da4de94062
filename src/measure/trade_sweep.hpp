// Trade sweep: the points, the references they are judged by, and their measurement one after the other within a
// budget. It prints nothing; who asks is told how far it is.
#pragma once

#include "measure/basis.hpp"
#include "measure/comparison_request.hpp"
#include "measure/trade_analysis.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

struct TradeRequest : ComparisonRequest {
    TradeChoice choice;
    double enough = 0.0;  // m: no better reference is wanted, root mean square
};

struct Recommendation {
    std::optional<std::size_t> place;  // in the points; nothing if none meets the tolerance twice
    std::vector<Measured> rejected;  // cheaper ones, that met it in the sweep: as they were in the stretch that follows
    Measured confirmed;              // the point in the stretch that follows
    Measured verified;               // and in the one after that
};

class TradeSweep {
public:
    /// Lists the points and finds out how fast this machine is. Throws InputError where the scene is impossible, no
    /// mass is free, or the budget does not even suffice for the reference.
    explicit TradeSweep(const TradeRequest& request);

    const std::vector<Variant>& variants() const { return variants_; }
    std::size_t count() const { return points_.size(); }
    double estimate() const { return estimate_; }  // s of time, at most the budget

    /// The points from the cheapest on, as they are measured and dealt to shards; those that --budget leaves out too.
    std::vector<std::size_t> cheapest_first() const;
    const TradePoint& point(std::size_t n) const { return points_[n]; }
    /// s that measuring so many of them takes about; of all with those that come before.
    double seconds_of_points(const std::vector<std::size_t>& places) const;
    double seconds_of_flight(std::size_t n) const;  // of one of them, once
    double seconds_before() const;

    /// Lets the scene swing in and flies the references. Returns why it diverged, if it did.
    std::optional<std::string> prepare(const Tick& tick);
    /// What that found; and the same taken from elsewhere, for a report.
    Basis basis() const;
    void restore(const Basis& basis);
    const std::vector<Footing>& grounds() const { return grounds_; }
    const Growth& growth() const { return growth_; }
    bool is_shortened() const { return is_shortened_; }  // the time compared, for the motion is chaotic
    /// The time (s) after which neighbouring motions are the tolerance apart, or a millimetre.
    double horizon() const;
    bool is_beyond_horizon() const;
    const TipStatistics& reference_tip() const { return reference_tip_; }

    /// Every point: its errors, the cheapest ones first; then rounds of all for what they cost.
    std::vector<Measured> measure(const Tick& tick);
    /// One of them, whatever time it takes.
    Measured measure_one(std::size_t n, const Tick& tick) const;
    /// How often a point is timed after its error was measured, and once more: ms of processor time a simulated second.
    static int rounds_of(const Measured& measured);
    double time_again(const Measured& measured) const;

    /// The cheapest point that meets the tolerance here and in the stretch that follows, checked in the one after that:
    /// what is right once may be luck. Each stretch has a reference of its own.
    Recommendation recommend(const std::vector<Measured>& points, const Tick& tick) const;
    const TradeRequest& request() const { return request_; }

private:
    double elapsed() const;
    double seconds_of(const TradePoint& point) const;
    Stretch stretch_of(const Model& model, const State<double>& start, double time) const;
    /// `enough` (m): no better reference is wanted.
    Footing ground_of(const Variant& variant, const State<double>& start, double time, double enough,
                      const Tick& tick) const;
    Footing after(const Footing& scene, const Tick& tick) const;
    Measured judged(const TradePoint& point, const Footing& scene) const;
    void find_horizon(const State<double>& start, double time, const Tick& tick);
    double least_seconds() const;
    void list_affordable();
    std::string left_out(std::size_t n) const;

    TradeRequest request_;
    std::vector<Variant> variants_;
    std::vector<Model> models_;
    std::vector<TradePoint> points_;
    std::vector<char> is_left_out_;   // of the points: too expensive
    double unit_ = 0.0;               // s, what one unit of step_cost takes in double, or counts for
    double pace_ = 1.0;               // s here for a s as work is counted
    double reference_seconds_ = 0.0;  // for each variant
    double estimate_ = 0.0;
    double began_ = 0.0;
    std::vector<Footing> grounds_;
    Growth growth_;
    TipStatistics reference_tip_;
    bool is_shortened_ = false;
};

}  // namespace drapeau

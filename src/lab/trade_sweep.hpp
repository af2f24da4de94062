// Trade sweep: the points, the references they are judged by, and their measurement one after the other within a
// budget. It prints nothing; who asks is told how far it is.
#pragma once

#include "trade_analysis.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drapeau::lab {

struct TradeRequest {
    Scene scene;
    TradeChoice choice;
    double settle = 2.0;  // s that the scene swings in before
    // Of 1/60 s, that are compared. Unless they were asked for: fewer where the motion is chaotic, so that errors of
    // steps grow no more than a thousandfold.
    long long batches = 30;
    bool batches_are_given = false;
    double budget = 120.0;            // s of time on the wall
    std::optional<double> tolerance;  // m
};

/// Is told the share of the work that is done.
using Tick = std::function<void(double)>;

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

    /// Lets the scene swing in and flies the references. Returns why it diverged, if it did.
    std::optional<std::string> prepare(const Tick& tick);
    const std::vector<Ground>& grounds() const { return grounds_; }
    const Growth& growth() const { return growth_; }
    bool is_shortened() const { return is_shortened_; }  // the time compared, for the motion is chaotic
    /// The time (s) after which neighbouring motions are the tolerance apart, or a millimetre.
    double horizon() const;
    bool is_beyond_horizon() const;
    TipStatistics reference_tip() const;

    /// Every point: its errors, the cheapest ones first; then rounds of all for what they cost.
    std::vector<Measured> measure(const Tick& tick);

    /// The cheapest point that meets the tolerance here and in the stretch that follows, checked in the one after that:
    /// what is right once may be luck. Each stretch has a reference of its own.
    Recommendation recommend(const std::vector<Measured>& points, const Tick& tick) const;
    const TradeRequest& request() const { return request_; }

private:
    double elapsed() const;
    double seconds_of(const TradePoint& point) const;
    Stretch stretch_of(const Model& model, const State<double>& start, double time) const;
    /// `enough` (m): no better reference is wanted.
    Ground ground_of(const Variant& variant, const State<double>& start, double time, double enough,
                     const Tick& tick) const;
    Ground after(const Ground& scene, const Tick& tick) const;
    Measured judged(const TradePoint& point, const Ground& scene) const;
    void find_horizon(const State<double>& start, double time, const Tick& tick);
    double least_seconds() const;
    void list_affordable();

    TradeRequest request_;
    std::vector<Variant> variants_;
    std::vector<Model> models_;
    std::vector<TradePoint> points_;
    std::vector<char> is_left_out_;   // of the points: too expensive
    double unit_ = 0.0;               // s, what one unit of step_cost takes in double
    double reference_seconds_ = 0.0;  // for each variant
    double estimate_ = 0.0;
    double began_ = 0.0;
    std::vector<Ground> grounds_;
    Growth growth_;
    bool is_shortened_ = false;
};

}  // namespace drapeau::lab

// Trade measure: the error and the cost of one point. Nothing here prints or decides what is measured.
#pragma once

#include "measure/reference_flight.hpp"
#include "measure/tip_statistics.hpp"
#include "measure/trade_point.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace drapeau {

/// What the points of a variant are judged by. The reference may be left empty, but of the scene as given.
struct Footing {
    Variant variant;
    Model model;
    Stretch stretch;
    ReferenceFlight reference;
    std::unique_ptr<Yardstick> yardstick;
};

struct Measured {
    enum class Outcome { measured, diverged, refused, left_out };

    TradePoint point;
    Outcome outcome = Outcome::left_out;
    Apart error;            // from the reference of the scene as given, at the scene's masses; NAN where it has none
    Apart error_in_time;    // from the reference of its own variant: the same for the scene as given
    double known_to = 0.0;  // m, the error of that reference
    TipStatistics tip;
    double ms_per_second = NAN;       // ms of processor time a simulated second; NAN where it diverged
    long long force_evaluations = 0;  // in the stretch, or until it diverged
    double diverged_at = NAN;         // s after the stretch began
    std::string remark;               // why it was refused or left out, or how it diverged
    double first_cost = 0.0;          // s of processor time that the stretch took when the error was measured

    bool is_measured() const { return outcome == Outcome::measured; }
    /// Nearer to the reference than ten times what that is known to.
    bool is_below_resolution() const;
};

/// Runs the stretch as the programs do, one batch after the other, with the energy ledger. `scene` is the ground of the
/// scene as given; a variant whose own reference is empty is judged by that alone. A run that diverges, or that the
/// programs refuse, is a result; one is left out once `may_go_on()` is false after a batch.
Measured measure_errors(const TradePoint& point, const Footing& ground, const Footing& scene,
                        const std::function<bool()>& may_go_on);

/// Runs it again for what it costs, warm: ms of processor time a simulated second. As often as fits in some
/// milliseconds, the stretch as a whole each time.
double measure_cost(const Measured& measured, const Footing& ground);

}  // namespace drapeau

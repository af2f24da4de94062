// Price study: what each part of a scene costs and matters, and the smallest scene within a tolerance. It prints
// nothing; who asks is told how far it is.
#pragma once

#include "measure/basis.hpp"
#include "measure/comparison_request.hpp"
#include "measure/price_cost.hpp"
#include "measure/price_effect.hpp"
#include "measure/price_part.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

using PriceRequest = ComparisonRequest;

/// What leaving a part out saves, as its scene and the scene as given took turns.
struct PartCost {
    double scene_ms = NAN;  // ms of processor time a simulated second, of the scene as given: the least of its turns
    Share own;              // of that, with the step that is taken without the part
    Share same_step;        // at the scene's own step
};

/// What a part costs and matters. Costs are NAN where they could not be measured.
struct Priced {
    ScenePart part;
    Effect effect;
    PartCost cost;
    double dt = NAN;     // s, the step that is taken without it
    std::string remark;  // why the scene without it cannot be run
};

struct Prices {
    std::vector<Priced> parts;
    Cost scene;  // as given
};

/// One more part left out.
struct Dropped {
    ScenePart part;
    Effect effect;                // of all that is left out up to it
    Share saving;                 // of the scene's time, of all that is left out up to it
    Share bought;                 // of it, of this one
    std::optional<double> alone;  // m, root mean square: the effect of this one alone, where that was measured
};

struct Reduction {
    std::vector<Dropped> dropped;
    std::vector<Dropped> put_back;   // within the tolerance at first, but not in the stretch that follows
    std::vector<Effect> failed;      // as each of those was there, with all before it
    std::optional<Dropped> nearest;  // of those that would save time: the least effect, where none was dropped
    Scene scene;                     // what is left
    Effect confirmed, check;         // in the stretch that follows, and in the one after that
    Cost before, after;              // in that one, run as a whole
    Share measured;                  // of the time that is saved there
    bool is_cut_short = false;       // by the budget

    double promised() const { return dropped.empty() ? 0.0 : dropped.back().saving.value; }
};

class PriceStudy {
public:
    /// Throws InputError where the scene is impossible, no mass is free, nothing of it can be left out, or the budget
    /// does not suffice.
    PriceStudy(const PriceRequest& request, Tick tick);

    const std::vector<ScenePart>& parts() const { return parts_; }
    const PriceRequest& request() const { return request_; }
    /// s of time, at most the budget, for all parts; or for so many, whatever the budget.
    double estimate() const { return std::min(request_.budget, seconds_for(parts_.size())); }
    double seconds_for(std::size_t parts) const;

    /// Lets the scene swing in, flies its reference, and runs it at its own step. Returns how it diverged, if it did.
    /// `parts`: how many will be measured, for what the tick is told.
    std::optional<std::string> prepare(std::size_t parts);
    /// What that found; and the same taken from elsewhere, for a report.
    Basis basis() const;
    double dt() const { return scene_.dt; }  // s, the scene's own step
    void restore(const Basis& basis, double dt);
    const Footing& ground() const { return *ground_; }
    const Growth& growth() const { return growth_; }
    bool is_shortened() const { return is_shortened_; }
    double horizon() const;
    bool is_beyond_horizon() const;
    const TipStatistics& reference_tip() const { return reference_tip_; }

    /// Every part: its effect, while the budget lasts; then what they cost.
    Prices measure();
    /// One of them without its cost: where work is counted, whatever time it takes.
    Priced measure_one(std::size_t n);
    /// What some of them cost: their scenes take turns.
    std::vector<PartCost> time(const std::vector<std::size_t>& places) const;

    /// Leaves out, one after the other, what changes the motion least and saves time, as long as all of it together
    /// stays within the tolerance; then looks at what is left in the stretch that follows (where it is too much, the
    /// last ones are put back) and checks it in the one after that. Where work was counted, it has the budget's time
    /// for itself: what it leaves out follows from times anyway.
    Reduction reduce(const Prices& prices);

private:
    struct Candidate;

    double elapsed() const;
    bool may_go_on() const { return elapsed() < deadline_; }
    void tell() const;
    void list_times();
    double goal() const;
    Footing ground_at(const State<double>& start, double time) const;
    Footing after(const Footing& ground) const;
    Effect effect(const Scene& scene, const Footing& ground);
    Costs costs(const std::vector<Scene>& scenes, const Footing& ground, double share) const;
    std::vector<Candidate> candidates(const Scene& scene, const Prices& prices, const std::vector<ScenePart>& useless);
    bool drop_one(Reduction& reduction, const Prices& prices, std::vector<ScenePart>& useless);
    void confirm(Reduction& reduction);

    PriceRequest request_;
    Tick tick_;
    std::vector<ScenePart> parts_;
    Model model_;
    double unit_ = 0.0;               // s, what one unit of step_cost takes in double, or counts for
    double pace_ = 1.0;               // s here for a s as work is counted
    double a_second_ = 0.0;           // s of those, of a simulated second at rk4's limit
    double search_seconds_ = 0.0;     // that a reference may take
    double reference_seconds_ = 0.0;  // that the scene's took
    double effect_seconds_ = 0.0;     // that the last effect took
    double swing_seconds_ = 0.0;      // that swinging in takes
    double usual_seconds_ = 0.0;      // that a reference, or an effect, takes usually
    double expected_ = 0.0;           // s on the wall, of all that is done
    double began_ = 0.0;
    double deadline_ = INFINITY;  // s after that
    Cost scene_;                  // as given, run once
    std::optional<Footing> ground_;
    Growth growth_;
    TipStatistics reference_tip_;
    bool is_shortened_ = false;
};

}  // namespace drapeau

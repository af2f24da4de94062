// Price study: what each part of a scene costs and matters, and the smallest scene within a tolerance. It prints
// nothing; who asks is told how far it is.
#pragma once

#include "measure/price_cost.hpp"
#include "measure/price_effect.hpp"
#include "measure/price_part.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

struct PriceRequest {
    Scene scene;
    double settle = 2.0;  // s that the scene swings in before
    // Of 1/60 s, that are compared. Unless they were asked for: fewer where the motion is chaotic, as in trade.
    long long batches = 30;
    bool batches_are_given = false;
    double budget = 120.0;            // s of time on the wall
    std::optional<double> tolerance;  // m
};

/// What a part costs and matters. Costs are shares of the scene's time, NAN where they could not be measured.
struct Priced {
    ScenePart part;
    Effect effect;
    double cost_same_step = NAN;  // at the scene's own step
    double cost = NAN;            // with the step that is taken without it
    double dt = NAN;              // s, that step
    std::string remark;           // why the scene without it cannot be run
};

struct Prices {
    std::vector<Priced> parts;
    Cost scene;                           // as given
    double resolution = NAN;              // share of its time: no smaller cost counts
    std::optional<std::string> diverged;  // the scene as given, at its own step
};

/// One more part left out.
struct Dropped {
    ScenePart part;
    Effect effect;                // of all that is left out up to it
    double saving = 0.0;          // share of the scene's time, of all that is left out up to it
    double bought = 0.0;          // share of it, of this one
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
    double measured = NAN;           // share of the time that is saved there
    double resolution = NAN;         // of that
    bool is_cut_short = false;       // by the budget

    double promised() const { return dropped.empty() ? 0.0 : dropped.back().saving; }
};

class PriceStudy {
public:
    using Tick = std::function<void(double)>;  // is told the share of the work that is done

    /// Throws InputError where the scene is impossible, no mass is free, nothing of it can be left out, or the budget
    /// does not suffice.
    PriceStudy(const PriceRequest& request, Tick tick);

    const std::vector<ScenePart>& parts() const { return parts_; }
    double estimate() const { return estimate_; }  // s of time, at most the budget

    /// Lets the scene swing in and flies its reference. Returns why it diverged, if it did.
    std::optional<std::string> prepare();
    const PriceRequest& request() const { return request_; }
    const Ground& ground() const { return *ground_; }
    const Growth& growth() const { return growth_; }
    bool is_shortened() const { return is_shortened_; }
    double horizon() const;
    bool is_beyond_horizon() const;
    TipStatistics reference_tip() const;

    Prices measure();

    /// Leaves out, one after the other, what changes the motion least and saves time, as long as all of it together
    /// stays within the tolerance; then looks at what is left in the stretch that follows (where it is too much, the
    /// last ones are put back) and checks it in the one after that.
    Reduction reduce(const Prices& prices);

private:
    struct Candidate;

    double elapsed() const;
    bool may_go_on() const { return elapsed() < request_.budget; }
    void tell() const;
    void list_times();
    double goal() const;
    Ground ground_at(const State<double>& start, double time) const;
    Ground after(const Ground& ground) const;
    Effect effect(const Scene& scene, const Ground& ground);
    Costs costs(const std::vector<Scene>& scenes, const Ground& ground, double share) const;
    std::vector<Candidate> candidates(const Scene& scene, const Prices& prices, const std::vector<ScenePart>& useless);
    bool drop_one(Reduction& reduction, const Prices& prices, std::vector<ScenePart>& useless);
    void confirm(Reduction& reduction);

    PriceRequest request_;
    Tick tick_;
    std::vector<ScenePart> parts_;
    Model model_;
    double a_second_ = 0.0;           // s on the wall, of a simulated second at rk4's limit
    double search_seconds_ = 0.0;     // that a reference may take
    double reference_seconds_ = 0.0;  // that the scene's took
    double effect_seconds_ = 0.0;     // that the last effect took
    double estimate_ = 0.0;
    double began_ = 0.0;
    std::optional<Ground> ground_;
    Growth growth_;
    bool is_shortened_ = false;
};

}  // namespace drapeau

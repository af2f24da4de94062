#include "extremes/judge.hpp"

#include "io/error.hpp"
#include "quality.hpp"
#include "run/engine.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>

namespace drapeau::extremes {
namespace {

using testing::Kind;
using testing::Means;

/// How often a run's energy and stretch are looked at; a look takes as long as some steps.
int looks_of(const Model& model, long long steps) {
    const long long affordable = std::max(2LL, 1'000'000 / model.grid.masses());
    return static_cast<int>(std::min({60LL, affordable, steps}));
}

/// A law that a case breaks.
struct Broken {
    std::string law;
    Verdict verdict = Verdict::failed;
};
void require(bool holds, const std::string& law, Verdict verdict = Verdict::failed) {
    if (!holds) throw Broken{law, verdict};
}

bool is_finite(const State<double>& state) {
    double sum = 0.0;
    for (const auto* field : {&state.position, &state.velocity})
        for (int c = 0; c < 3; ++c)
            for (const double value : field->component(c)) sum += 0.0 * value;  // NaN if any is not finite
    return sum == 0.0;
}

/// What energy there can be, from the laws of motion alone. Drag d against a wind w does at most d w^2/4 of work a
/// second on a mass; gravity m g |v|, and the sum of m |v| is at most sqrt(2 M E). So
///
///   dE/dt <= P + g sqrt(2 M E)      E(T) <= [sqrt(E_0 + P T) + g T sqrt(M/2)]^2
class Bound {
public:
    Bound(const Model& model, const State<double>& start, double initial, double epsilon) : initial_(initial) {
        long long free = 0;
        double farthest = 0.0;
        for (int j = 0; j < model.grid.rows; ++j)
            for (int i = 0; i < model.grid.columns; ++i) {
                const auto x = start.position.at(i, j);
                free += model.held(i, j) ? 0 : 1;
                farthest = std::max(farthest, std::hypot(x.x, x.y, x.z));
            }
        const auto masses = static_cast<double>(free);
        if (const auto* gravity = model.terms.get<Gravity>() ? &*model.terms.get<Gravity>() : nullptr) {
            const auto g = gravity->acceleration;
            falling_ = std::hypot(g.x, g.y, g.z) * std::sqrt(0.5 * masses * model.springs.mass);
        }
        // Passes after the move may bring in what a start beyond them holds: masses come out of the ground, springs are
        // shortened at once.
        const bool has_passes = model.limits.get<StretchLimit>() || model.touches();
        power_ = has_passes ? INFINITY : model.most_power();
        // Places are rounded to eps X, so a step's kick is off by k eps X for each spring: (dt k eps X)^2 / 2m of
        // energy, at most k (eps X)^2 for a stable step.
        const double k = model.springs.stiffest();
        rounding_ = static_cast<double>(model.springs_in_all()) * k * std::pow(2.0 * epsilon * farthest, 2);
    }
    double at(double time, long long steps) const {
        return std::pow(std::sqrt(initial_ + power_ * time) + falling_ * time, 2) + rounding(steps);
    }
    double rounding(long long steps) const { return static_cast<double>(steps + 1) * rounding_; }

private:
    double initial_, falling_ = 0.0, power_ = 0.0, rounding_ = 0.0;
};

/// A run that nothing watches: `steps` of dt (s) from the start.
Means unwatched(const Model& model, const Scene& scene, const State<double>& start, double dt, long long steps,
                Precision precision) {
    const auto engine = make_engine(model, scene.time.method, precision);
    engine->set(start);
    const Clock clock{.dt = dt};
    const int looks = looks_of(model, steps);
    Means means;
    long long done = 0;
    for (int n = 1; n <= looks; ++n) {
        const long long to = steps * n / looks;
        Report ignored;
        engine->advance(clock, done, to, no_step, ignored, nullptr);
        done = to;
        const double now = clock.at(to);
        means.energy += engine->measure(now).total() / looks;
        means.stretch += testing::percentile_99(engine->state(now), model.grid) / looks;
        if (!means.is_finite()) break;
    }
    return means;
}

/// What a step costs where it is hard, in steps of one mass: a limit that acts in every one takes some ten sweeps, each
/// as dear as some steps.
double cost_of(const Model& model, Method method) {
    constexpr double sweeps = 40.0;
    return step_cost(model, method) * (model.limits.get<StretchLimit>() ? sweeps : 1.0);
}

/// What is known to be right of a span of time, if it is known within the work allowed.
std::optional<Means> reference(const Scene& scene, const Model& model, const State<double>& start, double dt,
                               double time, double floor, double mass_steps) {
    const auto limit = stable_step(scene.time.method, model);
    const double coarse = std::min(dt, limit.is_finite() ? 0.5 * limit.seconds() : dt);
    const double steps = std::ceil(8.0 * time / coarse);
    if (!(1.5 * steps * cost_of(model, scene.time.method) <= mass_steps)) return {};
    const auto run = [&](long long count) {
        return unwatched(model, scene, start, time / static_cast<double>(count), count, Precision::double_precision);
    };
    const auto fine = static_cast<long long>(steps);
    const Means twice = run(std::max(1LL, fine / 2)), once = run(fine);
    // Motion that is wildly chaotic, or not resolved even so, has nothing to compare with.
    constexpr double within = 0.1, shortest = 0.01;
    if (!once.is_finite() || std::abs(twice.energy - once.energy) > within * (once.energy + floor) ||
        std::abs(twice.stretch - once.stretch) > within * (once.stretch + shortest))
        return {};
    return once;
}

void check_divergence(const Simulation& simulation, const Divergence& d, long long last) {
    const Grid& grid = simulation.model().grid;
    require(d.step >= 1 && d.step <= last, fmt::format("diverged at step {} of a run of {}", d.step, last));
    require(d.step > simulation.steps(), "the run stands past the step named");
    require(std::isfinite(d.time) && d.time > 0.0, "diverged at no time");
    require(d.column >= 0 && d.column < grid.columns && d.row >= 0 && d.row < grid.rows, "diverged outside the grid");
    require(!d.message.empty() && d.message.find('\n') == std::string::npos, "the message is not one line");
}

/// Leapfrog's velocities change sign with every step where drag and friction would stop a mass within half of one.
bool is_smooth(Method method, const Model& model, double dt) {
    return method != method_id<Leapfrog> || dt * model.damping_on_mass(1.0) <= 2.0 * model.springs.mass;
}

/// Whether a method changes the motion by nature at larger steps, which it says: it damps by itself, or makes springs
/// too soft. Its run is then another one than that at an eighth of the step.
bool changes_motion(Method method) {
    return with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::solves; });
}

/// Steps longer than the fastest gusts leap over them: what wind does in between is not known.
bool sees_gusts(const Model& model, double dt) {
    const Wind* wind = model.terms.get<Wind>() ? &*model.terms.get<Wind>() : nullptr;
    return !wind || wind->gusts == glm::dvec3(0.0) || dt < 0.25 * wind->period;
}

/// Whether a good run may not be called diverged. Past the limit nothing is promised; rk4 loses energy well below it.
bool is_promised(Method method, const Model& model, double dt) {
    if (changes_motion(method) || !sees_gusts(model, dt)) return false;
    const auto limit = stable_step(method, model);
    return limit.allows(method == method_id<Rk4> ? 2.0 * dt : dt) && is_smooth(method, model, dt);
}

Judgement judged(const Case& of, double work) {
    const Scene& scene = of.scene;
    std::optional<Simulation> built;
    try {
        built.emplace(scene);
        if (of.exact_dt && scene.time.dt) built->use_exact_dt();
        if (const auto beginning = beginning_of(of, built->state())) built->put(*beginning);
        built->use_threads(of.threads);
    } catch (const InputError& refusal) {
        const std::string message = refusal.what();
        require(message.size() > 10 && message.find('\n') == std::string::npos, "refused without a line: " + message);
        return {Verdict::refused, message};
    }
    Simulation& simulation = *built;
    const Model model = model_of(scene);
    const auto start = simulation.state();
    require(is_finite(start), "the start is not finite");
    const auto beginning = simulation.readings();
    const double dt = simulation.dt(), initial = beginning.kinetic_energy + beginning.spring_energy;
    const bool automatic = !scene.time.dt;
    const Precision precision = simulation.precision();
    const double epsilon = precision == Precision::double_precision ? 0x1p-52 : 0x1p-23;
    const Bound bound(model, start, initial, epsilon);

    // A share of the work is for this run, the rest for one at an eighth of its step.
    constexpr double most_steps = 3000.0;
    const bool is_dear = changes_motion(scene.time.method) || model.limits.get<StretchLimit>();
    const double fewest_steps = is_dear ? 1.0 : 6.0;
    const auto limit = stable_step(scene.time.method, model);
    const double finer = std::max(1.0, limit.is_finite() ? dt / (0.5 * limit.seconds()) : 1.0);
    constexpr double harder = 20.0;  // where it is stiff, solving takes so many times as long as usual
    const double cost = cost_of(model, scene.time.method) * (changes_motion(scene.time.method) ? harder : 1.0);
    const double comparable = work / cost / (2.0 + 12.0 * finer);
    const bool compares = comparable >= 100.0;
    const auto steps =
        static_cast<long long>(std::clamp(compares ? comparable : 0.3 * work / cost, fewest_steps, most_steps));

    std::optional<Divergence> divergence;
    Means seen;  // with velocities as they are at the positions' time
    const int looks = looks_of(model, steps);
    long long asked = 0;
    for (int n = 1; n <= looks && !divergence; ++n) {
        const long long to = steps * n / looks;
        divergence = simulation.advance_steps(to - asked);
        asked = to;
        const auto state = simulation.state();
        const auto readings = simulation.readings();
        require(is_finite(state), "a mass is not finite");
        require(std::isfinite(readings.kinetic_energy) && std::isfinite(readings.spring_energy) &&
                    std::isfinite(readings.max_stretch) && std::isfinite(readings.rms_spring_force),
                "a reading is not finite");
        seen.energy += (readings.kinetic_energy + readings.spring_energy) / looks;
        seen.stretch += testing::percentile_99(state, model.grid) / looks;
    }
    const long long last = steps;
    if (!divergence) divergence = simulation.check();
    const double time = automatic ? simulation.time() : static_cast<double>(last) * dt;

    if (divergence) {
        if (automatic) throw Broken{"diverged with an automatic step: " + divergence->message, Verdict::misjudged};
        check_divergence(simulation, *divergence, last);
        const auto here = simulation.readings();
        require(is_finite(simulation.state()) && std::isfinite(here.spring_energy),
                "stands on a state that is not finite");
    }
    // What is created is seen against all there could be: energy wrong by a factor while it is a hundredth of what
    // there was at first is not.
    const double noise = 1e-9 * bound.at(time, 0) + bound.rounding(steps), unseen = noise + 0.01 * initial;
    const auto right = reference(scene, model, start, dt, time, noise, compares ? 2.0 * work : 0.0);
    // Energy as the ledger counts it, where the run can be repeated without a watch.
    const Means run = automatic ? seen : unwatched(model, scene, start, dt, last, precision);
    const auto kind = [&](double floor) { return testing::kind_of(run, *right, floor, 0.01); };
    const auto figures = [&](const Means& known) {
        return fmt::format("energy {:.3g} J for {:.3g} J, stretch {:.4g} for {:.4g}", run.energy, known.energy,
                           run.stretch, known.stretch);
    };
    if (divergence) {
        if (right && is_promised(scene.time.method, model, dt) && kind(noise) == Kind::good &&
            divergence->cause != Divergence::Cause::float_rounding)  // masses may move too far for all that
            throw Broken{"a good run is called diverged (" + figures(*right) + "): " + divergence->message,
                         Verdict::misjudged};
        return {Verdict::diverged, divergence->message};
    }
    const std::string remark = simulation.precision_remark();
    if (!remark.empty() && simulation.precision() == scene.time.precision) return {Verdict::warned, remark};
    // Velocities at the positions' time swing by up to four times at the automatic share of the limit.
    const double most = bound.at(time, steps) * (automatic ? 4.0 : 1.0);
    require(run.is_finite() && run.energy <= 2.0 * most,
            fmt::format("energy {:.3g} J where there can be {:.3g} J at most is called good", run.energy, most));
    if (!right || changes_motion(scene.time.method)) return {Verdict::not_compared, ""};
    // What forward Euler creates past its limit hides in what wind goes on bringing in.
    const bool hides = scene.time.method == method_id<ForwardEuler> && !limit.allows(dt);
    require(hides || !is_smooth(scene.time.method, model, dt) || kind(unseen) != Kind::garbage,
            "garbage is called good: " + figures(*right), Verdict::misjudged);
    return {kind(noise) == Kind::good ? Verdict::good : Verdict::between, figures(*right)};
}

}  // namespace

Judgement judge(const Case& of, double work) {
    try {
        return judged(of, work);
    } catch (const Broken& broken) {
        return {broken.verdict, broken.law};
    } catch (const std::exception& error) {
        return {Verdict::failed, std::string("throws: ") + error.what()};
    }
}

}  // namespace drapeau::extremes

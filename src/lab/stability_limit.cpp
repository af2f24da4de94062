#include "stability_limit.hpp"

#include "run/engine.hpp"

#include "drapeau/fastest_mode.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace drapeau::lab {

namespace {

constexpr double stays = 2e-3;  // growth a step: what beating modes may seem to have; past a limit it is soon far more

/// The size of noise (m): displacements, and velocities as what they move in `seconds`.
double size_of(const State<double>& state, const State<double>& rest, double seconds) {
    double squares = 0.0;
    for (int j = 0; j < rest.rows(); ++j)
        for (int i = 0; i < rest.columns(); ++i) {
            const glm::dvec3 x = state.position.at(i, j) - rest.position.at(i, j),
                             v = seconds * state.velocity.at(i, j);
            squares += x.x * x.x + x.y * x.y + x.z * x.z + v.x * v.x + v.y * v.y + v.z * v.z;
        }
    return std::sqrt(squares);
}

/// The slope of y over x, by least squares, of the last two thirds: the fastest-growing mode has overtaken the others.
double late_slope(const std::vector<double>& x, const std::vector<double>& y) {
    double n = 0.0, x_sum = 0.0, y_sum = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t k = x.size() / 3; k < x.size(); ++k)
        n += 1.0, x_sum += x[k], y_sum += y[k], xx += x[k] * x[k], xy += x[k] * y[k];
    return (xy - x_sum * y_sum / n) / (xx - x_sum * x_sum / n);
}

/// The fastest mode of the cloth at rest, as a method with these weights sees it near a step of dt (s).
Oscillator fastest_of(Engine& engine, double damping_weight, double on_mass_weight, double dt) {
    constexpr int looks = 400;
    return engine.fastest_mode(damping_weight, on_mass_weight, dt, looks, 0.0);
}

/// Forward Euler's limit for one mode: a < b and 4 - 2b + a > 0.
double forward_limit(const Oscillator& o) {
    const double lambda = o.stiffness / o.mass, beta = (o.damping + o.on_mass) / o.mass;
    if (lambda == 0.0) return beta > 0.0 ? 2.0 / beta : INFINITY;
    const double spread = beta * beta - 4.0 * lambda;
    const double ringing = beta / lambda;
    return spread > 0.0 ? std::min(ringing, (beta - std::sqrt(spread)) / lambda) : ringing;
}

/// Nothing but what resists bending.
Terms bending_of(const Terms& terms) {
    Terms only;
    only.get<Bending>() = terms.get<Bending>();
    return only;
}

/// Of methods that solve for springs. At rest those resist nothing across the sheet, where it bends. Bending is seen at
/// the step's beginning, drag and friction at its end: (1 + r) z^2 - (2 + r - a - b) z + 1 - b, a + 2b < 4 + 2r.
double limit_of_bending(const Model& model) {
    Model bare = model;
    bare.springs.stiffness *= 1e-9;
    if (bare.springs.diagonal_stiffness) *bare.springs.diagonal_stiffness *= 1e-9;
    if (bare.springs.damping) bare.springs.damping = 0.0;
    bare.terms = bending_of(model.terms);
    const auto engine = make_engine(bare, method_id<SemiImplicitEuler>, Precision::double_precision);
    engine->set(flat_start(bare.grid));
    const double rate = model.damping_on_mass(1.0) / model.springs.mass;
    double dt = stable_step(SemiImplicitEuler{}, bare).seconds();
    for (int turn = 0; turn < 3; ++turn) {
        const Oscillator mode = fastest_of(*engine, SemiImplicitEuler::damping_weight, 0.0, dt);
        dt = step_where(mode.stiffness, 2.0 * (mode.damping - mode.mass * rate), 4.0 * mode.mass).seconds();
    }
    return dt;
}

double theory_of(const Model& model, Method method) {
    return with_method(method, [&]<class M>(const M& chosen) {
        const StableStep bound = stable_step(chosen, model);
        if (bound.is_unlimited()) return static_cast<double>(INFINITY);
        if constexpr (M::solves) return limit_of_bending(model);
        const auto engine = make_engine(model, method, Precision::double_precision);
        engine->set(flat_start(model.grid));
        if constexpr (has_live_limit<M>) {
            double dt = bound.seconds();
            for (int turn = 0; turn < 3; ++turn)
                dt = exact_step(chosen, fastest_of(*engine, M::damping_weight, M::on_mass_weight, dt)).seconds();
            return dt;
        } else {
            return forward_limit(fastest_of(*engine, 0.0, 0.0, 1.0));
        }
    });
}

/// A cloth at rest but for noise.
State<double> noisy(const Model& model, double size) {
    State<double> state = flat_start(model.grid);
    std::mt19937_64 random(1);
    const auto some = [&] { return size * (static_cast<double>(random()) * 0x1p-63 - 1.0); };
    for (int j = 0; j < state.rows(); ++j)
        for (int i = 0; i < state.columns(); ++i) {
            if (model.held(i, j)) continue;
            const double x = some(), y = some(), z = some();
            state.position.set(i, j, state.position.at(i, j) + glm::dvec3(x, y, z));
        }
    return state;
}

/// How noise grows from one step to the next; `seconds` is what velocities are counted with.
struct NoiseRun {
    double per_step = 0.0;
    State<double> end;
};
NoiseRun run_noise(const Model& model, Method method, double dt, const State<double>& start, double seconds) {
    constexpr double first = 1e-10, last = 1e-5;  // of the distance between masses
    constexpr int looks_at_each_step = 30, most_looks = 150, steps_a_look = 20;
    const double pitch = std::min(model.grid.pitch_x, model.grid.pitch_y);
    const State<double> rest = flat_start(model.grid);
    const auto engine = make_engine(model, method, Precision::double_precision);
    engine->set(start);
    NoiseRun run{0.0, start};
    std::vector<double> steps, sizes;
    long long done = 0;
    for (int look = 0; look < most_looks; ++look) {
        const int at_once = look < looks_at_each_step ? 1 : steps_a_look;
        Report report;
        engine->advance({.dt = dt}, done, done + at_once, no_step, report, nullptr);
        done += at_once;
        run.end = engine->state(0.0);
        const double size = size_of(run.end, rest, seconds) / pitch;
        if (!std::isfinite(size) || size == 0.0) break;
        steps.push_back(static_cast<double>(done));
        sizes.push_back(std::log(size));
        if (size > last) break;
    }
    // Where it grows past all that is small within a few steps, that says enough.
    run.per_step = steps.size() < 4 ? std::log(last / first) / static_cast<double>(done) : late_slope(steps, sizes);
    return run;
}

class Limit {
public:
    Limit(const Scene& scene, Method method) : model_(model_of(scene)), method_(method) {
        found_.method = method;
        found_.stiffness = model_.springs.stiffness;
        found_.damping = model_.springs.damping.value_or(0.0);
    }

    StabilityLimit find() {
        found_.theory = theory_of(model_, method_);
        const bool creates =
            with_method(method_, [](const auto& m) { return std::decay_t<decltype(m)>::creates_energy; });
        if (creates && is_uneven()) {
            found_.measured = found_.theory = NAN;
            return found_;
        }
        found_.measured = creates ? from_beyond() : by_halving();
        std::sort(found_.map.begin(), found_.map.end(),
                  [](const GrowthAt& a, const GrowthAt& b) { return a.dt < b.dt; });
        return found_;
    }

private:
    static constexpr double beside[] = {0.5, 0.9, 0.99, 1.01, 1.1, 2.0};  // of the limit, for the map

    /// Whether dampers are not in proportion to springs: modes that are damped little for how stiff they are decide
    /// then where slow growth begins, not the fastest, and which they are is not known.
    bool is_uneven() const {
        const Springs& s = model_.springs;
        const bool sheet = model_.grid.columns > 1 && model_.grid.rows > 1;
        return sheet && s.damping.value_or(0.0) > 0.0 && s.diagonal_stiffness &&
               *s.diagonal_stiffness != s.diagonal_damping * s.stiffness;
    }

    double coarsest() const {
        return with_method(method_, [](const auto& m) { return std::decay_t<decltype(m)>::coarsest_step; });
    }
    bool is_unlimited() const { return stable_step(method_, model_).is_unlimited(); }
    double growth_at(double dt) {
        const double pitch = std::min(model_.grid.pitch_x, model_.grid.pitch_y);
        found_.map.push_back({dt, run_noise(model_, method_, dt, noisy(model_, 1e-10 * pitch), dt).per_step});
        return found_.map.back().per_step;
    }

    /// A first guess that owes nothing to what it is compared with: the springs' own rate.
    double guess() const { return std::sqrt(model_.springs.mass / model_.springs.stiffness); }

    double by_halving() {
        constexpr double fine = 1e-4;
        if (is_unlimited()) return growth_at(coarsest()) > stays ? 0.0 : INFINITY;
        double stable = guess(), unstable = stable;
        for (int turn = 0; turn < 40 && growth_at(stable) > stays; ++turn) unstable = stable, stable *= 0.5;
        for (int turn = 0; turn < 40 && unstable <= stable; ++turn)
            if (growth_at(2.0 * unstable) > stays)
                unstable *= 2.0;
            else
                stable = unstable *= 2.0;
        while (unstable > (1.0 + fine) * stable) {
            const double middle = std::sqrt(stable * unstable);
            (growth_at(middle) > stays ? unstable : stable) = middle;
        }
        const double limit = std::sqrt(stable * unstable);
        for (const double share : beside) growth_at(share * limit);
        return limit;
    }

    /// A mode's squared size grows by a - b in a step, so ((size)^2 - 1)/dt is lambda dt - beta: a straight line in dt,
    /// that is zero at the limit. The mode that decides, the fastest, is what semi-implicit Euler makes of noise just
    /// past its own limit without damping.
    double from_beyond() {
        constexpr double past = 1.0005, enough = 1e-4, nothing = 0.02, small = 1e-9, apart = 0.15, bent = 0.02;
        Model undamped = model_;
        undamped.springs.damping.reset();
        undamped.terms = bending_of(model_.terms);
        if (auto& bending = undamped.terms.get<Bending>()) bending->damping.reset();
        Limit other(undamped, method_id<SemiImplicitEuler>);
        const double fastest = other.by_halving(), seconds = 0.5 * fastest;
        const State<double> rest = flat_start(model_.grid);
        const double pitch = std::min(model_.grid.pitch_x, model_.grid.pitch_y);
        State<double> mode =
            run_noise(undamped, other.method_, past * fastest, noisy(model_, 1e-10 * pitch), seconds).end;
        const double scale = small * pitch / size_of(mode, rest, 0.0);
        for (int j = 0; j < mode.rows(); ++j)
            for (int i = 0; i < mode.columns(); ++i) {
                mode.position.set(i, j,
                                  rest.position.at(i, j) + scale * (mode.position.at(i, j) - rest.position.at(i, j)));
                mode.velocity.set(i, j, glm::dvec3(0.0));
            }
        const auto growth = [&](double dt) {
            found_.map.push_back({dt, run_noise(model_, method_, dt, mode, seconds).per_step});
            return found_.map.back().per_step;
        };
        double dt = 1e-4 * fastest;
        for (const double finer : {1.5, 1.08}) {
            while (dt < fastest && growth(dt) < enough) dt *= finer;
            if (finer > 1.1) dt /= finer;
        }
        const auto slope = [&](double times) { return std::expm1(2.0 * growth(times * dt)) / (times * dt); };
        const double near = slope(1.0), middle = slope(1.0 + apart), far = slope(1.0 + 2.0 * apart);
        // Strong damping does not swing: there growth begins as suddenly as with other methods, on no straight line.
        if (std::abs(far - 2.0 * middle + near) > bent * std::abs(far - near)) return by_halving();
        const double limit = dt - near * 2.0 * apart * dt / (far - near);
        found_.unseen = nothing * dt;
        return limit < found_.unseen ? 0.0 : limit;
    }

    Limit(const Model& model, Method method) : model_(model), method_(method) {}

    Model model_;
    Method method_;
    StabilityLimit found_;
};

}  // namespace

double StabilityLimit::off() const {
    if (std::isnan(measured)) return 0.0;
    const bool agree = measured == theory || (measured == 0.0 && theory < unseen);
    return agree ? 0.0 : measured / theory - 1.0;
}

Scene quiet(const Scene& scene) {
    Scene only = scene;
    only.terms = bending_of(scene.terms);
    only.limits = {};
    only.flag.prestretch = 0.0;
    only.time.half_kick_start = false;
    return only;
}

StabilityLimit stability_limit(const Scene& quiet_scene, Method method) {
    return Limit(quiet_scene, method).find();
}

}  // namespace drapeau::lab

// Flag: a model, a method and the terms that act on it, for who embeds the core.
//
//   Flag<float, Leapfrog, Gravity> chain(spread(1, 10, 0, 1), Attach::top, {.mass = 0.01, .stiffness = 200},
//   Gravity{}); chain.set_step(1e-4); chain.advance(1000);
//
// Diagonal springs, spring damping and terms are listed as types: what is not listed is not compiled, and zero strength
// is not absence.
#pragma once

#include "drapeau/methods/list.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"
#include "drapeau/stepper.hpp"

#include <concepts>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct DiagonalSprings {
    double k = 100.0;  // N/m; half the structural k makes the sheet isotropic
};
struct SpringDamping {
    double c = 0.0;  // N s/m along every spring; larger needs a smaller step
};

/// Masses and structural springs, every one alike.
struct Cloth {
    double mass = 0.0001;      // kg, of every mass
    double stiffness = 200.0;  // k, N/m; larger needs a smaller step
};

template <class Real, class Method, class... Listed>
class Flag {
    template <class T>
    static constexpr bool has = (std::same_as<T, Listed> || ...);
    template <class T>
    static constexpr bool brakes = requires(T term) {
        term.damping(1.0);
    };

public:
    static constexpr bool brakes_by_neighbours = has<Air> || has<Bending>;
    static constexpr bool damped = has<SpringDamping> || (brakes_by_neighbours && predicts_velocity<Method>),
                          diagonals = has<DiagonalSprings>;
    static constexpr bool rated = (brakes<Listed> || ...);

    /// Flat, at rest, its top corner at the hoist at the origin. The automatic step until another is set; a method that
    /// has none (forward Euler without drag) begins with 1/60 s.
    Flag(const Grid& grid, Attach attach, const Cloth& cloth, const Listed&... listed)
        : model_(model_of(grid, attach, cloth, listed...)),
          stepper_(model_, kernels_of<Vector<Real>, Method, damped, diagonals, rated>()) {
        follow_automatic_step();
    }

    /// Shares the work among so many threads; the result is the same for any number. Throws std::system_error where the
    /// system gives no more.
    void use_threads(int count) { stepper_.use_threads(count); }

    /// The step (s) from now on, instead of the automatic one. Time is a whole number of steps times dt from the moment
    /// it was last set.
    void set_step(double dt) {
        automatic_ = false;
        take_step(dt);
    }
    /// Takes `steps` steps. Nothing is allocated and nothing is thrown.
    Report advance(long long steps) {
        const long long from = steps_;
        steps_ += steps;
        return stepper_.advance(clock_, from, steps_);
    }
    /// Takes the steps of `count` sixtieths of a second; their step is made to fill them first.
    Report advance_batches(long long count) {
        take_step(whole_steps_per_batch(clock_.dt));
        return advance(count * std::llround(batch_seconds / clock_.dt));
    }

    /// Changes a strength while the flag flies on. Nothing is built anew; an automatic step follows.
    template <class T>
    requires(has<T>) void set(const T& listed) {
        take(model_, listed);
        refill();
    }
    void set(const Cloth& cloth) {
        take(model_, cloth);
        refill();
    }

    double time() const { return clock_.at(steps_); }  // s
    long long steps() const { return steps_; }
    double dt() const { return clock_.dt; }  // s
    const Model& model() const { return model_; }

    glm::dvec3 position(int i, int j) const { return stepper_.position().at(i, j); }  // m
    /// Position and velocity at the same time.
    State<double> state() { return stepper_.state(time()); }
    void set_state(const State<double>& state) { stepper_.set(state); }
    Measurement measure() { return stepper_.measure(time()); }

    /// The largest step that the closed bound allows (stability.hpp).
    StableStep largest_stable_step() const { return stable_step(Method{}, model_); }

private:
    void refill() {
        stepper_.synchronise(time());  // by the forces that there were
        stepper_.refill(model_);
        if (automatic_) follow_automatic_step();
    }
    void take_step(double dt) {
        if (dt == clock_.dt) return;
        stepper_.synchronise(time());
        clock_ = {time(), steps_, dt};
    }
    void follow_automatic_step() {
        const bool none = largest_stable_step().is_none();
        take_step(whole_steps_per_batch(none ? batch_seconds : automatic_step(Method{}, model_)));
    }

    static void take(Model& model, const Cloth& cloth) {
        model.springs.mass = cloth.mass;
        model.springs.stiffness = cloth.stiffness;
    }
    static void take(Model& model, const DiagonalSprings& diagonal) { model.springs.diagonal_stiffness = diagonal.k; }
    static void take(Model& model, const SpringDamping& damping) { model.springs.damping = damping.c; }
    template <class T>
    static void take(Model& model, const T& listed) {
        if constexpr (Terms::has<T>)
            model.terms.add(listed);
        else
            model.limits.add(listed);
    }
    static Model model_of(const Grid& grid, Attach attach, const Cloth& cloth, const Listed&... listed) {
        static_assert(!has<Wind> || has<AirDrag> || has<Air>, "nothing would feel the wind: list AirDrag or Air too");
        Model model(grid, {.diagonal_stiffness = {}, .damping = {}}, attach);
        take(model, cloth);
        (take(model, listed), ...);
        return model;
    }

    Model model_;
    Stepper<Real> stepper_;
    Clock clock_;
    long long steps_ = 0;
    bool automatic_ = true;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

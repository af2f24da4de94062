#include "counting.hpp"

#include "evaluation.hpp"

#include "drapeau/start.hpp"
#include "drapeau/stepper.hpp"

#include <type_traits>

namespace drapeau::bench {
namespace {

constexpr int columns = 64, rows = 64;  // whole registers; borders weigh little

/// Calls job with a constant for a flag.
template <class Job>
void with_constant(bool flag, const Job& job) {
    flag ? job(std::true_type{}) : job(std::false_type{});
}

template <class Real>
void do_counted(Counted what, const Model& model, const Kernels<Real>& kernels) {
    constexpr double dt = 1e-5;
    if (what == Counted::evaluation) {
        Evaluation<Real> evaluation(model, kernels, flat_start(model.grid), dt);
        Counts::now() = {};
        return evaluation.run();
    }
    Stepper<Real> flag(model, kernels);
    const Clock clock{.dt = dt};
    flag.advance(clock, 0, 0);  // the method starts
    Counts::now() = {};
    if (what == Counted::measurement)
        flag.measure(0.0);
    else
        flag.advance(clock, 0, 1, what == Counted::accounted_step ? 0 : no_step);
}

template <class Real>
void run_counted(Counted what, const CountedKernels& k) {
    using Lane = CountedLane<Real>;
    Springs springs;
    if (k.diagonals) springs.diagonal_stiffness = 100.0;
    if (k.damped) springs.damping = 0.002;
    const Model model({columns, rows, 0.03, 0.03}, springs, Attach::hoist);
    with_constant(k.diagonals, [&](auto diagonals) {
        with_constant(k.damped, [&](auto damped) {
            if (!k.rated)  // only flags composed in C++, with the report's method
                do_counted<Real>(what, model, kernels_of<Lane, SemiImplicitEuler, damped(), diagonals(), false>());
            else
                with_method(k.method, [&]<class M>(const M&) {
                    if constexpr (!M::solves)  // what those take depends on the motion
                        do_counted<Real>(what, model, kernels_of<Lane, M, damped(), diagonals()>());
                });
        });
    });
}

}  // namespace

Counts count(Counted what, const CountedKernels& kernels) {
    kernels.in_double ? run_counted<double>(what, kernels) : run_counted<float>(what, kernels);
    Counts counts = Counts::now();
    for (double* n : {&counts.multiplications, &counts.additions, &counts.others, &counts.loads, &counts.stores})
        *n /= columns * rows;
    return counts;
}

}  // namespace drapeau::bench

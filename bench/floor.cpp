#include "floor.hpp"

#include "run/engine.hpp"

#include "drapeau/advance.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"

#include <algorithm>
#include <type_traits>

namespace drapeau::bench {
namespace {

constexpr int columns = 64, rows = 64;  // whole registers; borders weigh little

/// Calls job with a constant for each flag.
template <class Job>
void with_constant(bool flag, const Job& job) {
    flag ? job(std::true_type{}) : job(std::false_type{});
}

template <class Real>
Counts count(const Case& c) {
    using Lane = CountedLane<Real>;
    const Physics physics(flag_scene(columns, rows, c.method, c.terms));
    Cloth<Real> cloth(physics.grid);
    Fabric<Real> fabric(physics.grid, physics.attach, physics.material);
    SweepBuffers<Real> buffers(cloth.width());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) cloth.set_position(i, j, physics.grid.rest(i, j));

    // The programs' kernels fold gravity, drag and wind in whether or not a scene lists them.
    const bool folds_all = c.work != Work::terms;
    const bool acceleration = folds_all || c.terms.gravity || c.terms.wind, rate = folds_all || c.terms.drag;

    Counts::now() = {};
    with_constant(c.terms.diagonal, [&](auto diagonals) {
        with_constant(c.terms.damping, [&](auto damped) {
            using Pair = SpringForce<damped()>;
            if (c.work == Work::forces) {
                Array<Real> f[3]{Array<Real>(cloth.count()), Array<Real>(cloth.count()), Array<Real>(cloth.count())};
                spring_forces<Lane, Pair, diagonals()>(cloth.view(), fabric.view(),
                                                       ForceRow<Real>{f[0].data(), f[1].data(), f[2].data()}, buffers);
                return;
            }
            with_constant(acceleration, [&](auto has_acceleration) {
                with_constant(rate, [&](auto has_rate) {
                    const Uniform<Real, has_acceleration(), has_rate()> uniform{};
                    const auto dt = static_cast<Real>(1e-5);
                    if (c.method == Method::forward_euler)
                        advance_cloth<Lane, Pair, diagonals(), ForwardEuler>(cloth.view(), fabric.view(), uniform, dt,
                                                                             buffers);
                    else
                        advance_cloth<Lane, Pair, diagonals(), SemiImplicitEuler>(cloth.view(), fabric.view(), uniform,
                                                                                  dt, buffers);
                });
            });
        });
    });
    Counts counts = Counts::now();
    for (double* n : {&counts.multiplications, &counts.additions, &counts.others, &counts.loads, &counts.stores})
        *n /= columns * rows;
    return counts;
}

/// ns to move `bytes` a mass when the set in use has `set_bytes`: what fits a level moves as fast as that level does.
double ns_to_move(double bytes, std::size_t set_bytes, double Level::*bandwidth, const Peaks& peaks) {
    double ns = 0.0, held = 0.0;  // share of the set that nearer levels hold
    const std::size_t last = peaks.level_of(set_bytes);
    for (std::size_t n = 0; n <= last; ++n) {
        const auto& level = peaks.levels[n];
        const double share = n == last ? 1.0 : static_cast<double>(level.bytes) / static_cast<double>(set_bytes);
        ns += (share - held) * bytes / level.*bandwidth;
        held = share;
    }
    return ns;
}

}  // namespace

Counts count_operations(const Case& c) {
    if (c.work == Work::snapshot || c.work == Work::copy) return {};
    return c.precision == Precision::double_precision ? count<double>(c) : count<float>(c);
}

Floor floor_of(const Case& c, const Counts& counts, const Peaks& peaks) {
    const auto masses = static_cast<std::size_t>(c.masses());
    const std::size_t real = c.bytes_a_real();
    const bool whole_steps = c.work != Work::snapshot && c.work != Work::copy && c.work != Work::forces;

    // What is read and written: a step updates six components in place, the others read some and write others.
    const std::size_t moved = c.work == Work::snapshot ? 6 * (real + sizeof(float))
                              : c.work == Work::forces ? 9 * real
                                                       : 12 * real;
    const std::size_t set_bytes = masses * (whole_steps ? moved / 2 : moved);
    const double moving =
        ns_to_move(static_cast<double>(moved), set_bytes, whole_steps ? &Level::update : &Level::copy, peaks);

    const double operations = std::max(counts.multiplications, counts.additions) + counts.others;
    const double arithmetic = operations / peaks.multiply_adds_of(c.precision);
    Floor floor{arithmetic, "arithmetic"};
    if (moving > arithmetic) floor = {moving, peaks.levels[peaks.level_of(set_bytes)].name};
    floor.ns /= c.threads;
    return floor;
}

}  // namespace drapeau::bench

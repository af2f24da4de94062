#include "grid_flights.hpp"

#include "measure/same_cloth.hpp"
#include "measure/swing_in.hpp"
#include "run/start_state.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drapeau::lab {

namespace {

constexpr Method rk4 = method_id<Rk4>;

}  // namespace

long long steps_a_batch(const Model& model) {
    constexpr double share_of_limit = 0.5;
    const double dt = std::min(share_of_limit * stable_step(rk4, model).seconds(), batch_seconds / 4.0);
    return static_cast<long long>(std::ceil(batch_seconds / dt));
}

Grids::Grids(const GridRequest& request, double seconds, const std::function<void()>& tick)
    : request_(request),
      seconds_(seconds),
      tick_(tick),
      coarsest_(on_grid(0)),
      coarsest_model_(model_of(coarsest_)),
      start_(start_state(coarsest_).state),
      every_(sampling(coarsest_model_.grid, request.batches)) {}

Scene Grids::on_grid(std::size_t n) const {
    return same_cloth(request_.scene, request_.grids[n].first, request_.grids[n].second);
}

std::optional<Seen> Grids::seen(std::size_t n, Borders borders, bool aside, int finer_steps) const {
    const Scene scene = on_grid(n);
    const Model model = model_with(scene, borders);
    const int times = 1 << n;
    const long long steps = finer_steps * steps_a_batch(model);
    Yardstick yardstick(model);
    Stretch stretch{on_finer_grid(start_, times), 0.0, request_.settle, std::max(1LL, request_.settle), times};
    hold_fast(stretch.start, model, scene.flag.prestretch);
    const auto may_go_on = [this] {
        tick_();
        return spent() < seconds_;
    };
    if (request_.settle > 0) {
        auto before = fly(model, rk4, steps, stretch, yardstick, may_go_on);
        if (!before) return {};
        stretch.start = std::move(before->end);
        stretch.time = stretch.seconds();
    }
    stretch.batches = request_.batches;
    stretch.every = every_;
    if (aside) stretch.start = pushed_aside(model, std::move(stretch.start), Growth::first);
    ClothShape shape(model.grid, model.has_diagonals());
    auto flight = fly(model, rk4, steps, stretch, yardstick, may_go_on, Precision::double_precision,
                      [&](const State<double>& state) { shape.take(state); });
    if (!flight) return {};
    const bool is_limited = is_limit_active(model, *flight);
    return Seen{std::move(*flight), shape, is_limited};
}

double Grids::difference(const Flight& one, const Flight& other) const {
    return apart(coarsest_model_, one, other).over_time;
}

Growth Grids::growth(const Flight& one, const Flight& other) const {
    const Stretch stretch{State<double>(1, 1), 0.0, request_.batches, every_};
    return growth_of(coarsest_model_, stretch, one, other);
}

}  // namespace drapeau::lab

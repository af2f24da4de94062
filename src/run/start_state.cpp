#include "run/start_state.hpp"

#include "io/text.hpp"
#include "run/settle.hpp"
#include "scene/surroundings.hpp"

#include "drapeau/precision.hpp"
#include "drapeau/start.hpp"

#include <utility>

namespace drapeau {
namespace {

constexpr std::uint64_t crumple_seed = 1;

/// A flag exactly in its plane would stay in it: the lightest of folds, `size` high (m), let it choose a side.
void ripple(State<double>& state, const Model& model, double size) {
    const Grid& grid = model.grid;
    if (size == 0.0) return;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            if (!model.held(i, j)) {
                auto x = state.position.at(i, j);
                x.z += size * smooth_noise(crumple_seed, 103, 5.0 * i * grid.pitch_x + 0.37 * j);
                state.position.set(i, j, x);
            }
}

/// Where no mass can move or nothing pulls, a flag hangs where it begins.
bool can_hang(const Scene& scene, const Model& model) {
    const bool falls = scene.flag.attach == Attach::none;  // for ever
    if (falls || !scene.gravity() || scene.gravity()->acceleration == glm::dvec3(0.0)) return false;
    for (int j = 0; j < model.grid.rows; ++j)
        for (int i = 0; i < model.grid.columns; ++i)
            if (!model.held(i, j)) return true;
    return false;
}

}  // namespace

StartState start_state(const Scene& scene, const std::atomic<bool>* abandon) {
    const Model model = model_of(scene);
    const Grid& grid = model.grid;
    const double prestretch = scene.flag.prestretch;
    auto state = scene.flag.start == Start::crumpled ? crumpled_start(model, prestretch, crumple_seed)
                                                     : flat_start(grid, prestretch);
    const double height = hoisted_height(scene);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            state.position.set(i, j, state.position.at(i, j) + glm::dvec3(0.0, height, 0.0));
    std::string remark;
    if (scene.flag.start == Start::flat) {
        constexpr double unseen = 1e-9;  // m
        const bool in_plane = grid.columns > 1 && grid.rows > 1 && !is_pushed_across(model);
        ripple(state, model, scene.flag.disturbance.value_or(in_plane ? unseen : 0.0));
        if (in_plane && scene.flag.disturbance == 0.0)
            remark = "the flag stays in the plane it begins in: nothing pushes it out, and flag.disturbance is 0";
    }
    if (scene.flag.start != Start::hanging || !can_hang(scene, model)) return {std::move(state), std::move(remark)};

    ripple(state, model, 0.02 * grid.pitch_x);
    Settled settled = settle(scene, state, abandon);
    if (!settled.reached && settled.speed >= still_speed)
        remark = "the flag had not come to rest when it started: it was still moving at " +
                 quantity(settled.speed, "m/s", 2);
    return {std::move(settled.state), std::move(remark)};
}

}  // namespace drapeau

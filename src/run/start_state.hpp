// Start state: the masses of a scene at time zero.
#pragma once

#include "drapeau/state.hpp"
#include "scene/scene.hpp"

#include <atomic>
#include <string>

namespace drapeau {

struct StartState {
    State<double> state;  // at rest
    std::string remark;   // what it is not that it should be; empty where all is well
};

/// Flat, hanging (settled without wind) or crumpled, as the scene says. Throws SettlingAbandoned (settle.hpp) soon
/// after `abandon` is set.
StartState start_state(const Scene& scene, const std::atomic<bool>* abandon = nullptr);

}  // namespace drapeau

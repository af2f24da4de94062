// The whole core: cloth, fabric, spring, forces, wind, sweep, integrators, stability, energy, start, scene.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/state.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/model.hpp"
#include "drapeau/flag.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"
#include "scene.hpp"
#include "drapeau/spring.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"
#include "drapeau/sweep.hpp"
#include "drapeau/terms/wind.hpp"

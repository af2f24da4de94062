// The whole core: cloth, fabric, spring, forces, wind, sweep, integrators, stability, energy, start, scene.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/cloth.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/fabric.hpp"
#include "drapeau/flag.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/integrators/forward_euler.hpp"
#include "drapeau/integrators/semi_implicit_euler.hpp"
#include "drapeau/scene.hpp"
#include "drapeau/spring.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"
#include "drapeau/sweep.hpp"
#include "drapeau/wind.hpp"

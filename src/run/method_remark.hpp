// Method remark: what a method does to the motion by nature at a step, in words and figures, for whoever chooses it.
#pragma once

#include "drapeau/model.hpp"
#include "drapeau/methods/list.hpp"

#include <string>

namespace drapeau {

/// The damping that a method adds, or how much too soft it makes springs; empty where it does neither.
std::string method_remark(Method method, const Model& model, double dt);

/// How many times too soft, counting springs of both kinds; 1 where a method has no such fault.
double softness(Method method, const Model& model, double dt);

/// What is left of a swing of 1 Hz after each period, as a share of its amplitude; 1 where nothing is lost.
double kept_at_one_hertz(Method method, double dt);

}  // namespace drapeau

// Kernels: the compositions the programs can choose at run time, compiled ahead for each precision and instruction set.
// Terms that push or brake masses come as rows of numbers, so only what costs per spring is a choice here: the method,
// diagonals and spring damping.
#pragma once

#include "drapeau/field.hpp"
#include "drapeau/methods/list.hpp"

#include <string>
#include <vector>

namespace drapeau {

/// The kernels of one precision and instruction set: [method][diagonals][damped].
template <class Real>
struct KernelTable {
    Kernels<Real> of[method_count][2][2];
};

/// The kernels for a composition, of the best instruction set this machine has. The environment variable
/// DRAPEAU_TARGET names another of kernel_targets(); throws InputError if it is not there or cannot run here.
template <class Real>
const Kernels<Real>& find_kernels(Method method, bool diagonals, bool damped);

/// The instruction sets compiled in that this machine can run, the best last.
std::vector<std::string> kernel_targets();

/// The one in use. Throws InputError where none of them can run on this machine.
std::string kernel_target();

}  // namespace drapeau

// Kernels: the compositions the programs can choose at run time, compiled ahead for each precision, method and
// instruction set. Gravity, drag, friction and wind fold to one vector and one rate, so only what costs per spring
// is a choice here: diagonals and spring damping.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/forces.hpp"

#include <string>
#include <vector>

namespace drapeau {

template <class Real>
using Ambient = Uniform<Real, true, true>;

/// One composition: see advance.hpp for the meaning of each.
template <class Real>
struct Kernel {
    void (*advance_rows)(const Rows<Real>&, int first, int last, const Row<Real>* above, const Row<Real>* below,
                         const FabricView<Real>&, const Ambient<Real>&, Real dt, SweepBuffers<Real>&);
    void (*spring_forces)(const Rows<Real>&, const FabricView<Real>&, const ForceRow<Real>&, SweepBuffers<Real>&);
};

/// The kernels of one method: [diagonals][damped].
template <class Real>
struct KernelSet {
    Kernel<Real> of[2][2];
};

/// The kernel for a composition, of the best instruction set this machine has. The environment variable
/// DRAPEAU_TARGET names another of kernel_targets(); throws InputError if it is not there or cannot run here.
template <class Real>
const Kernel<Real>& find_kernel(Method method, bool diagonals, bool damped);

/// The instruction sets compiled in that this machine can run, the best last.
std::vector<std::string> kernel_targets();

/// The one in use.
std::string kernel_target();

}  // namespace drapeau

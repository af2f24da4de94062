// One precision and one method, for one instruction set: compiled several times, with
// DRAPEAU_REAL, DRAPEAU_METHOD and DRAPEAU_KERNEL_SYMBOL given by the build.
#include "kernels/kernels.hpp"

#include "drapeau/integrators/forward_euler.hpp"
#include "drapeau/integrators/semi_implicit_euler.hpp"

namespace drapeau {
namespace {

using Real = DRAPEAU_REAL;

template <bool diagonals, bool damped>
constexpr Kernel<Real> kernel{
    &advance_rows<Vector<Real>, SpringForce<damped>, diagonals, DRAPEAU_METHOD, Ambient<Real>, Real>,
    &spring_forces<Vector<Real>, SpringForce<damped>, diagonals, Real>,
};

}  // namespace

extern const KernelSet<Real> DRAPEAU_KERNEL_SYMBOL;
const KernelSet<Real> DRAPEAU_KERNEL_SYMBOL{
    {{kernel<false, false>, kernel<false, true>}, {kernel<true, false>, kernel<true, true>}}};

}  // namespace drapeau

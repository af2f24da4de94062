// One precision and one method, for one instruction set: compiled several times, with
// DRAPEAU_REAL, DRAPEAU_METHOD and DRAPEAU_KERNEL_SYMBOL given by the build.
#include "kernels/kernels.hpp"

#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"

namespace drapeau {
namespace {

using Real = DRAPEAU_REAL;

// Types of this file alone make the kernels its own: were they shared, the linker would keep one of several
// instruction sets' versions whose registers are equally wide, and call it for all.
struct Move : DRAPEAU_METHOD {};
template <bool damped>
struct Force : SpringForce<damped> {};

template <bool diagonals, bool damped>
constexpr Kernel<Real> kernel{
    &advance_rows<Vector<Real>, Force<damped>, diagonals, Move, Ambient<Real>, Real>,
    &spring_forces<Vector<Real>, Force<damped>, diagonals, Real>,
};

}  // namespace

extern const KernelSet<Real> DRAPEAU_KERNEL_SYMBOL;
const KernelSet<Real> DRAPEAU_KERNEL_SYMBOL{
    {{kernel<false, false>, kernel<false, true>}, {kernel<true, false>, kernel<true, true>}}};

}  // namespace drapeau

// The kernels that the physics tests run, compiled once.
#include "physics_sheet.hpp"

namespace drapeau::testing {

DRAPEAU_ALL_TESTED_KERNELS()

}  // namespace drapeau::testing

namespace drapeau {
inline namespace DRAPEAU_ISA {
template class Stepper<float>;
template class Stepper<double>;
}  // namespace DRAPEAU_ISA
}  // namespace drapeau

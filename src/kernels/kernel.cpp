// One precision for one instruction set: compiled several times, with DRAPEAU_REAL and DRAPEAU_KERNEL_SYMBOL given by
// the build. The table is a constant: nothing here runs before its instruction set is known to be there.
#include "kernels/kernels.hpp"

#include "drapeau/advance.hpp"

namespace drapeau {
namespace {

using Real = DRAPEAU_REAL;

template <class M>
constexpr void fill(Kernels<Real> (&of)[2][2]) {
    of[0][0] = kernels_of<Vector<Real>, M, false, false, true>();
    of[0][1] = kernels_of<Vector<Real>, M, true, false, true>();
    of[1][0] = kernels_of<Vector<Real>, M, false, true, true>();
    of[1][1] = kernels_of<Vector<Real>, M, true, true, true>();
}

constexpr KernelTable<Real> compile_all() {
    KernelTable<Real> table{};
    [&]<std::size_t... n>(std::index_sequence<n...>) {
        (fill<std::tuple_element_t<n, Methods>>(table.of[n]), ...);
    }
    (std::make_index_sequence<method_count>());
    return table;
}

}  // namespace

extern const KernelTable<Real> DRAPEAU_KERNEL_SYMBOL;
constinit const KernelTable<Real> DRAPEAU_KERNEL_SYMBOL = compile_all();

}  // namespace drapeau

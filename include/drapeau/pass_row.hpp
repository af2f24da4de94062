// Pass row: where what a pass reads and writes of one row lies: in the cloth's own arrays or in a halo.
#pragma once

#include "drapeau/field.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The rows of a pass, those of the halos included.
template <class Real, int fields>
struct PassRow {
    Field<Real> field[fields];
    Field<const Real> pushed;  // what terms push this row with; where a halo goes does not matter

    DRAPEAU_INLINE PassRow(const Pass<Real>& pass, int j)
        : pushed(pass.acceleration.row(j < pass.first ? pass.first : j)) {
        const int above = j - (pass.first - pass.halo), below = j - pass.last;
        for (int f = 0; f < fields; ++f)
            field[f] = j < pass.first  ? pass.above[f].row(above)
                       : j < pass.last ? pass.fields[f].row(j)
                                       : pass.below[f].row(below);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

// Pass row: where what a pass reads and writes of one row lies: in the cloth's own arrays or in a halo.
#pragma once

#include "drapeau/field.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The rows of a pass, those of the halos included.
template <class Real, int fields>
struct PassRow {
    Field<Real> field[fields];
    // What terms push this row with, and the air that moves along (null where none does); where a halo goes does not
    // matter.
    Field<const Real> pushed, added_push, added_direction;

    DRAPEAU_INLINE PassRow(const Pass<Real>& pass, int j)
        : pushed(pass.acceleration.row(j < pass.first ? pass.first : j)),
          added_push(pass.added.push),
          added_direction(pass.added.direction) {
        if (pass.added.is_felt()) {
            const int own = j < pass.first ? pass.first : j;
            added_push = added_push.row(own), added_direction = added_direction.row(own);
        }
        const int above = j - (pass.first - pass.halo), below = j - pass.last;
        for (int f = 0; f < fields; ++f)
            field[f] = j < pass.first  ? pass.above[f].row(above)
                       : j < pass.last ? pass.fields[f].row(j)
                                       : pass.below[f].row(below);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

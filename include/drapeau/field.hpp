// Field: one vector quantity of every mass (positions, velocities, forces), as three component arrays with a stride.
//
// Mass (column i, row j) is element j * stride + i. Nothing here owns memory (state.hpp does) and everything is a plain
// aggregate: these are the types that pass between code compiled for different instruction sets (isa.hpp).
#pragma once

#include "drapeau/simd.hpp"

#include <cstddef>

namespace drapeau {

template <class Real>
struct Field {
    Real *x, *y, *z;
    std::ptrdiff_t stride;  // elements from one row to the next

    DRAPEAU_INLINE Field row(std::ptrdiff_t j) const {
        const std::ptrdiff_t n = j * stride;
        return {x + n, y + n, z + n, stride};
    }
    template <class V>
    DRAPEAU_INLINE Vec3<V> at(std::ptrdiff_t i) const {
        return {Lanes<V>::load(x + i), Lanes<V>::load(y + i), Lanes<V>::load(z + i)};
    }
    template <class V>
    DRAPEAU_INLINE void set(std::ptrdiff_t i, const Vec3<V>& value) const {
        Lanes<V>::store(x + i, value.x), Lanes<V>::store(y + i, value.y), Lanes<V>::store(z + i, value.z);
    }
    DRAPEAU_INLINE operator Field<const Real>() const requires(!std::is_const_v<Real>) { return {x, y, z, stride}; }
};

/// Springs that run alike from every mass of a row, as row-long arrays: element i is the spring that starts at column
/// i. All are zero where there is none (past the last column).
template <class Real>
struct SpringRow {
    const Real* k;         // N/m
    const Real* k_length;  // k L, N: the stiffness times the rest length
    const Real* c;         // N s/m; not read without damping
    Real length;           // L, m
};

/// What a kernel reads of the model for one row. Rows alike share the arrays.
template <class Real>
struct RowConstants {
    SpringRow<Real> fly, hoist, diagonal;  // to the right; to the row below; across the cells below
    const Real* inverse_mass;              // 1/kg; 0 where a mass is held and in the padding
    const Real* mass;                      // kg; 0 likewise
    const Real* rate;                      // 1/s, all drag and friction over the mass; 0 likewise
    const Real* area;                      // m2/kg, the share of the cloth's area over the mass; 0 likewise
    // By the middle one of three masses in a line, the share of what such a triple bends with: along the fly, 0 at the
    // ends of a row; down the hoist, whatever the row.
    const Real *bend_fly, *bend_hoist;
};

/// Half the air's density times a coefficient, of the pressure on faces and of the friction along them; 0: neither is
/// computed (terms/air.hpp).
template <class Real>
struct AirStrength {
    Real pressure, skin;  // kg/m3

    DRAPEAU_INLINE bool is_felt() const { return pressure > Real(0) || skin > Real(0); }
};

/// The air that moves along with the cloth (extra/added_air.hpp). Null where none does.
template <class Real>
struct AddedAirRows {
    // Held from look to look, of every mass: what the air pushes it with (m/s2), the normal times the root of the
    // air's share in its inertia, beta, and its velocity when last looked at (m/s).
    Field<Real> push, direction, previous;
    // A look's own, of every mass, each row with a margin on either side: its place, its velocity through the air, and
    // of that the part along the normal, in a field with the same stride.
    Field<Real> place, relative;
    Real* momentum;
    const Real* mass;  // mA of each row, kg/m2
    // Of each column: the shares of the pairs to the right and to the left, of what is shed, of the width across, and
    // the length that differences span (m).
    const Real *right, *left, *ends, *across, *span;
    Real pitch_x, pitch_y;  // m
    int columns, margin;
    int reach_x, reach_y;  // masses, to either side
    Real ahead;            // s, for which a look is held
    bool is_first;         // nothing is known of before

    DRAPEAU_INLINE bool is_felt() const { return push.x != nullptr; }
};

/// How three masses in a line resist being bent, along the fly and down the hoist (terms/bending.hpp).
template <class Real>
struct BendingStrength {
    Real k_fly, k_hoist, c_fly, c_hoist;  // N/m and N s/m
};

/// Position, velocity and what a method keeps, by the method's own numbering; positions are 0, velocities 1.
inline constexpr int max_fields = 10;

/// What springs from one row leave waiting for the row below: row-long arrays, one a component.
template <class Real>
struct WaitingRow {
    Real* first;
    std::ptrdiff_t pitch;

    DRAPEAU_INLINE Real* component(int c) const { return first + c * pitch; }
};

/// Numbers a pass sums for each row, in double (see Report).
struct RowSums {
    double external_work;   // J, by drag, friction and every term that pushes masses, but what bending stores
    double damping_work;    // J, by the springs' dampers
    double drift[3];        // kg m, sum of m v dt with the velocity that work is counted with
    double elastic;         // J; measured, with what bending stores
    double bending;         // J, that bending stores
    double kinetic;         // J, as the ledger counts it
    double kinetic_now;     // J, of velocities at the positions' time
    double power;           // W, of all but what is elastic, with the velocity as stored
    double stretch;         // sum of |l - L| / L
    double max_stretch;     // greatest (l - L) / L
    double max_force;       // N, greatest |k (l - L)|
    double max_air_rate;    // 1/s, see air_rate_rows
    double force_squares;   // N2, sum of squares
    double moment[3];       // kg m, sum of m x
    double products[2][3];  // sums of methods that solve, in two banks (see there)
};

/// What solving took, summed over steps.
struct Solves {
    long long steps, linear_solves, iterations;  // linear solves: Newton's steps; iterations: of conjugate gradients
    long long unsolved;                          // steps that were left at the best there was
    double residual;                             // m/s, rms; the worst: how far velocities are from solving their step

    void add(const Solves& other) {
        steps += other.steps, linear_solves += other.linear_solves, iterations += other.iterations;
        unsolved += other.unsolved;
        residual = other.residual > residual ? other.residual : residual;
    }
};

/// One pass over the rows first <= j < last: what a kernel is given.
template <class Real>
struct Pass {
    Field<Real> fields[max_fields];
    // Halos: copies of the rows beyond the block as they were before the pass, `halo` of them; null at the cloth's
    // border. The rows above go through the sweep too, for what they leave to row `first`, and are overwritten.
    Field<Real> above[max_fields], below[max_fields];
    int halo;
    int first, last, rows;
    int width;                            // elements a loop over a row covers
    const RowConstants<Real>* constants;  // of each row
    // m/s2, what terms push masses with: of every row of the cloth, or one row for all (its stride is then 0), which
    // `accelerate`, where it is not null, fills for each row. Likewise the wind (m/s), read by the air's kernels alone.
    Field<const Real> acceleration, wind;
    void (*accelerate)(void* terms, int row, double time);
    void* terms;
    AirStrength<Real> air;
    BendingStrength<Real> bending;
    AddedAirRows<Real> added;
    Field<Real> resistances;  // rows that its kernels keep
    // m/s2, part of `acceleration`: of what bending stores. Null where nothing bends, and in passes that neither
    // account nor measure.
    Field<Real> bent;
    double time;     // s, of this pass
    Real dt;         // s
    Real half_kick;  // s, from the velocity stored to that of the position's time
    WaitingRow<Real> waiting;
    RowSums* sums;    // of each row; written only by passes that account, and by methods that solve
    Field<Real> out;  // of passes that store
    // Of whole steps: whether work is summed, where the members of a team meet, and what solving took (null but for one
    // member).
    bool accounted;
    bool all_free;  // no mass is held
    void (*meet)(void* team);
    void* team;
    Solves* solves;
    // Of the passes that look for the fastest mode.
    double k_weight, c_weight, rate_weight;
};

/// A composition compiled ahead: a method, whether springs are damped, whether there are diagonals.
template <class Real>
struct Kernels {
    int passes;                        // force evaluations a step
    int fields;                        // position, velocity and what the method keeps
    int seen_position, seen_velocity;  // the fields that forces are evaluated at
    int looked_velocity;               // the same of measure and evaluate, whose position is 0
    bool staggered;                    // the velocity stored is half a step behind the position
    bool starts_with_forces;           // start and synchronised need the acceleration
    double stage_time[4];              // of each pass, in steps from the step's beginning
    void (*step)(const Pass<Real>&);   // a whole step, called by every member of a team with its rows; or null, and:
    void (*advance[4])(const Pass<Real>&);
    void (*advance_accounted[4])(const Pass<Real>&);  // the same within rounding, and the work done
    void (*measure)(const Pass<Real>&);               // energy and stretch; moves nothing
    void (*evaluate)(const Pass<Real>&);              // accelerations but for drag and friction, into `out`
    void (*stiffness)(const Pass<Real>&);             // the Hessian times a direction, see advance.hpp
    // Of the air, from fields 0 and 1 of a pass (air_rows.hpp): by whether there is pressure and whether there is skin
    // friction, what it pushes with added to `acceleration`, into `out`; how fast it brakes, into the rows' sums.
    void (*air[2][2])(const Pass<Real>&);
    void (*air_rate)(const Pass<Real>&);
    // Of the air that moves along, from the same: the passes of a look, with meetings between (extra/added_air.hpp).
    void (*added_air[3])(const Pass<Real>&);
    // Of bending, from the same (bending_rows.hpp), added to `acceleration`, into `out`: by whether it brakes and
    // whether it is accounted.
    void (*bending[2][2])(const Pass<Real>&);
    // One mass: n is its element, a its acceleration but for drag and friction.
    void (*start)(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate, Real dt);
    Vec3<Real> (*synchronised)(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate, Real dt);
    // Moves a mass by dx and its velocity by dv: what a pass after the move does.
    void (*follow)(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& dx, const Vec3<Real>& dv);
};

}  // namespace drapeau

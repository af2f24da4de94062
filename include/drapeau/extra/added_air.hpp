// Added air: the air that moves along with the cloth. It weighs more than the cloth, and as it flows past it makes the
// cloth flutter in steady wind. Lighthill's elongated-body theory in a form that holds no more energy than it is given,
// without the waves shorter than a cutoff l: these carry less air along than the theory says.
//
// With w the wind, x and v* place and velocity half-way to the next look (as they seem now), d1 and d2 the differences
// of x over r = round(l/h) masses to either side along the fly and down the hoist, n their normal, S = |d1 x d2|, D1 v*
// and D2 v* the same differences of v*, p = n.(v* - w) and mA the added mass per area, a mass of area A feels q n
// besides the pressure and friction of terms/air.hpp,
//
//   q = mA A n.dw/dt + (mA A/S) { [n.D1 v*] [(d2 x n).(v* - w)] + [n.D2 v*] [(n x d1).(v* - w)] }
//       - sum over the masses b that are r away of (mA W/4r) [-e.((v* - w) + (v* - w)_b)] p_b
//       - at an edge, for each that is missing: (mA W/2r) |t.(v* - w)| p
//
// the turn of the air with the face, its flow past it (skew-symmetric: what one mass gains another loses) and what is
// shed. e points to b, W is the width across, t the direction of d. The air's own inertia is never held back, it goes
// with every step:
//
//   a = a0 - beta n (n.a0)          beta = mA A/(m + mA A), a0 of all other forces
//
// Then the sum of m|v - w|^2/2, of the springs' energy and of mA A p^2/2 rises by no more than the hoist brings in.
// Across the hoist H, with waves as long as the fly L,
//
//   mA(y) = 2 rho sqrt((H/2)^2 - y^2)/(1 + (2 pi/L) H/2)
//
// The force is *held*: found once in K steps, from all positions and velocities between two meetings of the team.
// Sources: Lighthill 1971 as in Michelin & Doare, arXiv 1512.05532, and Singh et al., arXiv 1207.6484; Eloy et al. 2008
// (arXiv 0804.0774) on sheets as high as long; docs/model.md, "Added air".
#pragma once

#include "drapeau/model.hpp"
#include "drapeau/pass_row.hpp"
#include "drapeau/spring.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Masses from one to the next that differences are taken over: the cutoff, less on a small grid.
inline int reach_of(double cutoff, double pitch, int count) {
    const double most = std::max(1, (count - 1) / 2);
    return static_cast<int>(std::clamp(std::round(cutoff / pitch), 1.0, most));
}

/// mA (kg/m2) of row j, the mean over what the row stands for.
inline double added_mass(const Model& model, int j) {
    const Grid& grid = model.grid;
    const double half = 0.5 * (grid.rows - 1) * grid.pitch_y, fly = (grid.columns - 1) * grid.pitch_x;
    const auto area_below = [&](double y) {
        return 0.5 * (y * std::sqrt(std::max(0.0, half * half - y * y)) + half * half * std::asin(y / half));
    };
    const double y = half - j * grid.pitch_y;
    const double top = std::min(half, y + 0.5 * grid.pitch_y), bottom = std::max(-half, y - 0.5 * grid.pitch_y);
    return 2.0 * model.terms.get<Air>()->density * (area_below(top) - area_below(bottom)) / (top - bottom) /
           (1.0 + 2.0 * M_PI / fly * half);
}

/// 2 beta U/l (1/s): how fast the air's flow acts on what it carries along at a speed U (m/s). 0 without added air.
inline double added_air_rate(const Model& model, double speed) {
    const Air* const air = model.added_air();
    if (!air) return 0.0;
    const Grid& grid = model.grid;
    const double cutoff = std::min(reach_of(air->cutoff, grid.pitch_x, grid.columns) * grid.pitch_x,
                                   reach_of(air->cutoff, grid.pitch_y, grid.rows) * grid.pitch_y);
    const double mass = added_mass(model, grid.rows / 2) * model.cell();
    return 2.0 * mass / (model.springs.mass + mass) * speed / cutoff;
}
inline double added_air_rate(const Model& model) {
    return added_air_rate(model, model.fastest_air());
}

/// Over that rate. Held for 0.51 of its inverse flags stay whole, for 0.68 they do not (measured); 0.2 takes 0.7 % of
/// the drag.
inline constexpr double longest_hold = 0.5, usual_hold = 0.2;

/// K, the steps of dt (s) for which the air's force is held: usual_hold, and less where the air brakes fast or the
/// shortest wave that bends would turn by more than a radian. 0 without added air.
inline int steps_held(const Model& model, double dt) {
    if (!model.added_air()) return 0;
    constexpr double slowest = 3.0;  // m/s, for cloth that moves by itself
    const double m = model.springs.mass, braking = model.damping_of_air() / m;
    const auto b = model.bending_strength();
    const double flow = added_air_rate(model, std::max(slowest, model.fastest_air())),
                 bending = std::sqrt(Bending::fastest * (b.k_fly + b.k_hoist) / m);
    constexpr double most = 1000;
    return static_cast<int>(std::clamp(1.0 / (dt * std::max({flow / usual_hold, 2.0 * braking, bending})), 1.0, most));
}

/// Of masses a < b along a line that ends with `last`, r apart: the share of the width across over r, 0 where one is
/// missing.
inline double pair_share(int a, int b, int last, int r) {
    if (a < 0 || b > last) return 0.0;
    return (r > 1 && (a == 0 || b == last) ? 0.5 : 1.0) / r;
}
/// Likewise of what mass n sheds for those that are missing.
inline double shed_share(int n, int last, int r) {
    return ((n < r) + (n + r > last)) * (r > 1 && (n == 0 || n == last) ? 0.5 : 1.0) / r;
}

/// The air of a face that is squashed to less than this share of its size at rest turns as if it had that size: smaller
/// ones would turn it too fast for how long it is held (at 0.1 slack hoists between grommets flew apart).
inline constexpr double least_turned = 0.3;

/// What is held, and what a look works with.
template <class Real>
class AddedAir {
public:
    explicit AddedAir(const Model& model) {
        const Air* const air = model.added_air();
        if (!air) return;
        const Grid& grid = model.grid;
        for (auto& field : held) field = FieldBuffer<Real>(grid.columns, grid.rows);
        reach_x_ = reach_of(air->cutoff, grid.pitch_x, grid.columns);
        reach_y_ = reach_of(air->cutoff, grid.pitch_y, grid.rows);
        margin_ = padded<Real>(reach_x_);
        width_ = padded<Real>(grid.columns);
        stride_ = width_ + 2 * margin_;
        work_ = Array<Real>(static_cast<std::size_t>(7 * stride_ * grid.rows));
        columns_ = Array<Real>(static_cast<std::size_t>(5 * width_));
        mass_ = Array<Real>(static_cast<std::size_t>(grid.rows));
        const int last = grid.columns - 1, r = reach_x_;
        for (int i = 0; i < width_; ++i) {
            const int n = std::min(i, last);  // padding spans as much as the last column, and shares nothing
            const double exists = i <= last ? 1.0 : 0.0;
            const double of_column[] = {exists * pair_share(n, n + r, last, r), exists * pair_share(n - r, n, last, r),
                                        exists * shed_share(n, last, r), n == 0 || n == last ? 0.5 : 1.0,
                                        (std::min(n + r, last) - std::max(n - r, 0)) * grid.pitch_x};
            for (int which = 0; which < 5; ++which) columns_[which * width_ + i] = static_cast<Real>(of_column[which]);
        }
        refill(model);
    }

    /// Takes over strengths; built anew where air begins or ceases to move along or its reach is another.
    void refill(const Model& model) {
        const Air* const air = model.added_air();
        const Grid& grid = model.grid;
        const int reach_x = air ? reach_of(air->cutoff, grid.pitch_x, grid.columns) : 0,
                  reach_y = air ? reach_of(air->cutoff, grid.pitch_y, grid.rows) : 0;
        if (reach_x != reach_x_ || reach_y != reach_y_) {
            *this = AddedAir(model);
            return;
        }
        for (int j = 0; j < static_cast<int>(mass_.size()); ++j) mass_[j] = static_cast<Real>(added_mass(model, j));
    }

    AddedAirRows<Real> rows(const Grid& grid) {
        AddedAirRows<Real> all{};
        if (stride_ == 0) return all;
        all.push = held[0].view(), all.direction = held[1].view(), all.previous = held[2].view();
        Real* const work = work_.data() + margin_;
        const std::ptrdiff_t plane = stride_ * grid.rows;
        all.place = {work, work + plane, work + 2 * plane, stride_};
        all.relative = {work + 3 * plane, work + 4 * plane, work + 5 * plane, stride_};
        all.momentum = work + 6 * plane;
        all.mass = mass_.data();
        int which = 0;
        for (auto* column : {&all.right, &all.left, &all.ends, &all.across, &all.span})
            *column = columns_.data() + width_ * which++;
        all.pitch_x = static_cast<Real>(grid.pitch_x), all.pitch_y = static_cast<Real>(grid.pitch_y);
        all.columns = grid.columns, all.margin = margin_;
        all.reach_x = reach_x_, all.reach_y = reach_y_;
        return all;
    }

    FieldBuffer<Real> held[3];  // push, direction, previous: see AddedAirRows

private:
    Array<Real> work_, columns_, mass_;
    std::ptrdiff_t stride_ = 0;
    int reach_x_ = 0, reach_y_ = 0, margin_ = 0, width_ = 0;
};

/// The first of a look's three passes: x and v* - w of every mass, from fields 0 and 1 of a pass. Its wind is that of
/// the middle of the time ahead, its acceleration the wind's.
template <class V>
void added_air_flow(const Pass<typename Lanes<V>::Real>& pass) {
    using Real = typename Lanes<V>::Real;
    const AddedAirRows<Real>& air = pass.added;
    for (int j = pass.first; j < pass.last; ++j) {
        if (pass.accelerate) pass.accelerate(pass.terms, j, pass.time);
        const Field<const Real> wind = pass.wind.row(j), gust = pass.acceleration.row(j);
        const Field<Real> previous = air.previous.row(j), push = air.push.row(j);
        const Field<Real> place = air.place.row(j), relative = air.relative.row(j);
        for (int i = 0; i < pass.width; i += Lanes<V>::width) {
            const auto v = pass.fields[1].row(j).template at<V>(i);
            const auto before = air.is_first ? v : previous.template at<V>(i);
            place.set(i, pass.fields[0].row(j).template at<V>(i) + (Real(0.5) * air.ahead) * v);
            relative.set(i, v + Real(0.5) * (v - before) - wind.template at<V>(i));
            previous.set(i, v);
            push.set(i, gust.template at<V>(i));
        }
        // Beyond its edges stands a row's first mass, and its last, once more.
        for (Real* row : {place.x, place.y, place.z, relative.x, relative.y, relative.z}) {
            std::fill(row - air.margin, row, row[0]);
            std::fill(row + air.columns, row + pass.width + air.margin, row[air.columns - 1]);
        }
    }
}

/// How a face lies: the differences over the cutoff, a normal of length 1 (less where the face has shrunk to nothing)
/// and its size S.
template <class V>
struct WideFace {
    using Real = typename Lanes<V>::Real;
    Vec3<V> d1, d2, n;
    V size;

    DRAPEAU_INLINE WideFace(const Field<Real>& here, const Field<Real>& above, const Field<Real>& below, int i, int r,
                            V rest)
        : d1(here.template at<V>(i + r) - here.template at<V>(i - r)),
          d2(below.template at<V>(i) - above.template at<V>(i)) {
        const auto face = cross(d1, d2);
        const V fading = static_cast<Real>(smallest_face) * rest, square = dot(face, face);
        const V inverse = inverse_sqrt<V>(square + fading * fading);
        n = inverse * face, size = square * inverse;
    }
};

/// The second: p, the direction of the added mass, and what gusts push with.
template <class V>
void added_air_momentum(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    const AddedAirRows<Real>& air = pass.added;
    for (int j = pass.first; j < pass.last; ++j) {
        const int up = std::max(j - air.reach_y, 0), down = std::min(j + air.reach_y, pass.rows - 1);
        const Real span = Real(down - up) * air.pitch_y;
        for (int i = 0; i < pass.width; i += L::width) {
            const WideFace<V> face(air.place.row(j), air.place.row(up), air.place.row(down), i, air.reach_x,
                                   span * L::load(air.span + i));
            const V ratio = air.mass[j] * L::load(pass.constants[j].area + i), beta = ratio / (Real(1) + ratio);
            L::store(air.momentum + j * air.place.stride + i, dot(face.n, air.relative.row(j).template at<V>(i)));
            air.direction.row(j).set(i, (beta * inverse_sqrt<V>(beta)) * face.n);
            const auto gust = air.push.row(j).template at<V>(i);
            air.push.row(j).set(i, (ratio * dot(face.n, gust)) * face.n);
        }
    }
}

/// The third: all that the air pushes with, but for its inertia.
template <class V>
void added_air_push(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    const AddedAirRows<Real>& air = pass.added;
    const int last = pass.rows - 1, r = air.reach_y;
    for (int j = pass.first; j < pass.last; ++j) {
        const RowConstants<Real>& constants = pass.constants[j];
        const int up = std::max(j - r, 0), down = std::min(j + r, last);
        const Field<Real> x = air.place.row(j), u = air.relative.row(j);
        const Real* const p = air.momentum + j * air.place.stride;
        const Real span = Real(down - up) * air.pitch_y, border = j == 0 || j == last ? Real(0.5) : Real(1);
        const auto half_mass = [&](int other) { return Real(0.5) * (air.mass[j] + air.mass[other]); };
        const Real above = half_mass(up) * static_cast<Real>(pair_share(j - r, j, last, r)),
                   below = half_mass(down) * static_cast<Real>(pair_share(j, j + r, last, r)),
                   shed = air.mass[j] * static_cast<Real>(shed_share(j, last, r));
        const auto fading = static_cast<Real>(smallest_face) * air.pitch_x * air.pitch_y;
        for (int i = 0; i < pass.width; i += L::width) {
            const auto x_here = x.template at<V>(i), u_here = u.template at<V>(i);
            const V rest = span * L::load(air.span + i), p_here = L::load(p + i);
            const WideFace<V> face(x, air.place.row(up), air.place.row(down), i, air.reach_x, rest);

            // The air turns with the face.
            const auto turn = [&](const Vec3<V>& after, const Vec3<V>& before, const Vec3<V>& side)
                                  DRAPEAU_INLINE_LAMBDA { return dot(face.n, after - before) * dot(side, u_here); };
            const V turned =
                turn(u.template at<V>(i + air.reach_x), u.template at<V>(i - air.reach_x), cross(face.d2, face.n)) +
                turn(air.relative.row(down).template at<V>(i), air.relative.row(up).template at<V>(i),
                     cross(face.n, face.d1));
            const V area = L::load(constants.area + i);
            V q = (air.mass[j] * area) * (turned / L::greater(face.size, static_cast<Real>(least_turned) * rest));

            // It flows past, to and from masses in reach, and off at the edges.
            const auto carried = [&](int row, int column) DRAPEAU_INLINE_LAMBDA {
                const auto e = air.place.row(row).template at<V>(column) - x_here;
                const auto both = u_here + air.relative.row(row).template at<V>(column);
                return (dot(e, both) * inverse_length(e)) * L::load(air.momentum + row * air.place.stride + column);
            };
            const auto lost = [&](const Vec3<V>& d) DRAPEAU_INLINE_LAMBDA {
                const V along = dot(d, u_here) * inverse_length(d);
                return L::greater(along, V{} - along) * p_here;
            };
            const V past_fly = air.mass[j] * (Real(0.25) * (L::load(air.right + i) * carried(j, i + air.reach_x) +
                                                            L::load(air.left + i) * carried(j, i - air.reach_x)) -
                                              Real(0.5) * L::load(air.ends + i) * lost(face.d1));
            const V past_hoist =
                Real(0.25) * (below * carried(down, i) + above * carried(up, i)) - (Real(0.5) * shed) * lost(face.d2);
            q = q + L::load(constants.inverse_mass + i) *
                        ((border * air.pitch_y) * past_fly + (L::load(air.across + i) * air.pitch_x) * past_hoist);

            // Pressure and friction, as in air_rows.hpp.
            const auto flow = air_flow(x.template at<V>(i + 1) - x.template at<V>(i - 1),
                                       air.place.row(std::max(j - 1, 0)).template at<V>(i) -
                                           air.place.row(std::min(j + 1, last)).template at<V>(i),
                                       Vec3<V>{} - u_here, fading * fading);
            const Field<Real> push = air.push.row(j);
            push.set(i, push.template at<V>(i) + q * face.n +
                            ((pass.air.pressure * area) * (flow.speed * flow.across)) * flow.face +
                            ((pass.air.skin * area) * flow.speed_along) * flow.along);
        }
    }
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

// TautLine: masses in a line, moved as little as possible until none of the springs between them is too long.
//
// Spring k, from mass k to mass k+1 in direction e_k, is too long by C_k (negative: it may grow by so much). Of all
// small moves that leave none too long the one with the least sum of m |dx|^2 / 2 pulls with tensions T_k >= 0,
//
//   dx_k = w_k (T_k e_k - T_{k-1} e_{k-1}),   w = 1/m, 0 for a held mass,
//   (w_k + w_{k+1}) T_k - w_k (e_{k-1}.e_k) T_{k-1} - w_{k+1} (e_k.e_{k+1}) T_{k+1} >= C_k,   equal where T_k > 0,
//
// a linear complementarity problem with a tridiagonal matrix. Where the line turns back on itself (e.e < 0) that
// coupling is left out. Then no element beside the diagonal is positive, so tensions only grow as springs join those
// that are taut (Chandrasekaran 1970; Cryer 1983 for the tridiagonal case), and every solve begins with the ones
// before: elimination from one end lets all join that a pull from there makes taut, then from the other end. On a
// straight line two eliminations are exact. A pull is equal and opposite on both ends: linear and angular momentum are
// kept.
#pragma once

#include "drapeau/field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drapeau {
inline namespace DRAPEAU_ISA {

class TautLine {
public:
    TautLine() = default;
    explicit TautLine(int most_masses) : all_(static_cast<std::size_t>(most_masses) + 1) {}

    /// Shortens a line of `springs` once. at(k): place of mass k (m); inverse_mass(k): its w, in any unit; longest(k):
    /// how long spring k may be (m); move(k, dx): what mass k is to be moved by. `beyond`: a spring that is too long is
    /// shortened by so much more, as a share, but by no more than a hundredth of its length. Returns by how much
    /// springs that can be shortened were too long, in all (m).
    template <class At, class InverseMass, class Longest, class Move>
    double shorten(int springs, double beyond, const At& at, const InverseMass& inverse_mass, const Longest& longest,
                   const Move& move) {
        springs_ = springs;
        // A line that is held too far apart has no solution: so little give leaves that evenly to all springs. It is
        // well below the matrix's smallest eigenvalue elsewhere, some (pi/2n)^2 of its diagonal.
        const double give = 1.0 + 1e-4 / (static_cast<double>(springs) * springs);
        double sum = 0.0;
        Vec3<double> here = at(0);
        link(0).w = inverse_mass(0);
        link(springs) = {};
        for (int k = 0; k < springs; ++k) {
            Link &s = link(k), &next = link(k + 1);
            const Vec3<double> there = at(k + 1), d = there - here;
            here = there;
            next.w = inverse_mass(k + 1);
            const double l = std::sqrt(dot(d, d)), w = s.w + next.w;
            s.longest = longest(k);
            s.e = (l > 0.0 ? 1.0 / l : 0.0) * d;
            s.excess = l - s.longest;
            s.own = give * w;
            s.taut = false;
            s.coupling = s.w * std::max(0.0, dot(link(k - 1).e, s.e));
            if (s.excess <= 0.0 || w == 0.0) continue;
            sum += s.excess;
            s.excess += std::min(beyond * s.excess, 0.01 * s.longest);
        }
        if (sum == 0.0) return 0.0;
        for (int turn = 0; turn < most_turns && tighten(turn % 2 == 0); ++turn) continue;

        // Springs that turn grow by about |across|^2 / 2l: no farther than where that takes back what was gained
        double gained = 0.0, lost = 0.0;
        for (int k = 0; k <= springs; ++k) {
            Link &s = link(k), &before = link(k - 1);
            s.dx = s.w * (s.pull * s.e - before.pull * before.e);
            if (!before.taut) continue;
            const Vec3<double> d = s.dx - before.dx;
            const double along = dot(d, before.e);
            gained += std::max(0.0, before.excess);
            lost += std::max(0.0, dot(d, d) - along * along) / (2.0 * before.longest);
        }
        const double share = 2.0 * lost > gained ? gained / (2.0 * lost) : 1.0;
        for (int k = 0; k <= springs; ++k)
            if (link(k).pull > 0.0 || link(k - 1).pull > 0.0) move(k, share * link(k).dx);
        return sum;
    }

private:
    /// More are seldom needed; what they leave is found in the next sweep.
    static constexpr int most_turns = 8;

    struct Link {
        Vec3<double> e{}, dx{};  // direction; m, of the mass that it starts from
        double w = 0.0, longest = 0.0, excess = 0.0, own = 0.0, coupling = 0.0, pivot = 0.0, right = 0.0, pull = 0.0;
        bool taut = false;
    };
    Link& link(int k) { return all_[static_cast<std::size_t>(k + 1)]; }

    /// Solves for the pulls of taut springs, from one end to the other and back. Returns whether others become taut.
    bool tighten(bool forth) {
        const int first = forth ? 0 : springs_ - 1, last = springs_ - 1 - first, step = forth ? 1 : -1;
        const auto coupling = [&](int k, int next) { return link(std::max(k, next)).coupling; };
        for (int k = first; k != last + step; k += step) {
            Link &s = link(k), &before = link(k - step);
            s.pivot = s.own, s.right = s.excess;
            if (k != first && before.taut) {
                const double share = coupling(k, k - step) / before.pivot;
                s.pivot -= share * coupling(k, k - step);
                s.right += share * before.right;
            }
            s.taut = s.taut || (s.right > 0.0 && s.own > 0.0);
        }
        for (int k = last; k != first - step; k -= step) {
            Link& s = link(k);
            s.pull =
                s.taut ? (s.right + (k == last ? 0.0 : coupling(k, k + step) * link(k + step).pull)) / s.pivot : 0.0;
        }
        bool joined = false;
        for (int k = 0; k < springs_; ++k) {
            Link &s = link(k), &next = link(k + 1);
            if (s.taut || s.own == 0.0 || s.excess + s.coupling * link(k - 1).pull + next.coupling * next.pull <= 0.0)
                continue;
            s.taut = joined = true;
        }
        return joined;
    }

    std::vector<Link> all_;  // one of no length, then one from each mass
    int springs_ = 0;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

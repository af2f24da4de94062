// Block: the rows that one member of a team moves, with the halos between it and its neighbours.
//
// Between two blocks each side keeps a halo: copies of the other's rows as they were before the pass, as many as the
// operation reaches. Springs across are evaluated by both sides, from the same numbers in the same order, so one
// barrier a pass is enough (copies for the next pass are written while those of this one are read), and the bits are
// the same for any number of blocks.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/contact_rows.hpp"
#include "drapeau/model_rows.hpp"

#include <algorithm>
#include <vector>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// When each step of a run begins: a whole number of steps times dt, never a running sum.
struct Clock {
    double start = 0.0;   // s, the beginning of step `first`
    long long first = 0;  // since the run began
    double dt = 0.0;      // s

    double at(long long step) const { return start + static_cast<double>(step - first) * dt; }
};

inline constexpr long long no_step = -1;

/// A model and its state as compiled kernels see them: what all blocks share.
template <class Real>
struct Body {
    Body(const Model& of, const Kernels<Real>& by)
        : model(of), kernels(by), rows(of), added(of), sums(static_cast<std::size_t>(of.grid.rows)) {
        const bool bends = model.terms.template get<Bending>().has_value();
        if (bends || model.terms.template get<Air>()) pushed = FieldBuffer<Real>(model.grid.columns, model.grid.rows);
        if (bends) bent = FieldBuffer<Real>(model.grid.columns, model.grid.rows), halo_rows = bending_reach;
        for (int f = 0; f < kernels.fields; ++f) fields.emplace_back(model.grid.columns, model.grid.rows, f);
        if (model.touches()) before = fields[0];
    }
    Body(const Body&) = delete;

    Model model;
    Kernels<Real> kernels;
    ModelRows<Real> rows;
    std::vector<FieldBuffer<Real>> fields;  // position, velocity and what the method keeps
    // What terms push each mass with, and of that what bending stores; empty but with terms that see where masses are.
    FieldBuffer<Real> pushed, bent;
    FieldBuffer<Real> before;  // positions before the step; empty but where masses may touch something
    AddedAir<Real> added;
    int halo_rows = SpringForce<Real, true>::reach;
    Array<RowSums> sums;  // not std's: its functions would be shared between instruction sets (isa.hpp)
};

template <class Real>
class Block {
public:
    /// Block `number` of `count` blocks of about as many rows each.
    Block(Body<Real>& body, int number, int count)
        : body_(body),
          first_(static_cast<int>(1LL * body.model.grid.rows * number / count)),
          last_(static_cast<int>(1LL * body.model.grid.rows * (number + 1) / count)),
          halo_rows_(body.halo_rows),
          waiting_(body.rows.width()),
          acceleration_(body.model.grid.columns, 1),
          wind_(body.model.grid.columns, 1),
          resistances_(body.bent.columns(), body.bent.columns() > 0 ? resistance_rows : 0),
          ones_(static_cast<std::size_t>(body.rows.width())) {
        std::fill(ones_.begin(), ones_.end(), Real(1));
        for (int parity = 0; parity < 2; ++parity)
            for (int f = 0; f < body.kernels.fields; ++f) {
                if (number > 0) above_[parity].emplace_back(body.model.grid.columns, halo_rows_, f);
                if (number + 1 < count) below_[parity].emplace_back(body.model.grid.columns, halo_rows_, f);
            }
    }
    Block(const Block&) = delete;

    /// Both are to hand over their borders to each other.
    void join(Block& below) {
        next_ = &below;
        below.previous_ = this;
    }

    /// Takes the steps from <= n < to of the clock; in step `accounted` the work of every force is summed. `meet`
    /// returns when every block has come there; the air that moves along is looked at in each step whose number is a
    /// multiple of `held`, if that is not 0; after_the_move(step) is called by every block between two meetings.
    /// `solves` gets what solving took; null but for one block.
    template <class Meet, class AfterTheMove>
    void advance(const Clock& clock, long long from, long long to, long long accounted, int held, Meet&& meet,
                 AfterTheMove&& after_the_move, Solves* solves) {
        const auto& k = body_.kernels;
        if (k.step) return solve(clock, from, to, accounted, held, meet, after_the_move, solves);
        Pass<Real> p = pass(clock.dt);
        int parity = 0;
        hand_over(parity);
        meet();
        for (long long step = from; step < to; ++step) {
            if (held > 0 && step % held == 0) look_at_added_air(clock.at(step), held * clock.dt, false, meet);
            const auto* kernels = step == accounted ? k.advance_accounted : k.advance;
            remember();
            for (int n = 0; n < k.passes; ++n) {
                p.time = clock.at(step) + k.stage_time[n] * clock.dt;
                use_halos(p, parity);
                push(p, k.seen_position, k.seen_velocity, step == accounted);
                kernels[n](p);
                parity = 1 - parity;
                if (n + 1 == k.passes) after_the_move(step);
                hand_over(parity);
                meet();
            }
        }
    }

    /// A pass that moves nothing, at time `now` (s), for a method that was started with the step dt (s).
    void look(double now, double dt, void (*kernel)(const Pass<Real>&), const Field<Real>& out) {
        Pass<Real> p = pass(dt);
        look_beyond(p);
        p.time = now;
        push(p, 0, body_.kernels.looked_velocity, kernel == body_.kernels.measure);
        p.out = out;
        kernel(p);
    }

    /// What the air that moves along does from time `now` (s) on, for `ahead` (s); is_first: nothing is known of
    /// before. Nothing may move until every block is done.
    template <class Meet>
    void look_at_added_air(double now, double ahead, bool is_first, Meet&& meet) {
        Pass<Real> p = pass(0.0);
        p.time = now;
        p.added.ahead = static_cast<Real>(ahead), p.added.is_first = is_first;
        ahead_ = ahead;
        p.accelerate = body_.model.varies_by_row() ? &find_gust_of_row : nullptr;
        if (!p.accelerate) find_gust(first_, now);
        for (int n = 0; n < 3; ++n) {
            if (n > 0) meet();
            call(p, body_.kernels.seen_position, body_.kernels.seen_velocity, {}, body_.kernels.added_air[n]);
        }
    }

    /// How fast the air brakes masses at time `now` (s), into the rows' sums.
    void look_at_air(double now) {
        Pass<Real> p = pass(0.0);
        look_beyond(p);
        p.time = now;
        begin_terms(p);
        if (body_.model.added_air()) {  // then terms do not ask for the wind
            p.accelerate = body_.model.varies_by_row() ? &find_wind_of_row : nullptr;
            if (!p.accelerate) find_wind(first_, now);
        }
        call(p, 0, 1, p.out, body_.kernels.air_rate);
    }

    /// The Hessian (stiffness_rows in advance.hpp) times a direction, into `out`.
    void stiffness(double k_weight, double c_weight, double rate_weight, const Field<Real>& direction,
                   const Field<Real>& out) {
        Pass<Real> p = pass(0.0);
        p.fields[1] = direction;
        look_beyond(p);
        p.k_weight = k_weight, p.c_weight = c_weight, p.rate_weight = rate_weight;
        if (const Bending* const bending = body_.model.bending()) {
            // Bending is linear: it makes of a direction what it makes of positions.
            const BendingStrength<Real> b = p.bending;
            std::fill_n(acceleration_.component(0).begin(), body_.rows.width(), Real(0));
            for (int c = 1; c < 3; ++c) acceleration_.component(c) = acceleration_.component(0);
            p.bent = body_.bent.view();
            call(p, 1, 1, p.bent, body_.kernels.bending[0][0]);
            if (bending->damping) {
                p.bending = {b.c_fly, b.c_hoist, Real(0), Real(0)};
                call(p, 1, 1, body_.pushed.view(), body_.kernels.bending[0][0]);
                p.acceleration = std::as_const(body_.pushed).view();
            }
        }
        p.out = out;
        body_.kernels.stiffness(p);
    }

    /// The contacts, after a step of dt (s).
    void touch(double dt) {
        Pass<Real> p = pass(dt);
        body_.model.limits.for_each([&]<class Limit>(const Limit& limit) {
            if constexpr (Contact<Limit>)
                touch_rows(limit, body_.model.grid, dt, p, std::as_const(body_.before).view(), body_.kernels.follow);
        });
    }

    /// Kinetic energy of the velocities as stored, into the rows' sums.
    void sum_kinetic() {
        using V = Vector<Real, 16>;
        const auto velocity = std::as_const(body_.fields[1]).view();
        for (int j = first_; j < last_; ++j) {
            V sum{};
            for (int i = 0; i < body_.rows.width(); i += Lanes<V>::width) {
                const auto v = velocity.row(j).template at<V>(i);
                sum = sum + Lanes<V>::load(body_.rows.constants()[j].mass + i) * dot(v, v);
            }
            body_.sums[j].kinetic = 0.5 * sum_of(sum);
        }
    }

private:
    /// Whole steps: nothing that neighbours look at changes but between two meetings, so they look at it where it is.
    template <class Meet, class AfterTheMove>
    void solve(const Clock& clock, long long from, long long to, long long accounted, int held, Meet&& meet,
               AfterTheMove&& after_the_move, Solves* solves) {
        Pass<Real> p = pass(clock.dt);
        look_beyond(p);
        p.meet = [](void* team) { (*static_cast<std::remove_reference_t<Meet>*>(team))(); };
        p.team = const_cast<void*>(static_cast<const void*>(&meet));
        p.solves = solves;
        p.all_free = body_.model.is_free();
        for (long long step = from; step < to; ++step) {
            if (held > 0 && step % held == 0) look_at_added_air(clock.at(step), held * clock.dt, false, meet);
            p.time = clock.at(step) + body_.kernels.stage_time[0] * clock.dt;
            p.accounted = step == accounted;
            push(p, 0, 1, p.accounted);
            remember();
            body_.kernels.step(p);
            after_the_move(step);
            meet();
        }
    }

    /// Where this block's masses are, for the contacts at the step's end.
    void remember() {
        if (body_.before.columns() == 0) return;
        const std::ptrdiff_t stride = body_.before.stride();
        for (int c = 0; c < 3; ++c)
            std::copy_n(body_.fields[0].component(c).begin() + first_ * stride, (last_ - first_) * stride,
                        body_.before.component(c).begin() + first_ * stride);
    }

    /// Instead of halos, the neighbours' rows themselves.
    void look_beyond(Pass<Real>& p) {
        if (first_ > 0)
            for (int f = 0; f < max_fields; ++f) p.above[f] = p.fields[f].row(first_ - halo_rows_);
        if (last_ < p.rows)
            for (int f = 0; f < max_fields; ++f) p.below[f] = p.fields[f].row(last_);
    }

    Pass<Real> pass(double dt) {
        Pass<Real> p{};
        for (int f = 0; f < body_.kernels.fields; ++f) p.fields[f] = body_.fields[f].view();
        p.halo = halo_rows_;
        p.first = first_, p.last = last_, p.rows = body_.model.grid.rows;
        p.width = body_.rows.width();
        p.constants = body_.rows.constants();
        p.acceleration = one_for_all(acceleration_), p.wind = one_for_all(wind_);
        p.terms = this;
        p.dt = static_cast<Real>(dt);
        p.half_kick = body_.kernels.starts_with_forces ? static_cast<Real>(0.5 * dt) : Real(0);
        if (const Air* const air = body_.model.air()) p.air = air->template strength<Real>();
        p.added = body_.added.rows(body_.model.grid);
        const auto b = body_.model.bending_strength();
        p.bending = {static_cast<Real>(b.k_fly), static_cast<Real>(b.k_hoist), static_cast<Real>(b.c_fly),
                     static_cast<Real>(b.c_hoist)};
        p.resistances = resistances_.view();
        p.waiting = waiting_.view();
        p.sums = body_.sums.data();
        return p;
    }

    /// What terms push masses with in a pass, from its state in these fields; accounted: what of it is stored as well.
    /// Nothing may have moved yet.
    void push(Pass<Real>& p, int position_field, int velocity_field, bool accounted) {
        begin_terms(p);
        const auto gather = [&](void (*kernel)(const Pass<Real>&)) {
            call(p, position_field, velocity_field, body_.pushed.view(), kernel);
            p.acceleration = std::as_const(body_.pushed).view();
            p.accelerate = nullptr;
        };
        if (const Air* const air = body_.model.air(); air && !body_.model.added_air())
            gather(body_.kernels.air[air->pressure.has_value()][air->skin.has_value()]);
        if (const Bending* const bending = body_.model.bending()) {
            p.bent = accounted ? body_.bent.view() : Field<Real>{};
            gather(body_.kernels.bending[bending->damping.has_value()][accounted]);
        }
    }
    /// Terms that do not see where masses are: once for all rows, or row by row.
    void begin_terms(Pass<Real>& p) {
        p.acceleration = one_for_all(acceleration_);
        p.accelerate = body_.model.varies_by_row() ? &accelerate_row : nullptr;
        if (!p.accelerate) accelerate(first_, p.time);
    }
    /// Calls a kernel of terms that see where masses are: it finds the state in fields 0 and 1.
    void call(Pass<Real> p, int position_field, int velocity_field, const Field<Real>& out,
              void (*kernel)(const Pass<Real>&)) {
        for (auto* fields : {p.fields, p.above, p.below}) {
            const Field<Real> x = fields[position_field], v = fields[velocity_field];
            fields[0] = x, fields[1] = v;
        }
        p.out = out;
        kernel(p);
    }
    static Field<const Real> one_for_all(const FieldBuffer<Real>& row) {
        auto view = row.view();
        view.stride = 0;
        return view;
    }

    void accelerate(int row, double time) {
        auto a = acceleration_.view();
        for (Real* component : {a.x, a.y, a.z}) std::fill_n(component, body_.rows.width(), Real(0));
        const PushedRow<Real> pushed{body_.model.grid, row, body_.rows.width(), body_.rows.drag_rate(body_.model, row)};
        body_.model.terms.for_each([&](const auto& term) {
            if constexpr (requires { term.accelerate(pushed, time, a); }) term.accelerate(pushed, time, a);
        });
        if (body_.model.air() && !body_.model.added_air()) find_wind(row, time);
    }
    void find_wind(int row, double time) {
        auto w = wind_.view();
        for (Real* component : {w.x, w.y, w.z}) std::fill_n(component, body_.rows.width(), Real(0));
        const PushedRow<Real> carried{body_.model.grid, row, body_.rows.width(), ones_.data()};
        if (const auto& wind = body_.model.terms.template get<Wind>()) wind->accelerate(carried, time, w);
    }
    /// The wind in the middle of the time ahead, and in place of what terms push with how fast it changes (m/s2).
    void find_gust(int row, double time) {
        find_wind(row, time + ahead_);
        acceleration_.take(wind_);
        find_wind(row, time);
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < body_.rows.width(); ++i) {
                Real &w = wind_.component(c)[i], &a = acceleration_.component(c)[i];
                const Real change = a - w;
                w += Real(0.5) * change;
                a = ahead_ > 0.0 ? change / static_cast<Real>(ahead_) : Real(0);
            }
    }
    static void find_gust_of_row(void* block, int row, double time) {
        static_cast<Block*>(block)->find_gust(row, time);
    }
    static void find_wind_of_row(void* block, int row, double time) {
        static_cast<Block*>(block)->find_wind(row, time);
    }
    static void accelerate_row(void* block, int row, double time) { static_cast<Block*>(block)->accelerate(row, time); }

    /// Copies of this block's outermost rows for the neighbours.
    void hand_over(int parity) {
        const auto copy = [&](std::vector<FieldBuffer<Real>>& halo, int from) {
            for (const int f : {body_.kernels.seen_position, body_.kernels.seen_velocity})
                for (int c = 0; c < 3; ++c) {
                    const auto& source = body_.fields[f].component(c);
                    const std::ptrdiff_t stride = body_.fields[f].stride();
                    std::copy_n(source.begin() + from * stride, halo_rows_ * stride, halo[f].component(c).begin());
                }
        };
        if (previous_) copy(previous_->below_[parity], first_);
        if (next_) copy(next_->above_[parity], last_ - halo_rows_);
    }
    void use_halos(Pass<Real>& p, int parity) {
        for (std::size_t f = 0; f < above_[parity].size(); ++f) p.above[f] = above_[parity][f].view();
        for (std::size_t f = 0; f < below_[parity].size(); ++f) p.below[f] = below_[parity][f].view();
    }

    Body<Real>& body_;
    Block *previous_ = nullptr, *next_ = nullptr;
    int first_, last_, halo_rows_;  // rows
    WaitingBuffer<Real> waiting_;
    FieldBuffer<Real> acceleration_, wind_;  // one row
    FieldBuffer<Real> resistances_;          // of bending
    double ahead_ = 0.0;                     // s, for which a look at the air that moves along is held
    Array<Real> ones_;
    std::vector<FieldBuffer<Real>> above_[2], below_[2];  // of even and odd passes; empty at the cloth's border
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

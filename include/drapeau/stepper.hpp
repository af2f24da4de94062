// Stepper: a model's masses moved by compiled kernels: fields, halos, threads, passes after the move.
//
// A batch of steps runs as one region of a team. Each member owns a block of rows. Between two blocks each side keeps a
// halo: copies of the other's rows as they were before the pass, as many as the operation reaches. Springs across are
// evaluated by both sides, from the same numbers in the same order, so one barrier a pass is enough (copies for the
// next pass are written while those of this one are read), and the bits are the same for any number of members.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/model.hpp"
#include "drapeau/team.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
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

/// What a batch of steps did, summed on the way.
struct Report {
    Work work;         // in the step that was accounted
    PassReport limit;  // of passes after the move
};

inline constexpr long long no_step = -1;

template <class Real>
class Stepper {
public:
    /// All masses at rest at their places in the grid.
    Stepper(const Model& model, const Kernels<Real>& kernels)
        : model_(model), kernels_(kernels), rows_(model), sums_(static_cast<std::size_t>(model.grid.rows)) {
        for (int f = 0; f < kernels.fields; ++f) fields_.emplace_back(model.grid.columns, model.grid.rows, f);
        whole_ = std::make_unique<Member>(*this, 0, 1);
        use_threads(1);
        for (int j = 0; j < model.grid.rows; ++j)
            for (int i = 0; i < model.grid.columns; ++i) fields_[0].set(i, j, model.grid.rest(i, j));
    }
    Stepper(const Stepper&) = delete;

    const Model& model() const { return model_; }
    int threads() const { return static_cast<int>(members_.size()); }
    const FieldBuffer<Real>& position() const { return fields_[0]; }
    const FieldBuffer<Real>& velocity() const { return fields_[1]; }  // as the method stores it

    /// `count` members, fewer if there are not two rows for each. Throws std::system_error where the system gives no
    /// more threads, and stays as it was.
    void use_threads(int count) {
        const int members = std::clamp(model_.grid.rows / std::max(2, halo_rows), 1, std::max(1, count));
        auto team = members > 1 ? std::make_unique<Team>(members) : nullptr;
        std::vector<std::unique_ptr<Member>> all;
        for (int n = 0; n < members; ++n) all.push_back(std::make_unique<Member>(*this, n, members));
        team_ = std::move(team);
        members_ = std::move(all);
    }

    /// Takes over strengths. The grid and what is listed stay as they are.
    void refill(const Model& model) {
        model_ = model;
        rows_.refill(model);
    }

    /// Position and velocity at the same time (s); held masses get no velocity.
    void set(const State<double>& state) {
        fields_[0].take(state.position);
        fields_[1].take(state.velocity);
        for (int j = 0; j < model_.grid.rows; ++j)
            for (int i = 0; i < model_.grid.columns; ++i)
                if (model_.held(i, j)) fields_[1].set(i, j, glm::dvec3(0.0));
        have_synchronised();
    }
    /// Both at time `now` (s), the clock's time of the step to come. Reading it does not alter the run.
    State<double> state(double now) {
        State<double> state(model_.grid.columns, model_.grid.rows);
        state.position.take(fields_[0]);
        state.velocity.take(synchronised_velocity(now));
        return state;
    }

    /// Takes the steps first <= n < last of the clock. In step `accounted` the work of every force is summed.
    Report advance(const Clock& clock, long long first, long long last, long long accounted = no_step) {
        if (started_dt_ != clock.dt) restart(clock.at(first), clock.dt);
        Report report;
        const bool accounts = accounted >= first && accounted < last;
        if (accounts) std::fill(sums_.begin(), sums_.end(), RowSums{});
        run([&](int n) { members_[n]->advance(clock, first, last, accounted, report); });
        if (accounts)
            for (const auto& row : sums_) {
                report.work.external += row.external_work;
                report.work.damping += row.damping_work;
            }
        report.work.passes = pass_energy_;
        pass_energy_ = 0.0;
        return report;
    }

    /// Energy and stretch at time `now` (s), the velocity as stored: for staggered methods kinetic energy is
    /// sum m v-.v+ / 2, which is constant in linear motion at any stable step.
    Measurement measure(double now) {
        run([&](int n) { members_[n]->look(now, kernels_.measure, {}); });
        return sum_up();
    }

    /// Everything that the steps to come depend on.
    struct Checkpoint {
        std::vector<FieldBuffer<Real>> fields;
        double started_dt = 0.0;
    };
    void save(Checkpoint& into) const {
        into.fields = fields_;
        into.started_dt = started_dt_;
    }
    void restore(const Checkpoint& from) {
        fields_ = from.fields;
        started_dt_ = from.started_dt;
    }

    /// Lets the method start again, with another step or from a changed state.
    void synchronise(double now) {
        if (started_dt_ == 0.0) return;
        fields_[1] = synchronised_velocity(now);
        have_synchronised();
    }

    /// Kinetic energy (J) of the velocities as stored, for little.
    double kinetic() {
        run([&](int n) { members_[n]->sum_kinetic(); });
        double sum = 0.0;
        for (const auto& row : sums_) sum += row.kinetic;
        return sum;
    }

private:
    static constexpr int halo_rows = SpringForce<Real, true>::reach;

    /// One member of the team: its rows, its halos and what its passes write to.
    struct Member {
        Stepper& all;
        int number, first, last;
        WaitingBuffer<Real> waiting;
        FieldBuffer<Real> acceleration;
        std::vector<FieldBuffer<Real>> above[2], below[2];  // of even and odd passes; empty at the cloth's border

        Member(Stepper& stepper, int n, int members)
            : all(stepper),
              number(n),
              first(static_cast<int>(1LL * stepper.model_.grid.rows * n / members)),
              last(static_cast<int>(1LL * stepper.model_.grid.rows * (n + 1) / members)),
              waiting(stepper.rows_.width()),
              acceleration(stepper.model_.grid.columns, 1) {
            for (int parity = 0; parity < 2; ++parity)
                for (int f = 0; f < stepper.kernels_.fields; ++f) {
                    if (n > 0) above[parity].emplace_back(stepper.model_.grid.columns, halo_rows, f);
                    if (n + 1 < members) below[parity].emplace_back(stepper.model_.grid.columns, halo_rows, f);
                }
        }

        Pass<Real> pass(double dt) {
            Pass<Real> p{};
            for (int f = 0; f < all.kernels_.fields; ++f) p.fields[f] = all.fields_[f].view();
            p.halo = halo_rows;
            p.first = first, p.last = last, p.rows = all.model_.grid.rows;
            p.width = all.rows_.width();
            p.constants = all.rows_.constants();
            p.acceleration = std::as_const(acceleration).view();
            if (all.model_.varies_by_row()) p.accelerate = &accelerate_row;
            p.terms = this;
            p.dt = static_cast<Real>(dt);
            p.waiting = waiting.view();
            p.sums = all.sums_.data();
            return p;
        }

        void advance(const Clock& clock, long long from, long long to, long long accounted, Report& report) {
            const auto& k = all.kernels_;
            const bool alone = all.members_.size() == 1, limited = all.is_limited();
            Pass<Real> p = pass(clock.dt);
            int parity = 0;
            if (!alone) hand_over(parity), all.team_->meet();
            for (long long step = from; step < to; ++step) {
                const auto* kernels = step == accounted ? k.advance_accounted : k.advance;
                for (int n = 0; n < k.passes; ++n) {
                    p.time = clock.at(step) + k.stage_time[n] * clock.dt;
                    if (!p.accelerate) accelerate(first, p.time);
                    use_halos(p, parity);
                    kernels[n](p);
                    parity = 1 - parity;
                    if (limited && n + 1 == k.passes) {
                        if (!alone) all.team_->meet();
                        if (number == 0) all.after_the_move(clock.at(step + 1), clock.dt, step == accounted, report);
                        if (!alone) all.team_->meet();
                    }
                    if (!alone) hand_over(parity), all.team_->meet();
                }
            }
        }

        /// A pass that moves nothing.
        void look(double now, void (*kernel)(const Pass<Real>&), const Field<Real>& out) {
            Pass<Real> p = pass(all.started_dt_);
            const auto view = [&](int row, Field<Real>* halo) {
                for (int f = 0; f < all.kernels_.fields; ++f) halo[f] = all.fields_[f].view().row(row);
            };
            if (first > 0) view(first - halo_rows, p.above);
            if (last < p.rows) view(last, p.below);
            p.time = now;
            p.out = out;
            if (!p.accelerate) accelerate(first, now);
            kernel(p);
        }

        void sum_kinetic() {
            using V = Vector<Real, 16>;
            const auto velocity = std::as_const(all.fields_[1]).view();
            for (int j = first; j < last; ++j) {
                V sum{};
                for (int i = 0; i < all.rows_.width(); i += Lanes<V>::width) {
                    const auto v = velocity.row(j).template at<V>(i);
                    sum = sum + Lanes<V>::load(all.rows_.constants()[j].mass + i) * dot(v, v);
                }
                all.sums_[j].kinetic = 0.5 * sum_of(sum);
            }
        }

        void accelerate(int row, double time) {
            auto a = acceleration.view();
            for (Real* component : {a.x, a.y, a.z}) std::fill_n(component, all.rows_.width(), Real(0));
            const PushedRow<Real> pushed{all.model_.grid, row, all.rows_.width(), all.rows_.drag_rate(all.model_, row)};
            all.model_.terms.for_each([&](const auto& term) {
                if constexpr (requires { term.accelerate(pushed, time, a); }) term.accelerate(pushed, time, a);
            });
        }
        static void accelerate_row(void* member, int row, double time) {
            static_cast<Member*>(member)->accelerate(row, time);
        }

        /// Copies of this block's outermost rows for the neighbours.
        void hand_over(int parity) {
            const auto copy = [&](std::vector<FieldBuffer<Real>>& halo, int from) {
                for (const int f : {all.kernels_.seen_position, all.kernels_.seen_velocity})
                    for (int c = 0; c < 3; ++c) {
                        const auto& source = all.fields_[f].component(c);
                        const std::ptrdiff_t stride = all.fields_[f].stride();
                        std::copy_n(source.begin() + from * stride, halo_rows * stride, halo[f].component(c).begin());
                    }
            };
            if (number > 0) copy(all.members_[number - 1]->below[parity], first);
            if (number + 1 < all.threads()) copy(all.members_[number + 1]->above[parity], last - halo_rows);
        }
        void use_halos(Pass<Real>& p, int parity) {
            for (std::size_t f = 0; f < above[parity].size(); ++f) p.above[f] = above[parity][f].view();
            for (std::size_t f = 0; f < below[parity].size(); ++f) p.below[f] = below[parity][f].view();
        }
    };

    template <class Region>
    void run(const Region& region) {
        if (members_.size() == 1) return region(0);
        team_->run([&](int n) { region(n); });
    }

    bool is_limited() const {
        bool any = false;
        model_.limits.for_each([&](const auto&) { any = true; });
        return any;
    }

    /// The passes after the move, by one member: positions are corrected, then velocities follow.
    void after_the_move(double now, double dt, bool accounted, Report& report) {
        const double before = accounted ? measure_alone(now).balance() : 0.0;
        moved_ = fields_[0];
        bool changed = false;
        model_.limits.for_each([&](const auto& limit) {
            const PassReport done = limit.apply(model_.grid, model_.has_diagonals(), rows_.constants(), moved_.view());
            report.limit.add(done);
            changed = changed || done.sweeps > 0;
        });
        if (!changed) return;
        Field<Real> fields[max_fields]{};
        for (int f = 0; f < kernels_.fields; ++f) fields[f] = fields_[f].view();
        const auto to = moved_.view();
        for (int j = 0; j < model_.grid.rows; ++j)
            for (int i = 0; i < model_.grid.columns; ++i) {
                const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(j) * to.stride + i;
                const auto dx = to.template at<Real>(n) - fields[0].template at<Real>(n);
                if (dx.x != 0 || dx.y != 0 || dx.z != 0) kernels_.follow(fields, n, dx, static_cast<Real>(dt));
            }
        if (accounted) pass_energy_ += measure_alone(now).balance() - before;
    }

    void restart(double now, double dt) {
        synchronise(now);
        started_dt_ = dt;
        FieldBuffer<Real> a(model_.grid.columns, model_.grid.rows);
        if (kernels_.starts_with_forces) evaluate(now, a);
        each_mass([&](const Field<Real>* fields, std::ptrdiff_t n, int i, int j) {
            kernels_.start(fields, n, a.view().template at<Real>(n), rows_.constants()[j].rate[i],
                           static_cast<Real>(dt));
        });
    }

    /// Position and velocity are at the same time: dampers look at that velocity until the method starts.
    void have_synchronised() {
        if (kernels_.seen_velocity != 1) fields_[kernels_.seen_velocity] = fields_[1];
        started_dt_ = 0.0;
    }

    FieldBuffer<Real> synchronised_velocity(double now) {
        if (started_dt_ == 0.0 || !kernels_.starts_with_forces) return fields_[1];
        FieldBuffer<Real> a(model_.grid.columns, model_.grid.rows), v(model_.grid.columns, model_.grid.rows);
        evaluate(now, a);
        each_mass([&](const Field<Real>* fields, std::ptrdiff_t n, int i, int j) {
            v.view().set(n, kernels_.synchronised(fields, n, a.view().template at<Real>(n),
                                                  rows_.constants()[j].rate[i], static_cast<Real>(started_dt_)));
        });
        return v;
    }

    void evaluate(double now, FieldBuffer<Real>& a) {
        run([&](int n) { members_[n]->look(now, kernels_.evaluate, a.view()); });
    }

    template <class Visit>
    void each_mass(Visit&& visit) {
        Field<Real> fields[max_fields]{};
        for (int f = 0; f < kernels_.fields; ++f) fields[f] = fields_[f].view();
        for (int j = 0; j < model_.grid.rows; ++j)
            for (int i = 0; i < model_.grid.columns; ++i)
                visit(fields, static_cast<std::ptrdiff_t>(j) * fields[0].stride + i, i, j);
    }

    /// Within a region, by one member for all rows.
    Measurement measure_alone(double now) {
        whole_->look(now, kernels_.measure, {});
        return sum_up();
    }

    /// Rows in order, so that the sum is the same for any number of members.
    Measurement sum_up() const {
        Measurement sum;
        for (const auto& row : sums_) {
            sum.kinetic += row.kinetic;
            sum.elastic += row.elastic;
            sum.power += row.power;
            sum.mean_stretch += row.stretch;
            sum.max_stretch = std::max(sum.max_stretch, row.max_stretch);
            sum.max_force = std::max(sum.max_force, row.max_force);
            sum.rms_force += row.force_squares;
            sum.moment += glm::dvec3(row.moment[0], row.moment[1], row.moment[2]);
        }
        const auto springs = static_cast<double>(model_.springs_in_all());
        if (springs > 0.0) sum.mean_stretch /= springs;
        if (springs == 0.0) sum.max_stretch = 0.0;
        if (springs > 0.0) sum.rms_force = std::sqrt(sum.rms_force / springs);
        sum.half_kick = kernels_.staggered ? 0.5 * started_dt_ : 0.0;
        return sum;
    }

    Model model_;
    Kernels<Real> kernels_;
    ModelRows<Real> rows_;
    std::vector<FieldBuffer<Real>> fields_;
    FieldBuffer<Real> moved_;
    Array<RowSums> sums_;  // not std's: its functions would be shared between instruction sets (isa.hpp)
    std::vector<std::unique_ptr<Member>> members_;
    std::unique_ptr<Member> whole_;  // all rows, for what one member does alone
    std::unique_ptr<Team> team_;
    double started_dt_ = 0.0;  // s, the step the method was started for; 0: position and velocity are synchronised
    double pass_energy_ = 0.0;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

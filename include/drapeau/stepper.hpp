// Stepper: a model's masses moved by compiled kernels: a team of threads, passes after the move, starts and readings.
//
// A batch of steps runs as one region of a team. Each member owns a block of rows (block.hpp).
#pragma once

#include "drapeau/block.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/pull.hpp"
#include "drapeau/team.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// What a batch of steps did, summed on the way.
struct Report {
    Work work;         // in the step that was accounted
    PassReport limit;  // of passes after the move
    Solves solves{};   // of methods that solve
    PullReport pull;   // of a hand that holds the cloth

    void add(const Report& other) {
        work.add(other.work);
        pull.add(other.pull);
        limit.add(other.limit);
        solves.add(other.solves);
    }
};

template <class Real>
class Stepper {
public:
    /// All masses at rest at their places in the grid.
    Stepper(const Model& model, const Kernels<Real>& kernels) : body_(model, kernels), whole_(body_, 0, 1) {
        use_threads(1);
        if (model.limits.get<StretchLimit>()) room_ = StretchLimit::Room<Real>(model.grid);
        for (int j = 0; j < model.grid.rows; ++j)
            for (int i = 0; i < model.grid.columns; ++i) position_.set(i, j, model.grid.rest(i, j));
    }
    Stepper(const Stepper&) = delete;

    const Model& model() const { return body_.model; }
    int threads() const { return static_cast<int>(blocks_.size()); }
    const FieldBuffer<Real>& position() const { return position_; }
    const FieldBuffer<Real>& velocity() const { return velocity_; }  // as the method stores it

    /// `count` threads, fewer if there are not two rows for each. Throws std::system_error where the system gives no
    /// more threads, and stays as it was.
    void use_threads(int count) {
        const int members = std::clamp(model().grid.rows / std::max(2, body_.halo_rows), 1, std::max(1, count));
        auto team = members > 1 ? std::make_unique<Team>(members) : nullptr;
        std::vector<std::unique_ptr<Block<Real>>> blocks;
        for (int n = 0; n < members; ++n) {
            blocks.push_back(std::make_unique<Block<Real>>(body_, n, members));
            if (n > 0) blocks[n - 1]->join(*blocks[n]);
        }
        team_ = std::move(team);
        blocks_ = std::move(blocks);
    }

    /// Takes over strengths. The grid and what is listed stay as they are.
    void refill(const Model& model) {
        body_.model = model;
        body_.rows.refill(model);
        body_.added.refill(model);
        is_air_held_ = false;
        pull(pull_);
    }

    /// From the next step on a hand pulls like this, or none does.
    void pull(const std::optional<Pull>& by) {
        pull_ = by;
        grip_ = by ? Grip(model(), *by, body_.kernels.step != nullptr) : Grip();
    }

    /// Position and velocity at the same time (s); held masses get no velocity.
    void set(const State<double>& state) {
        position_.take(state.position);
        velocity_.take(state.velocity);
        for (int j = 0; j < model().grid.rows; ++j)
            for (int i = 0; i < model().grid.columns; ++i)
                if (model().held(i, j)) velocity_.set(i, j, glm::dvec3(0.0));
        have_synchronised();
    }
    /// Both at time `now` (s), the clock's time of the step to come. Reading it does not alter the run.
    State<double> state(double now) {
        State<double> state(model().grid.columns, model().grid.rows);
        state.position.take(position_);
        state.velocity.take(synchronised_velocity(now));
        return state;
    }

    /// Takes the steps first <= n < last of the clock; one at a time where a method that solves is pulled. In step
    /// `accounted` the work of every force is summed.
    Report advance(const Clock& clock, long long first, long long last, long long accounted = no_step) {
        if (started_dt_ != clock.dt) restart(clock.at(first), clock.dt);
        Report report;
        const int held = steps_held(model(), clock.dt);
        const bool accounts = accounted >= first && accounted < last;
        const bool pulled_before = grip_.holds() && body_.kernels.step, pulled_after = grip_.holds() && !pulled_before;
        const glm::dvec3 from = grip_.place(position_.view());
        if (pulled_before) pull_on(clock.dt, report.pull);
        if (accounts) std::fill(body_.sums.begin(), body_.sums.end(), RowSums{});
        run([&](int n) {
            blocks_[n]->advance(
                clock, first, last, accounted, held, meet_,
                [&](long long step) {
                    const bool alone = model().is_limited() || pulled_after;
                    const bool counts = step == accounted && (alone || model().touches());
                    const double now = clock.at(step + 1);
                    if (alone || counts) {
                        meet_();
                        if (n == 0 && counts) report.work.passes -= measure_alone(now).balance();
                        if (n == 0 && pulled_after) pull_on(clock.dt, report.pull);
                        if (n == 0) limit(clock.dt, report.limit);
                        meet_();
                    }
                    if (model().touches()) blocks_[n]->touch(clock.dt);
                    if (!counts) return;
                    meet_();
                    if (n == 0) report.work.passes += measure_alone(now).balance();
                    meet_();
                },
                n == 0 ? &report.solves : nullptr);
        });
        if (pulled_before && accounts) {
            const glm::dvec3 way = (grip_.place(position_.view()) - from) / clock.dt, &p = report.pull.impulse;
            report.work.passes += p.x * way.x + p.y * way.y + p.z * way.z;
        }
        if (accounts) {
            glm::dvec3 drift(0.0);
            for (const auto& row : body_.sums) {
                report.work.external += row.external_work;
                report.work.damping += row.damping_work;
                drift += glm::dvec3(row.drift[0], row.drift[1], row.drift[2]);
            }
            report.work.stored = model().potential(drift);
            report.work.external += report.work.stored;
        }
        return report;
    }

    /// Energy and stretch at time `now` (s), the velocity as stored: for staggered methods kinetic energy is
    /// sum m v-.v+ / 2, which is constant in linear motion at any stable step.
    Measurement measure(double now) {
        look_at_added_air(now);
        run([&](int n) { blocks_[n]->look(now, started_dt_, body_.kernels.measure, {}); });
        return sum_up();
    }

    /// The acceleration (m/s2) of every mass at time `now` (s), but for drag and friction.
    void evaluate(double now, FieldBuffer<Real>& a) {
        look_at_added_air(now);
        run([&](int n) { blocks_[n]->look(now, started_dt_, body_.kernels.evaluate, a.view()); });
    }

    /// What the Hessian times a direction u came to: u.Ku, u.Cu, u.Ru (R: drag and friction), u.Mu and the product's.
    struct Stiffness {
        double elastic = 0.0, damping = 0.0, on_mass = 0.0, before = 0.0, after = 0.0;
    };
    /// out = M^-1 (k_weight K + c_weight C + rate_weight R) u, of the springs as they are.
    Stiffness stiffness(double k_weight, double c_weight, double rate_weight, FieldBuffer<Real>& u,
                        FieldBuffer<Real>& out) {
        run([&](int n) { blocks_[n]->stiffness(k_weight, c_weight, rate_weight, u.view(), out.view()); });
        Stiffness sum;
        for (const auto& row : body_.sums) {
            sum.elastic += row.elastic, sum.damping += row.damping_work, sum.on_mass += row.external_work;
            sum.before += row.products[0][0], sum.after += row.products[0][1];
        }
        return sum;
    }

    /// The greatest rate (1/s) at which the air on faces brakes a mass at time `now` (s).
    double air_rate(double now) {
        if (!model().air()) return 0.0;
        run([&](int n) { blocks_[n]->look_at_air(now); });
        double most = 0.0;
        for (const auto& row : body_.sums) most = std::max(most, row.max_air_rate);
        return most;
    }

    /// Everything that the steps to come depend on.
    struct Checkpoint {
        std::vector<FieldBuffer<Real>> fields, held;
        double started_dt = 0.0;
        bool is_air_held = false;
    };
    void save(Checkpoint& into) const {
        into.fields = body_.fields;
        into.started_dt = started_dt_;
        if (model().added_air()) into.held.assign(std::begin(body_.added.held), std::end(body_.added.held));
        into.is_air_held = is_air_held_;
    }
    void restore(const Checkpoint& from) {
        for (std::size_t f = 0; f < body_.fields.size(); ++f) body_.fields[f] = from.fields[f];
        started_dt_ = from.started_dt;
        std::copy(from.held.begin(), from.held.end(), std::begin(body_.added.held));
        is_air_held_ = from.is_air_held;
    }

    /// Lets the method start again, with another step or from a changed state.
    void synchronise(double now) {
        if (started_dt_ == 0.0) return;
        velocity_ = synchronised_velocity(now);
        have_synchronised();
    }

    /// From time `now` (s) on moves what is held with this velocity (m/s), the same for all of it: what hauls does the
    /// work.
    void haul(double now, const glm::dvec3& velocity) {
        synchronise(now);
        for (int j = 0; j < model().grid.rows; ++j)
            for (int i = 0; i < model().grid.columns; ++i)
                if (model().held(i, j)) velocity_.set(i, j, velocity);
        have_synchronised();
    }

    /// Kinetic energy (J) of the velocities as stored, for little.
    double kinetic() {
        run([&](int n) { blocks_[n]->sum_kinetic(); });
        double sum = 0.0;
        for (const auto& row : body_.sums) sum += row.kinetic;
        return sum;
    }

private:
    template <class Region>
    void run(const Region& region) {
        if (!team_) return region(0);
        team_->run([&](int n) { region(n); });
    }

    /// Looks at the air that moves along, unless what it does is held already.
    void look_at_added_air(double now) {
        if (is_air_held_ || !model().added_air()) return;
        const double ahead = steps_held(model(), started_dt_) * started_dt_;
        run([&](int n) { blocks_[n]->look_at_added_air(now, ahead, true, meet_); });
        is_air_held_ = true;
    }

    /// The passes over the cloth as a whole, by one member: positions are corrected, then velocities follow, v +=
    /// dx/dt: a mass that was moved over has the velocity it was moved with.
    void limit(double dt, PassReport& report) {
        bool changed = false;
        model().limits.for_each([&]<class Limit>(const Limit& limit) {
            if constexpr (!Contact<Limit>) {
                if (!changed) moved_ = position_;
                const PassReport done =
                    limit.apply(model().grid, model().has_diagonals(), body_.rows.constants(), moved_.view(), room_);
                report.add(done);
                changed = changed || done.sweeps > 0;
            }
        });
        if (!changed) return;
        const auto to = moved_.view();
        const Real rate = Real(1) / static_cast<Real>(dt);
        each_mass([&](const Field<Real>* fields, std::ptrdiff_t n, int, int) {
            const auto dx = to.template at<Real>(n) - fields[0].template at<Real>(n);
            if (dx.x != 0 || dx.y != 0 || dx.z != 0) body_.kernels.follow(fields, n, dx, rate * dx);
        });
    }

    /// The hand, by one member, over all rows.
    void pull_on(double dt, PullReport& report) {
        Field<Real> fields[max_fields]{};
        for (int f = 0; f < body_.kernels.fields; ++f) fields[f] = body_.fields[f].view();
        grip_.pull(fields, dt, body_.kernels.step != nullptr, report, body_.kernels.follow);
    }

    void restart(double now, double dt) {
        synchronise(now);
        started_dt_ = dt;
        is_air_held_ = false;
        look_at_added_air(now);
        FieldBuffer<Real> a(model().grid.columns, model().grid.rows);
        if (body_.kernels.starts_with_forces) evaluate(now, a);
        each_mass([&](const Field<Real>* fields, std::ptrdiff_t n, int i, int j) {
            body_.kernels.start(fields, n, a.view().template at<Real>(n), body_.rows.constants()[j].rate[i],
                                static_cast<Real>(dt));
        });
    }

    /// Position and velocity are at the same time: dampers look at that velocity until the method starts.
    void have_synchronised() {
        auto& seen = body_.fields[body_.kernels.seen_velocity];
        if (&seen != &velocity_) seen = velocity_;
        started_dt_ = 0.0;
        is_air_held_ = false;
    }

    FieldBuffer<Real> synchronised_velocity(double now) {
        if (started_dt_ == 0.0 || !body_.kernels.starts_with_forces) return velocity_;
        FieldBuffer<Real> a(model().grid.columns, model().grid.rows), v(model().grid.columns, model().grid.rows);
        evaluate(now, a);
        each_mass([&](const Field<Real>* fields, std::ptrdiff_t n, int i, int j) {
            v.view().set(n,
                         body_.kernels.synchronised(fields, n, a.view().template at<Real>(n),
                                                    body_.rows.constants()[j].rate[i], static_cast<Real>(started_dt_)));
        });
        return v;
    }

    template <class Visit>
    void each_mass(Visit&& visit) {
        Field<Real> fields[max_fields]{};
        for (int f = 0; f < body_.kernels.fields; ++f) fields[f] = body_.fields[f].view();
        for (int j = 0; j < model().grid.rows; ++j)
            for (int i = 0; i < model().grid.columns; ++i)
                visit(fields, static_cast<std::ptrdiff_t>(j) * fields[0].stride + i, i, j);
    }

    /// Within a region, by one member for all rows.
    Measurement measure_alone(double now) {
        whole_.look(now, started_dt_, body_.kernels.measure, {});
        return sum_up();
    }

    /// Rows in order, so that the sum is the same for any number of members.
    Measurement sum_up() const {
        Measurement sum;
        for (const auto& row : body_.sums) {
            sum.kinetic += row.kinetic;
            sum.kinetic_now += row.kinetic_now;
            sum.elastic += row.elastic;
            sum.power += row.power;
            sum.mean_stretch += row.stretch;
            sum.max_stretch = std::max(sum.max_stretch, row.max_stretch);
            sum.max_force = std::max(sum.max_force, row.max_force);
            sum.rms_force += row.force_squares;
            sum.moment += glm::dvec3(row.moment[0], row.moment[1], row.moment[2]);
        }
        const auto springs = static_cast<double>(model().springs_in_all());
        if (springs > 0.0) sum.mean_stretch /= springs;
        if (springs == 0.0) sum.max_stretch = 0.0;
        if (springs > 0.0) sum.rms_force = std::sqrt(sum.rms_force / springs);
        sum.half_kick = body_.kernels.staggered ? 0.5 * started_dt_ : 0.0;
        return sum;
    }

    Body<Real> body_;
    FieldBuffer<Real>&position_ = body_.fields[0], &velocity_ = body_.fields[1];
    FieldBuffer<Real> moved_;
    StretchLimit::Room<Real> room_;
    std::optional<Pull> pull_;
    Grip grip_;  // of it
    std::vector<std::unique_ptr<Block<Real>>> blocks_;
    Block<Real> whole_;  // all rows, for what one member does alone
    std::unique_ptr<Team> team_;
    struct Meet {
        const std::unique_ptr<Team>& team;
        void operator()() const {
            if (team) team->meet();
        }
    };
    Meet meet_{team_};
    bool is_air_held_ = false;  // what the air that moves along does is known
    double started_dt_ = 0.0;   // s, the step the method was started for; 0: position and velocity are synchronised
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

// Watch: keeps a run's energy ledger on the way, for a few per cent of its steps, and states to return to.
//
// In every batch one step, taken at random (but the same in every run), sums the work of every force; it stands for the
// others. After eight batches energy is measured and the ledger written. Where a batch has few steps, several batches
// are taken for one. All of it depends on step numbers alone, so the same run is watched in the same way whatever asks
// for its steps.
#pragma once

#include "run/engine.hpp"

#include "drapeau/flag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace drapeau {

/// How a run stands: what a checkpoint of the programs holds besides the masses.
struct Progress {
    Clock clock;
    long long steps = 0;  // since the run began

    double time() const { return clock.at(steps); }
    /// The first step of the next batch: step n belongs to batch floor(60 (n - first) dt).
    long long next_batch() const {
        constexpr double rounding = 1e-6;  // of a batch: steps that fill batches do so up to rounding
        const double dt = clock.dt / batch_seconds, done = static_cast<double>(steps - clock.first) * dt;
        const double border = (std::floor(done + rounding) + 1.0 - rounding) / dt;
        return std::max(steps + 1, clock.first + static_cast<long long>(std::min(std::ceil(border), 9e18)));
    }
};

class Watch {
public:
    static constexpr int places = 2;          // of the engine that are used for states to return to
    static constexpr int end_place = places;  // and one for the state whose past is counted again

    /// What a method does to energy by nature: where it creates some, or does not know what forces did, it is judged by
    /// the energy there is; what it may lose is looked for.
    struct Nature {
        bool creates = false, dissipates = false;

        static Nature of(Method method) {
            return with_method(method, [&](const auto& m) {
                using M = std::decay_t<decltype(m)>;
                return Nature{M::creates_energy || !M::counts_work, M::dissipates_energy};
            });
        }
    };

    /// Opens a new ledger.
    void open(Engine& engine, const Progress& now, double steps_a_batch, Nature nature);

    /// Before the first step of a batch: chooses the step to account; every eighth time keeps the state.
    void begin_batch(Engine& engine, const Progress& now);
    long long accounted_step() const { return accounted_; }
    void count(const Report& report) {
        counted_.add(report.work);
        pulled_ += report.pull.gross;
    }
    /// After the last step of a batch.
    void end_batch(Engine& engine, const Progress& now);
    /// Counts again, every step of it, what happened since the newest state kept: what was known from samples until now
    /// is then known. False, and nothing is changed, where that would take seconds or `abandon` is set meanwhile.
    bool count_again(Engine& engine, const Progress& now, const std::atomic<bool>* abandon);
    /// Looks whether every mass and every reading is finite.
    void look_for_infinities(Engine& engine, const Progress& now);
    /// Looks at the energy at any time, by samples.
    void look_now(Engine& engine, const Progress& now);

    const Ledger& ledger() const { return ledger_; }
    bool is_broken() const { return broken_ || ledger_.is_broken(creates_); }
    /// Whether that may be so, but for what samples leave in doubt.
    bool suspects() const { return is_broken() || (!creates_ && ledger_.is_broken(false, false)); }
    /// Whether energy is being created to an extent that an automatic step answers with a smaller one.
    bool warns() const;
    /// Whether nothing of that has been seen for `seconds`.
    bool calm_for(double seconds, double now) const { return now - last_unrest_ >= seconds; }

    /// Puts engine and progress back to the newest state kept, which was good by this same measure.
    void return_to_good(Engine& engine, Progress& now);

private:
    static constexpr int window_ = 8, steps_for_a_group = 24;

    struct Saved {
        Progress progress;
        Ledger ledger;
        double last_unrest = 0.0;
        long long number = -1;  // -1: empty
    };

    long long in_window() const { return number_ % (window_ * group_); }
    void take_in(double now, double dt);
    const Saved* newest() const;
    /// Of a share created, what the method does not create by nature.
    double unnatural(double made) const;
    double counted_so_far(const Progress& now) const;
    void look(Engine& engine, const Progress& now);
    void write(Engine& engine, const Progress& now);
    double rounding_energy(const Engine& engine, long long steps) const;
    Estimate possible(Estimate came_in, const Engine& engine, double from, const Progress& to) const;

    Ledger ledger_;
    bool creates_ = false, dissipates_ = false, broken_ = false;
    long long number_ = 0;                          // batches since the ledger was opened
    long long group_ = 1;                           // batches taken for one
    long long accounted_ = no_step;                 // the step of the group under way that is accounted
    Work counted_;                                  // in that step
    double taken_in_ = 0.0;                         // s, up to when its work was taken in
    std::vector<double> external_, passes_, work_;  // J, estimates for each group since the ledger was last written
    double gross_ = 0.0;                            // J, of all work whatever its sign, since then
    double pulled_ = 0.0;                           // J, by a hand, likewise, every step of it
    long long written_step_ = 0;                    // when that was
    double looked_at_ = 0.0;                        // s, likewise
    double energy_ = 0.0, potential_ = 0.0;         // J, then
    double last_unrest_ = 0.0;                      // s
    std::array<Saved, places> saved_;
    int next_ = 0;
};

}  // namespace drapeau

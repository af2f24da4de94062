#include "run/watch.hpp"

#include <cmath>
#include <limits>

namespace drapeau {

namespace {

// An automatic step answers long before a run is broken; good runs stay far below.
constexpr double created_to_warn = 0.1, energy_to_warn = 1.15, created_when_calm = 0.03;
// Kinetic energy beyond so many times all there could be is broken at once: velocities half a kick back swing by less.
constexpr double far_beyond = 10.0;

double gross(const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double s : samples) sum += std::abs(s);
    return sum;
}

/// The sum of what each stands for, and how far it may be off by their scatter; of a few, by as much as they are.
Estimate sum_of_samples(const std::vector<double>& samples) {
    constexpr double few = 4.0;
    const auto n = static_cast<double>(samples.size());
    Estimate sum;
    for (const double s : samples) sum.value += s;
    if (n < few) return {sum.value, std::pow(gross(samples), 2)};
    for (const double s : samples) sum.variance += std::pow(s - sum.value / n, 2) * n / (n - 1.0);
    return sum;
}

/// The energy (J) of a fall too small to be seen. In the first moments of one, steps may be too short to move a mass by
/// a unit of its place: what it has fallen is in its velocity alone.
double unseen_fall(const Engine& engine) {
    constexpr double unseen = 1e-9;  // of the flag's size
    const Model& model = engine.model();
    const double pull = std::hypot(model.potential({1, 0, 0}), model.potential({0, 1, 0}), model.potential({0, 0, 1}));
    return unseen * engine.reach() * pull * model.total_mass();
}

}  // namespace

void Watch::open(Engine& engine, const Progress& now, double steps_a_batch, Nature nature) {
    *this = {};
    creates_ = nature.creates, dissipates_ = nature.dissipates;
    group_ = std::max(1LL, static_cast<long long>(std::ceil(steps_for_a_group / std::max(steps_a_batch, 1.0))));
    look(engine, now);
    ledger_.open(now.time(), energy_, potential_);
    ledger_.rounding = unseen_fall(engine);
    last_unrest_ = now.time();
}

/// What there is now; a new window begins.
void Watch::look(Engine& engine, const Progress& now) {
    const Measurement here = engine.measure(now.time());
    energy_ = here.total();
    potential_ = engine.model().potential(here.moment);
    counted_ = {};
    work_.clear(), external_.clear(), passes_.clear();
    gross_ = pulled_ = 0.0;
    taken_in_ = looked_at_ = now.time();
    written_step_ = now.steps;
}

double Watch::unnatural(double made) const {
    return creates_ ? std::min(made, 0.0) : made;
}

bool Watch::warns() const {
    return is_broken() || ledger_.energy_share() > energy_to_warn ||
           std::abs(unnatural(ledger_.created_share())) > created_to_warn;
}

double Watch::rounding_energy(const Engine& engine, long long steps) const {
    // Every length is rounded by about half a unit in the last place of the coordinates, so a step's kick is off by
    // k eps X for each spring, and energy walks up by (dt k eps X)^2 / 2m, at most k (eps X)^2 for a stable step.
    const Model& model = engine.model();
    const double eps = engine.epsilon();
    const double k = model.springs.stiffest();
    return static_cast<double>(steps) * static_cast<double>(model.springs_in_all()) * k *
           std::pow(2.0 * eps * engine.reach(), 2);
}

/// What external forces brought in since `from` (s), as far as they can: drag past its limit throws masses to and fro
/// and would count what it creates as brought in. In its first steps a good run may gain more, by up to four of them.
Estimate Watch::possible(Estimate came_in, const Engine& engine, double from, const Progress& to) const {
    const double most = engine.model().most_power() * (to.time() - from + 4.0 * to.clock.dt);
    came_in.value = std::min(came_in.value, most);
    came_in.variance = std::min(came_in.variance, std::pow((most - came_in.value) / 3.0, 2));
    return came_in;
}

void Watch::take_in(double now, double dt) {
    const double times = (now - taken_in_) / dt;  // steps that the accounted one stands for
    work_.push_back(times * counted_.but_stored());
    external_.push_back(times * counted_.external);
    passes_.push_back(times * std::max(0.0, counted_.passes));
    gross_ += times * counted_.gross();
    counted_ = {};
    taken_in_ = now;
}

void Watch::write(Engine& engine, const Progress& now) {
    const double before = energy_ + potential_;
    Estimate work = sum_of_samples(work_), came_in = sum_of_samples(external_);
    came_in.value = 0.0;
    for (const double in : external_) came_in.value += std::max(0.0, in);
    came_in = possible(came_in, engine, looked_at_, now);
    came_in.add(sum_of_samples(passes_));  // ground that is raised has any power
    const double rounding = rounding_energy(engine, now.steps - written_step_);
    look(engine, now);
    Estimate made{energy_ + potential_ - before - work.value, work.variance};
    if (made.value < 0.0 && !dissipates_) made = {};  // dampers that were missed
    ledger_.add(now.time(), energy_, potential_, came_in, made, rounding);
    if (std::abs(unnatural(ledger_.created_lately())) > created_when_calm) last_unrest_ = now.time();
}

void Watch::begin_batch(Engine& engine, const Progress& now) {
    // Any step of the group alike; again where another dt has moved the group's end on the way.
    Progress end = now;
    for (long long n = number_ % group_; n < group_; ++n) end.steps = end.next_batch();
    if (number_ % group_ == 0 || accounted_ >= end.steps)
        accounted_ = now.steps + static_cast<long long>(mix(static_cast<std::uint64_t>(number_)) %
                                                        static_cast<std::uint64_t>(end.steps - now.steps));
    if (in_window() != 0 || warns()) return;  // a state to return to is good
    Saved& saved = saved_[static_cast<std::size_t>(next_)];
    saved = {now, ledger_, last_unrest_, number_};
    engine.save(next_);
    next_ = (next_ + 1) % places;
}

void Watch::end_batch(Engine& engine, const Progress& now) {
    ++number_;
    if (number_ % group_ == 0) take_in(now.time(), now.clock.dt);
    // No need to wait for the window's end.
    const double kinetic = engine.kinetic();
    const double all =
        ledger_.scale() + gross_ + pulled_ + counted_so_far(now) + rounding_energy(engine, now.steps - written_step_);
    broken_ = !std::isfinite(kinetic) || kinetic > far_beyond * all;
    if (!broken_ && in_window() == 0) write(engine, now);
}

double Watch::counted_so_far(const Progress& now) const {
    // Until its step has been accounted nothing is known of a group's work. From rest a constant force's work is that
    // of the first step times the square of the number of steps.
    if (now.steps <= accounted_) return INFINITY;
    const double steps = (now.time() - taken_in_) / now.clock.dt;
    return steps * steps * counted_.gross();
}

void Watch::look_for_infinities(Engine& engine, const Progress& now) {
    broken_ = broken_ || !engine.is_finite(now.time());
}

void Watch::look_now(Engine& engine, const Progress& now) {
    if (now.steps == written_step_) return;
    Watch then = *this;
    if (now.time() > then.taken_in_ && now.steps > then.accounted_) then.take_in(now.time(), now.clock.dt);
    if (!then.work_.empty() && now.time() - then.taken_in_ < 0.5 * batch_seconds) then.write(engine, now);
    broken_ = broken_ || then.ledger_.is_broken(creates_) || !std::isfinite(engine.kinetic());
}

const Watch::Saved* Watch::newest() const {
    const Saved* found = nullptr;
    for (const auto& saved : saved_)
        if (saved.number >= 0 && (!found || saved.number > found->number)) found = &saved;
    return found;
}

bool Watch::count_again(Engine& engine, const Progress& now, const std::atomic<bool>* abandon) {
    constexpr double longest = 1e8;  // about a second
    const Saved* from = newest();
    if (!from || from->progress.clock.dt != now.clock.dt || from->progress.clock.first != now.clock.first) return false;
    const long long steps = now.steps - from->progress.steps;
    if (static_cast<double>(steps) * engine.step_cost() > longest) return false;
    engine.save(end_place);
    engine.restore(static_cast<int>(from - saved_.data()));
    Progress again = from->progress;
    const Measurement before = engine.measure(again.time());
    double work = 0.0, came_in = 0.0, passed_in = 0.0;
    while (again.steps < now.steps) {
        double external = 0.0;  // of a batch
        for (const long long end = std::min(again.next_batch(), now.steps); again.steps < end; ++again.steps) {
            Report report;
            engine.advance(again.clock, again.steps, again.steps + 1, again.steps, report, nullptr);
            work += report.work.all();
            external += report.work.external;
            passed_in += std::max(0.0, report.work.passes);
        }
        came_in += std::max(0.0, external);
        if (!abandon || !abandon->load(std::memory_order_relaxed)) continue;
        engine.restore(end_place);
        return false;
    }
    const Measurement after = engine.measure(again.time());
    const double rounding = rounding_energy(engine, steps);
    engine.restore(end_place);
    look(engine, now);
    Estimate made{after.balance() - before.balance() - work, 0.0};
    if (made.value < 0.0 && !dissipates_) made = {};
    ledger_ = from->ledger;
    Estimate brought = possible({came_in, 0.0}, engine, from->progress.time(), now);
    brought.add({passed_in, 0.0});
    ledger_.add(now.time(), energy_, potential_, brought, made, rounding);
    // Past the limit v-.v+ may be as far below zero as springs hold more than there could be.
    const double kinetic = engine.kinetic();
    broken_ = !std::isfinite(kinetic) || kinetic > far_beyond * ledger_.scale();
    number_ += (window_ * group_ - in_window()) % (window_ * group_);  // a new window begins
    return true;
}

void Watch::return_to_good(Engine& engine, Progress& now) {
    const Saved* const good = newest();
    const int place = static_cast<int>(good - saved_.data());
    engine.restore(place);
    now = good->progress;
    ledger_ = good->ledger;
    last_unrest_ = good->last_unrest;
    number_ = good->number;
    next_ = place;  // taken again when the window begins again
    broken_ = false;
    look(engine, now);
}

}  // namespace drapeau

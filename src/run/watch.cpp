#include "run/watch.hpp"

#include <cmath>
#include <limits>

namespace drapeau {

namespace {

// An automatic step answers long before a run is broken; good runs stay far below.
constexpr double created_to_warn = 0.1, energy_to_warn = 1.15, created_when_calm = 0.03;

}  // namespace

void Watch::open(Engine& engine, const Progress& now, double steps_a_batch, bool creates) {
    *this = {};
    creates_ = creates;
    group_ = std::max(1LL, static_cast<long long>(std::ceil(steps_for_a_group / std::max(steps_a_batch, 1.0))));
    const auto here = engine.measure(now.time());
    ledger_.open(now.time(), here.total());
    looked_ = last_unrest_ = now.time();
    power_ = engine.look(now.time()).power;
}

bool Watch::warns() const {
    return is_broken() || ledger_.energy_share() > energy_to_warn ||
           (!creates_ && ledger_.created_share() > created_to_warn);
}

double Watch::rounding_energy(const Engine& engine) const {
    // Every length is rounded by about half a unit in the last place of the coordinates, so a step's kick is off by
    // k eps X for each spring, and energy walks up by (dt k eps X)^2 / 2m, at most k (eps X)^2 for a stable step.
    const Model& model = engine.model();
    const double eps = engine.epsilon();
    const auto far = engine.corner();
    const double size = std::hypot(model.grid.columns * model.grid.pitch_x, model.grid.rows * model.grid.pitch_y) +
                        std::sqrt(far.x * far.x + far.y * far.y + far.z * far.z);
    const double k = std::max(model.springs.stiffness, model.springs.diagonal_stiffness.value_or(0.0));
    return static_cast<double>(steps_) * static_cast<double>(model.springs_in_all()) * k * std::pow(eps * size, 2);
}

void Watch::write(Engine& engine, double now, double created, double external) {
    const auto here = engine.measure(now);
    ledger_.add(now, here.total(), external, created, rounding_energy(engine));
    if (ledger_.created_share() > created_when_calm) last_unrest_ = now;
    steps_ = 0;
    work_ = external_ = estimated_ = 0.0;
    balance_ = here.balance();
}

void Watch::begin_batch(Engine& engine, const Progress& now) {
    if (in_window() != 0) return;
    if (number_ > 0)
        write(engine, now.time(), (window_ - 1) * created_then_, estimated_);
    else
        balance_ = engine.measure(now.time()).balance();
    if (warns()) return;  // not a state to return to
    Saved& saved = saved_[static_cast<std::size_t>(next_)];
    saved = {now, ledger_, last_unrest_, number_};
    engine.save(next_);
    next_ = (next_ + 1) % places;
}

void Watch::end_batch(Engine& engine, const Progress& now, long long steps) {
    const bool accounted = accounts();
    ++number_;
    steps_ += steps;
    const bool last_of_account = in_window() == group_;
    if (number_ % group_ != 0) return;

    const auto seen = engine.look(now.time());
    estimated_ += 0.5 * (power_ + seen.power) * (now.time() - looked_);
    power_ = seen.power;
    looked_ = now.time();
    // Far beyond all there is: no need to wait for the window's end. (Velocities half a kick back swing by less.)
    constexpr double far_beyond = 10.0;
    const double all = ledger_.scale() + std::max(0.0, accounted ? external_ : estimated_) + rounding_energy(engine);
    broken_ = !std::isfinite(seen.kinetic) || seen.kinetic > far_beyond * all;
    if (broken_ || !accounted || !last_of_account) return;

    const auto after = engine.measure(now.time());
    created_then_ = after.balance() - balance_ - work_;
    write(engine, now.time(), created_then_, external_);
}

void Watch::look_now(Engine& engine, const Progress& now) {
    if (now.time() == looked_ && steps_ == 0) return;
    const auto seen = engine.look(now.time());
    estimated_ += 0.5 * (power_ + seen.power) * (now.time() - looked_);
    const auto here = engine.measure(now.time());
    Ledger sum = ledger_;
    sum.add(now.time(), here.total(), estimated_, 0.0, rounding_energy(engine));
    broken_ = broken_ || sum.is_broken(creates_);
}

void Watch::return_to_good(Engine& engine, Progress& now) {
    const Saved* newest = nullptr;
    for (auto& saved : saved_)
        if (saved.number >= 0 && (!newest || saved.number > newest->number)) newest = &saved;
    const int place = static_cast<int>(newest - saved_.data());
    engine.restore(place);
    now = newest->progress;
    ledger_ = newest->ledger;
    last_unrest_ = newest->last_unrest;
    number_ = newest->number;
    next_ = place;  // taken again when the window begins again
    broken_ = false;
    steps_ = 0;
    work_ = external_ = estimated_ = created_then_ = 0.0;
    looked_ = now.time();
    power_ = engine.look(now.time()).power;
    balance_ = engine.measure(now.time()).balance();
}

}  // namespace drapeau

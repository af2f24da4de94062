#include "measure/flight.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

static_assert(Stretch::batch_length == batch_seconds);

namespace {

double mix(double coarse, double fine, double gain) {
    return fine + (fine - coarse) / gain;
}
glm::dvec3 mix(const glm::dvec3& coarse, const glm::dvec3& fine, double gain) {
    return fine + (fine - coarse) / gain;
}
Reading mix(const Reading& coarse, const Reading& fine, double gain) {
    return {mix(coarse.energy, fine.energy, gain), mix(coarse.stretch, fine.stretch, gain)};
}
FieldBuffer<double> mix(const FieldBuffer<double>& coarse, const FieldBuffer<double>& fine, double gain) {
    FieldBuffer<double> mixed(fine.columns(), fine.rows());
    for (int j = 0; j < fine.rows(); ++j)
        for (int i = 0; i < fine.columns(); ++i) mixed.set(i, j, mix(coarse.at(i, j), fine.at(i, j), gain));
    return mixed;
}
template <class Value>
std::vector<Value> mix(const std::vector<Value>& coarse, const std::vector<Value>& fine, double gain) {
    std::vector<Value> mixed;
    for (std::size_t n = 0; n < fine.size(); ++n) mixed.push_back(mix(coarse[n], fine[n], gain));
    return mixed;
}

FieldBuffer<double> thinned(const FieldBuffer<double>& all, int every) {
    if (every == 1) return all;
    FieldBuffer<double> some((all.columns() - 1) / every + 1, (all.rows() - 1) / every + 1);
    for (int j = 0; j < some.rows(); ++j)
        for (int i = 0; i < some.columns(); ++i) some.set(i, j, all.at(every * i, every * j));
    return some;
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x + v.y + v.z);
}

}  // namespace

Yardstick::Yardstick(const Model& model)
    : engine_(make_engine(model, method_id<SemiImplicitEuler>, Precision::double_precision)) {}

Reading Yardstick::read(const State<double>& state, double time) {
    engine_->set(state);
    const Measurement here = engine_->measure(time);
    return {here.kinetic_now + here.elastic + engine_->model().potential(here.moment), here.max_stretch};
}

void Flight::see(const Stretch& stretch, long long batch, State<double> state, Yardstick& yardstick) {
    if (stretch.is_sample(batch)) {
        positions.push_back(thinned(state.position, stretch.every_mass));
        readings.push_back(yardstick.read(state, stretch.time + static_cast<double>(batch) * Stretch::batch_length));
    }
    if (batch == stretch.batches) end = std::move(state);
}

Tip tip_of(const Model& model) {
    const Grid& grid = model.grid;
    const Tip middle{grid.columns / 2, grid.rows / 2};
    const Tip end = grid.columns == 1 ? Tip{0, grid.rows - 1} : Tip{grid.columns - 1, grid.rows / 2};
    for (const Tip& tip : {end, middle})
        if (!model.held(tip.column, tip.row)) return tip;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            if (!model.held(i, j)) return {i, j};
    return end;
}

std::optional<Flight> fly(const Model& model, Method method, long long steps_a_batch, const Stretch& stretch,
                          Yardstick& yardstick, const std::function<bool()>& may_go_on, Precision precision,
                          const std::function<void(const State<double>&)>& look) {
    const auto engine = make_engine(model, method, precision);
    const Clock clock{stretch.time, 0, batch_seconds / static_cast<double>(steps_a_batch)};
    const Tip tip = tip_of(model);
    Flight flight;
    engine->set(stretch.start);
    for (long long batch = 1; batch <= stretch.batches; ++batch) {
        Report report;
        engine->advance(clock, (batch - 1) * steps_a_batch, batch * steps_a_batch, no_step, report, nullptr);
        if (may_go_on && !may_go_on()) return {};
        State<double> state = engine->state(clock.at(batch * steps_a_batch));
        flight.tip.push_back(state.position.at(tip.column, tip.row));
        flight.tip_velocity.push_back(state.velocity.at(tip.column, tip.row));
        if (!is_finite(flight.tip.back())) return {};
        if (look && stretch.is_sample(batch)) look(state);
        flight.see(stretch, batch, std::move(state), yardstick);
        if (stretch.is_sample(batch) && !std::isfinite(flight.readings.back().energy)) return {};
    }
    return flight;
}

bool is_limit_active(const Model& model, const Flight& flight) {
    constexpr double near = 0.99;
    const auto& limit = model.limits.get<StretchLimit>();
    return limit && std::any_of(flight.readings.begin(), flight.readings.end(),
                                [&](const Reading& reading) { return reading.stretch >= near * limit->stretch; });
}

Flight extrapolated(const Flight& coarse, const Flight& fine, int order) {
    const double gain = std::pow(2.0, order) - 1.0;
    Flight better;
    better.positions = mix(coarse.positions, fine.positions, gain);
    better.readings = mix(coarse.readings, fine.readings, gain);
    better.tip = mix(coarse.tip, fine.tip, gain);
    better.tip_velocity = mix(coarse.tip_velocity, fine.tip_velocity, gain);
    better.end = State<double>(fine.end.columns(), fine.end.rows());
    better.end.position = mix(coarse.end.position, fine.end.position, gain);
    better.end.velocity = mix(coarse.end.velocity, fine.end.velocity, gain);
    return better;
}

void Comparison::take(const FieldBuffer<double>& position, const Reading& reading) {
    const FieldBuffer<double>& other = truth_.positions[sample_];
    const Reading& true_reading = truth_.readings[sample_];
    double squares = 0.0, greatest = 0.0;
    long long free = 0;
    for (int j = 0; j < other.rows(); ++j)
        for (int i = 0; i < other.columns(); ++i) {
            if (model_.held(i, j)) continue;
            const glm::dvec3 d = position.at(i, j) - other.at(i, j);
            const double square = d.x * d.x + d.y * d.y + d.z * d.z;
            squares += square;
            greatest = std::max(greatest, square);
            ++free;
        }
    last_ = free > 0 ? squares / static_cast<double>(free) : 0.0;
    squares_ += last_;
    ++sample_;
    apart_.greatest = std::max(apart_.greatest, std::sqrt(greatest));
    apart_.energy = std::max(apart_.energy, std::abs(reading.energy - true_reading.energy));
    apart_.stretch = std::max(apart_.stretch, std::abs(reading.stretch - true_reading.stretch));
}

Apart Comparison::result() const {
    Apart all = apart_;
    all.at_end = std::sqrt(last_);
    all.over_time = std::sqrt(squares_ / static_cast<double>(std::max<std::size_t>(sample_, 1)));
    return all;
}

Apart apart(const Model& model, const Flight& one, const Flight& truth) {
    Comparison comparison(model, truth);
    for (std::size_t n = 0; n < one.positions.size(); ++n) comparison.take(one.positions[n], one.readings[n]);
    return comparison.result();
}

}  // namespace drapeau

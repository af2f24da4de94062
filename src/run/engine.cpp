#include "run/engine.hpp"

#include "io/error.hpp"
#include "kernels/kernels.hpp"
#include "run/pull_history.hpp"

#include <cstring>
#include <limits>
#include <system_error>

namespace drapeau {
namespace {

template <class Real>
void copy(const FieldBuffer<Real>& from, FieldBuffer<float>& into) {
    if (into.columns() != from.columns() || into.rows() != from.rows())
        into = FieldBuffer<float>(from.columns(), from.rows());
    into.take(from);
}

template <class Real>
struct KeptState final : EngineState {
    typename Stepper<Real>::Checkpoint checkpoint;

    void snapshot(FieldBuffer<float>& into) const override { copy(checkpoint.fields[0], into); }
    void velocity(FieldBuffer<float>& into) const override { copy(checkpoint.fields[1], into); }
    std::size_t bytes() const override {
        std::size_t sum = sizeof *this;
        for (const auto* fields : {&checkpoint.fields, &checkpoint.held})
            for (const auto& field : *fields)
                for (int c = 0; c < 3; ++c) sum += sizeof field + field.component(c).size() * sizeof(Real);
        return sum;
    }
};

template <class Real>
class EngineOf final : public Engine {
public:
    EngineOf(const Model& model, Method method, bool half_kick_start)
        : step_cost_(drapeau::step_cost(model, method)),
          stepper_(model, kernels_for(model, method, half_kick_start)),
          solves_(with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::solves; })) {}

    long long advance(const Clock& clock, long long first, long long last, long long accounted, Report& report,
                      const std::atomic<bool>* abandon) override {
        constexpr double work_a_turn = 1e7;  // some hundredths of a second
        const auto steps_a_turn =            // a limit may take as long for one step, or a solve
            model().is_limited() || solves_ ? 1 : std::max(1LL, std::llround(work_a_turn / step_cost_));
        for (long long step = first, next = first; step < last; step = next) {
            if (abandon && abandon->load(std::memory_order_relaxed)) return step;
            next = pulls_.until(step, std::min(last, step + steps_a_turn));
            if (const auto pull = pulls_.at(step); pull != pulled_) stepper_.pull(pulled_ = pull);
            report.add(stepper_.advance(clock, step, next, accounted));
        }
        return last;
    }

    void use_threads(int threads) override {
        const bool pays = model().grid.masses() >= min_masses_for_threads;
        try {
            stepper_.use_threads(pays ? threads : 1);
        } catch (const std::system_error& refused) {
            throw InputError(std::to_string(threads) + " threads: the system gives no more (" + refused.what() + ")");
        }
    }
    void refill(const Model& model) override { stepper_.refill(model); }
    void synchronise(double now) override { stepper_.synchronise(now); }
    void haul(double now, double speed) override { stepper_.haul(now, {0.0, speed, 0.0}); }
    void pull(long long step, const std::optional<Pull>& by) override { pulls_.set(step, by); }
    double hauled() const override { return model().held(0, 0) ? stepper_.velocity().at(0, 0).y : 0.0; }

    const Model& model() const override { return stepper_.model(); }
    double step_cost() const override { return step_cost_; }
    Measurement measure(double now) override { return stepper_.measure(now); }
    double kinetic() override { return stepper_.kinetic(); }
    double epsilon() const override { return std::numeric_limits<Real>::epsilon(); }
    glm::dvec3 corner() const override { return stepper_.position().at(0, 0); }

    State<double> state(double now) override { return stepper_.state(now); }
    void set(const State<double>& state) override {
        stepper_.set(state);
        pulls_.clear();  // they were of another past
    }
    void snapshot(FieldBuffer<float>& into) const override { copy(stepper_.position(), into); }
    void velocity(FieldBuffer<float>& into) const override { copy(stepper_.velocity(), into); }

    std::uint64_t state_hash() const override {
        std::uint64_t hash = 0;
        for (const auto* field : {&stepper_.position(), &stepper_.velocity()})
            for (int c = 0; c < 3; ++c)
                for (int j = 0; j < field->rows(); ++j)
                    for (int i = 0; i < field->columns(); ++i) {
                        const Real value = field->component(c)[static_cast<std::size_t>(j) * field->stride() + i];
                        std::uint64_t bits = 0;
                        std::memcpy(&bits, &value, sizeof value);
                        hash = mix(hash ^ bits);
                    }
        return hash;
    }

    Oscillator fastest_mode(double damping_weight, double on_mass_weight, double dt, int looks, double now) override {
        return fastest_.look(stepper_, damping_weight, on_mass_weight, dt, looks, now);
    }

    // What was handed out is not written over: others look at it.
    void save(int place) override {
        Place& here = at(place);
        if (!here.state || here.is_lent) here = {std::make_shared<KeptState<Real>>(), false};
        stepper_.save(std::const_pointer_cast<KeptState<Real>>(here.state)->checkpoint);
    }
    void restore(int place) override { stepper_.restore(at(place).state->checkpoint); }

    std::shared_ptr<const EngineState> keep() const override {
        auto kept = std::make_shared<KeptState<Real>>();
        stepper_.save(kept->checkpoint);
        return kept;
    }
    std::shared_ptr<const EngineState> kept_in(int place) override {
        at(place).is_lent = true;
        return at(place).state;
    }
    void restore(const EngineState& kept) override {
        stepper_.restore(static_cast<const KeptState<Real>&>(kept).checkpoint);
        pulls_.clear();  // they were of another past
    }
    void put_in(int place, std::shared_ptr<const EngineState> kept) override {
        at(place) = {std::static_pointer_cast<const KeptState<Real>>(std::move(kept)), true};
    }

private:
    static Kernels<Real> kernels_for(const Model& model, Method method, bool half_kick_start) {
        const bool damped = with_method(method, [&]<class M>(const M&) { return model.is_damped_for<M>(); });
        Kernels<Real> kernels = find_kernels<Real>(method, model.has_diagonals(), damped);
        if (half_kick_start && method == method_id<SemiImplicitEuler>) {
            kernels.starts_with_forces = HalfKickStart::starts_with_forces;
            kernels.start = &HalfKickStart::start<false, Real>;
            kernels.synchronised = &HalfKickStart::synchronised<false, Real>;
        }
        return kernels;
    }

    static constexpr long long min_masses_for_threads = 4096;

    struct Place {
        std::shared_ptr<const KeptState<Real>> state;
        bool is_lent = false;
    };
    Place& at(int place) {
        if (place >= static_cast<int>(saved_.size())) saved_.resize(static_cast<std::size_t>(place) + 1);
        return saved_[static_cast<std::size_t>(place)];
    }

    double step_cost_;
    Stepper<Real> stepper_;
    bool solves_;
    FastestMode<Real> fastest_;
    PullHistory pulls_;
    std::optional<Pull> pulled_;  // as the stepper has it
    std::vector<Place> saved_;
};

}  // namespace

double step_cost(const Model& model, Method method) {
    // A row takes as long as some masses, a step as long as a row or two.
    constexpr double a_row = 30.0, a_step = 60.0;
    const int passes = with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::passes; });
    return passes * (model.grid.rows * (model.grid.columns + a_row) + a_step);
}

std::unique_ptr<Engine> make_engine(const Model& model, Method method, Precision precision, bool half_kick_start) {
    if (precision == Precision::double_precision)
        return std::make_unique<EngineOf<double>>(model, method, half_kick_start);
    return std::make_unique<EngineOf<float>>(model, method, half_kick_start);
}

}  // namespace drapeau

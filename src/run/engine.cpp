#include "run/engine.hpp"

#include "io/error.hpp"
#include "kernels/kernels.hpp"

#include <cstring>
#include <limits>
#include <system_error>

namespace drapeau {
namespace {

template <class Real>
class EngineOf final : public Engine {
public:
    EngineOf(const Model& model, Method method)
        : stepper_(model, find_kernels<Real>(method, model.has_diagonals(), model.is_damped())) {}

    long long advance(const Clock& clock, long long first, long long last, long long accounted, Report& report,
                      const std::atomic<bool>* abandon) override {
        constexpr long long mass_steps_a_turn = 10'000'000;  // some hundredths of a second
        const auto steps_a_turn =                            // a limit may take as long for one step
            model().is_limited() ? 1 : std::max(1LL, mass_steps_a_turn / model().grid.masses());
        for (long long step = first; step < last; step += steps_a_turn) {
            if (abandon && abandon->load(std::memory_order_relaxed)) return step;
            const Report turn = stepper_.advance(clock, step, std::min(last, step + steps_a_turn), accounted);
            report.work.add(turn.work);
            report.limit.add(turn.limit);
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

    const Model& model() const override { return stepper_.model(); }
    Measurement measure(double now) override { return stepper_.measure(now); }
    double kinetic() override { return stepper_.kinetic(); }
    double epsilon() const override { return std::numeric_limits<Real>::epsilon(); }
    glm::dvec3 corner() const override { return stepper_.position().at(0, 0); }

    State<double> state(double now) override { return stepper_.state(now); }
    void set(const State<double>& state) override { stepper_.set(state); }
    void snapshot(FieldBuffer<float>& into) const override {
        const auto& x = stepper_.position();
        if (into.columns() != x.columns() || into.rows() != x.rows()) into = FieldBuffer<float>(x.columns(), x.rows());
        into.take(x);
    }

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

    void save(int place) override {
        if (place >= static_cast<int>(saved_.size())) saved_.resize(static_cast<std::size_t>(place) + 1);
        stepper_.save(saved_[static_cast<std::size_t>(place)]);
    }
    void restore(int place) override { stepper_.restore(saved_[static_cast<std::size_t>(place)]); }

private:
    static constexpr long long min_masses_for_threads = 4096;

    Stepper<Real> stepper_;
    std::vector<typename Stepper<Real>::Checkpoint> saved_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Model& model, Method method, Precision precision) {
    if (precision == Precision::double_precision) return std::make_unique<EngineOf<double>>(model, method);
    return std::make_unique<EngineOf<float>>(model, method);
}

}  // namespace drapeau

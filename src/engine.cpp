#include "engine.hpp"

#include "kernels/kernels.hpp"

#include "drapeau/team.hpp"

#include <array>
#include <cstring>

namespace drapeau {

Physics::Physics(const Scene& scene)
    : grid(spread(scene.flag.columns, scene.flag.rows, scene.flag.width, scene.flag.height)),
      attach(scene.flag.attach),
      material{scene.springs.mass, scene.springs.stiffness, scene.springs.diagonal_stiffness, scene.springs.damping},
      gravity{scene.gravity ? scene.gravity->acceleration : glm::dvec3(0.0)},
      drag{scene.springs.drag.value_or(0.0)},
      friction{scene.springs.friction.value_or(0.0)},
      method(scene.time.method) {
    if (scene.wind) wind.wind = {scene.wind->velocity, scene.wind->gusts, scene.wind->period, scene.wind->seed};
}

Rates Physics::rates() const {
    return Rates::of(grid, material, drag.d, friction.c_f);
}

double Physics::largest_step() const {
    switch (method) {
        case Method::forward_euler:
            return drapeau::largest_step(ForwardEuler{}, rates());
        case Method::semi_implicit_euler:
            break;
    }
    return drapeau::largest_step(SemiImplicitEuler{}, rates());
}

namespace {

template <class Real>
class EngineOf final : public Engine {
public:
    explicit EngineOf(const Physics& physics)
        : physics_(physics),
          kernel_(find_kernel<Real>(physics.method, physics.material.diagonal_stiffness.has_value(),
                                    physics.material.damping.has_value())),
          cloth_(physics.grid),
          kept_(physics.grid),
          fabric_(physics.grid, physics.attach, physics.material),
          buffers_(cloth_.width()) {}

    bool advance(const Clock& clock, long long first, long long last, const std::atomic<bool>* abandon) override {
        std::array<Ambient<Real>, most_steps_a_turn> ambient;
        constexpr long long mass_steps_a_turn = 10'000'000;  // some hundredths of a second
        const auto longest_turn = std::clamp(mass_steps_a_turn / physics_.grid.masses(), 1LL, 0LL + most_steps_a_turn);
        for (long long step = first; step < last;) {
            if (abandon && abandon->load(std::memory_order_relaxed)) return false;
            const int steps = static_cast<int>(std::min(longest_turn, last - step));
            for (int n = 0; n < steps; ++n)
                ambient[n] = fold<Real>(physics_.material.mass, clock.at(step + n), physics_.gravity, physics_.drag,
                                        physics_.friction, physics_.wind);
            turn(ambient.data(), steps, static_cast<Real>(clock.dt));
            step += steps;
        }
        return true;
    }

    void use_threads(int threads) override {
        const bool pays = physics_.grid.masses() >= fewest_masses_for_threads && threads > 1;
        team_ = pays ? std::make_unique<Team<Real>>(threads, cloth_) : nullptr;
    }

    void keep() override { copy(cloth_, kept_); }
    void return_to_kept() override { copy(kept_, cloth_); }

    Energy energy() const override { return measure(cloth_, physics_.material); }

    glm::dvec3 moved_since_kept() const override {
        glm::dvec3 moved{0.0};
        const auto now = cloth_.view(), before = kept_.view();
        for (int j = 0; j < physics_.grid.rows; ++j) {
            using V = Vector<Real>;
            Triple<V> row{};
            for (int i = 0; i < cloth_.width(); i += Lanes<V>::width)
                row = row + (now[j].template position<V>(i) - before[j].template position<V>(i));
            for (int n = 0; n < Lanes<V>::width; ++n) moved += glm::dvec3(row.x[n], row.y[n], row.z[n]);
        }
        return moved;
    }

    Masses masses() const override {
        Masses all;
        for (int j = 0; j < physics_.grid.rows; ++j)
            for (int i = 0; i < physics_.grid.columns; ++i) {
                all.x.push_back(cloth_.position(i, j));
                all.v.push_back(cloth_.velocity(i, j));
            }
        return all;
    }

    void set(const Masses& masses) override {
        std::size_t n = 0;
        for (int j = 0; j < physics_.grid.rows; ++j)
            for (int i = 0; i < physics_.grid.columns; ++i, ++n) {
                const bool held = is_attached(physics_.attach, physics_.grid, i, j);
                cloth_.set_position(i, j, masses.x[n]);
                cloth_.set_velocity(i, j, held ? glm::dvec3(0.0) : masses.v[n]);
            }
    }

    void snapshot(Snapshot& into) const override {
        into.columns = physics_.grid.columns;
        into.rows = physics_.grid.rows;
        into.stride = cloth_.stride();
        std::vector<float>* const to[] = {&into.x, &into.y, &into.z, &into.vx, &into.vy, &into.vz};
        for (int c = 0; c < 6; ++c) to[c]->assign(cloth_.component(c).begin(), cloth_.component(c).end());
    }

    std::uint64_t state_hash() const override {
        std::uint64_t hash = 0;
        for (int c = 0; c < 6; ++c)
            for (int j = 0; j < physics_.grid.rows; ++j)
                for (int i = 0; i < physics_.grid.columns; ++i) {
                    const Real value = cloth_.component(c)[static_cast<std::size_t>(j) * cloth_.stride() + i];
                    std::uint64_t bits = 0;
                    std::memcpy(&bits, &value, sizeof value);
                    hash = mix(hash ^ bits);
                }
        return hash;
    }

private:
    static constexpr int most_steps_a_turn = 64;  // per waking of the team
    static constexpr long long fewest_masses_for_threads = 4096;

    void turn(const Ambient<Real>* ambient, int steps, Real dt) {
        const auto rows = cloth_.view();
        const auto fabric = fabric_.view();
        if (team_) {
            team_->advance(rows, steps,
                           [&](int first, int last, const Row<Real>* above, const Row<Real>* below, int step,
                               SweepBuffers<Real>& buffers) {
                               kernel_.advance_rows(rows, first, last, above, below, fabric, ambient[step], dt,
                                                    buffers);
                           });
            return;
        }
        for (int n = 0; n < steps; ++n)
            kernel_.advance_rows(rows, 0, rows.rows, nullptr, nullptr, fabric, ambient[n], dt, buffers_);
    }

    static void copy(const Cloth<Real>& from, Cloth<Real>& to) {
        for (int c = 0; c < 6; ++c)
            std::copy(from.component(c).begin(), from.component(c).end(), to.component(c).begin());
    }

    Physics physics_;
    const Kernel<Real>& kernel_;
    Cloth<Real> cloth_, kept_;
    Fabric<Real> fabric_;
    SweepBuffers<Real> buffers_;
    std::unique_ptr<Team<Real>> team_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Physics& physics, Precision precision) {
    if (precision == Precision::double_precision) return std::make_unique<EngineOf<double>>(physics);
    return std::make_unique<EngineOf<float>>(physics);
}

}  // namespace drapeau

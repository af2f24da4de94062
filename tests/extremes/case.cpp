#include "extremes/case.hpp"

#include "extremes/draw.hpp"
#include "scene/check.hpp"
#include "scene/material.hpp"
#include "scene/settings.hpp"
#include "scene/surroundings.hpp"

#include "drapeau/stability.hpp"

#include <array>
#include <cmath>

namespace drapeau::extremes {
namespace {

/// A share of the largest stable step, or seconds; none of both: "auto".
struct StepLevel {
    double share = 0.0, seconds = 0.0;
};
struct GridLevel {
    int columns, rows;
};
/// A cell of so many metres, or a whole flag.
struct SizeLevel {
    double wide, high;
    bool whole;
};
/// Absolute (N s/m), or a share of what is critical for one spring.
struct DampingLevel {
    double value = 0.0, share = 0.0;
};
/// Ground so many flag's heights above its foot, through it where nothing holds it up, and a pole, both of this
/// friction.
struct ContactLevel {
    double ground = NAN, friction = 0.0;

    bool exists() const { return !std::isnan(ground); }
};
struct StartLevel {
    Begin begin;
    Start start;
    double prestretch;
};

// The first level of each is the usual one.
constexpr Precision precisions[] = {Precision::double_precision, Precision::single_precision};
constexpr int threads[] = {1, 2, 3};
constexpr StepLevel steps[] = {{},      {0.3},     {0.7},     {0.95},    {0.05},          {1.05},   {1.5},
                               {100.0}, {0, 1e-7}, {0, 1e-5}, {0, 1e-3}, {0, 1.0 / 60.0}, {0, 1.0}, {0, 10.0}};
constexpr double stiffnesses[] = {200.0, 1e-9, 1e-3, 1.0, 1e4, 1e6, 1e9};
constexpr double diagonals[] = {0.5, 0.0, 1.0, 1e-6, 1e3};  // shares of the stiffness; 0: not listed
constexpr double masses[] = {1e-3, 1e-9, 1e-6, 0.1, 10.0, 1e3, 1e6};
constexpr DampingLevel dampings[] = {{0, 0.02}, {}, {1e-6}, {1e-3}, {1.0}, {1e6}, {0, 0.5}};
constexpr DampingLevel drags[] = {{0, 0.02}, {}, {1e-6}, {1e-3}, {1.0}, {1e6}};
constexpr DampingLevel frictions[] = {{}, {1e-3}, {1e6}};
constexpr double winds[] = {5.0, 0.0, 40.0, 1000.0};
constexpr double gravities[] = {9.8, 0.0, 1e-6, 1e4};
constexpr GridLevel grids[] = {{9, 6},   {2, 2},   {2, 1},   {1, 9},   {40, 1},
                               {2, 512}, {512, 2}, {17, 13}, {64, 64}, {1024, 1024}};
constexpr SizeLevel sizes[] = {
    {0.05, 0.05, false}, {1.0, 0.05, false}, {0.05, 1.0, false}, {1e-3, 1e-3, true}, {1e3, 1e3, true}};
constexpr StartLevel starts[] = {{Begin::as_the_scene, Start::flat, 0.0},  {Begin::as_the_scene, Start::crumpled, 0.0},
                                 {Begin::as_the_scene, Start::flat, 0.5},  {Begin::as_the_scene, Start::crumpled, 10.0},
                                 {Begin::as_the_scene, Start::flat, -0.9}, {Begin::as_the_scene, Start::hanging, 0.0},
                                 {Begin::one_point, Start::flat, 0.0},     {Begin::folded, Start::flat, 0.0},
                                 {Begin::far_away, Start::crumpled, 0.0}};
constexpr Attach attachments[] = {Attach::hoist, Attach::corner, Attach::grommets,
                                  Attach::edges, Attach::all,    Attach::none};
constexpr std::optional<Air> airs[] = {std::nullopt,
                                       Air{},
                                       Air{.added = true},
                                       Air{.density = 1e3},
                                       Air{.pressure = 1e3, .skin = {}},
                                       Air{.density = 1e-6, .pressure = {}, .skin = {}, .added = true, .cutoff = 0.02}};
constexpr std::optional<Bending> bendings[] = {std::nullopt, Bending{1e-4, 20.0}, Bending{1e-9, 1e6}, Bending{1e-2},
                                               Bending{1e3}};
constexpr std::optional<double> stretch_limits[] = {std::nullopt, 0.05, 0.0, 10.0};
constexpr ContactLevel contacts[] = {{}, {-0.2, 0.0}, {0.0, 0.3}, {0.5, 100.0}};
constexpr bool either[] = {false, true};

enum Factor {
    method_,
    precision_,
    threads_,
    step_,
    stiffness_,
    diagonal_,
    mass_,
    damping_,
    drag_,
    friction_,
    wind_,
    gusts_,
    gravity_,
    grid_,
    size_,
    start_,
    attach_,
    air_,
    bending_,
    stretch_limit_,
    contact_,

    exact_,
    factor_count_
};

template <class T, std::size_t n>
constexpr int count(const T (&)[n]) {
    return static_cast<int>(n);
}

}  // namespace

std::vector<int> level_counts() {
    std::vector<int> counts(factor_count_);
    counts[method_] = static_cast<int>(method_count);
    counts[precision_] = count(precisions), counts[threads_] = count(threads), counts[step_] = count(steps);
    counts[stiffness_] = count(stiffnesses), counts[diagonal_] = count(diagonals), counts[mass_] = count(masses);
    counts[damping_] = count(dampings), counts[drag_] = count(drags), counts[friction_] = count(frictions);
    counts[wind_] = count(winds), counts[gusts_] = 3, counts[gravity_] = count(gravities);
    counts[grid_] = count(grids), counts[size_] = count(sizes), counts[start_] = count(starts);
    counts[attach_] = count(attachments), counts[exact_] = count(either);
    counts[air_] = count(airs), counts[bending_] = count(bendings);
    counts[stretch_limit_] = count(stretch_limits), counts[contact_] = count(contacts);
    return counts;
}

Cases::Cases(std::uint64_t seed) : seed_(seed), rows_(covering(level_counts(), seed)) {}

namespace {

/// Most settings as usual, some extreme; costly ones seldom.
Row sampled(Draw& draw) {
    const auto levels = level_counts();
    const double usual = 0.3 + 0.6 * draw.share();
    Row row(levels.size(), 0);
    for (std::size_t f = 0; f < row.size(); ++f) {
        const bool free = f == method_ || f == precision_ || f == step_ || f == exact_;
        if (free || !draw.chance(usual)) row[f] = draw.one_of(levels[f]);
        const bool costly =
            (f == grid_ && row[f] >= levels[f] - 2) || (f == start_ && starts[row[f]].start == Start::hanging);
        if (costly && !draw.chance(0.05)) row[f] = 0;
    }
    return row;
}

double clamped(double value, const settings::Range& range) {
    return std::clamp(value, range.lowest, range.highest);
}

/// Ground and pole, where the flag is.
void add(const ContactLevel& level, Scene& scene) {
    if (!level.exists()) return;
    const double height = extent_of(scene.flag).height, foot = hoisted_height(scene) - height;
    const bool may_stand = scene.flag.attach == Attach::none;
    const double above = std::min(level.ground, may_stand ? 1.0 : 0.0);
    scene.limits.get<Ground>() = Ground{.height = foot + above * height, .friction = level.friction};
    scene.limits.get<Pole>() = Pole{.friction = level.friction};
}

}  // namespace

Case Cases::at(long long number) const {
    Case of;
    of.seed = seed_, of.number = number;
    Draw draw{mix(seed_), static_cast<std::uint64_t>(number) + 2};
    const bool covers = number < covering_count();
    const Row row = covers ? rows_[static_cast<std::size_t>(number)] : sampled(draw);
    const auto about = [&](double value) { return covers ? value : value * draw.decades(0.5); };

    Scene& scene = of.scene;
    FlagSettings& flag = scene.flag;
    const GridLevel grid = grids[row[grid_]];
    flag.columns = grid.columns, flag.rows = grid.rows;
    const SizeLevel size = sizes[row[size_]];
    const settings::Range lengths{1e-3, 1e3};
    flag.width = clamped(size.wide * (size.whole ? 1 : std::max(1, grid.columns - 1)), lengths);
    flag.height = clamped(size.high * (size.whole ? 1 : std::max(1, grid.rows - 1)), lengths);
    flag.attach = attachments[row[attach_]];
    of.begin = starts[row[start_]].begin;
    flag.start = starts[row[start_]].start, flag.prestretch = starts[row[start_]].prestretch;

    SpringSettings& springs = *scene.springs;
    springs.stiffness = clamped(about(stiffnesses[row[stiffness_]]), settings::stiffness_range);
    springs.mass = clamped(about(masses[row[mass_]]), {1e-9, 1e6});
    if (const double share = about(diagonals[row[diagonal_]]); share > 0.0)
        springs.diagonal_stiffness = clamped(share * springs.stiffness, settings::stiffness_range);
    const double critical = 2.0 * std::sqrt(springs.mass * springs.stiffness);
    const auto set = [&](std::optional<double>& value, const DampingLevel& level) {
        const double wanted = about(level.value + level.share * critical);
        if (wanted > 0.0) value = clamped(wanted, settings::damping_range);
    };
    set(springs.damping, dampings[row[damping_]]);
    set(springs.drag, drags[row[drag_]]);
    set(springs.friction, frictions[row[friction_]]);

    // Every third the same cloth as a fabric, where one can have such cells and values; it knows no friction.
    if (number % 3 == 0 && flag.columns > 1 && flag.rows > 1) {
        Scene as_fabric = scene;
        give_as_fabric(as_fabric);
        if (!find_fault(as_fabric)) scene = as_fabric;
    }
    scene.terms.get<Air>() = airs[row[air_]];
    scene.terms.get<Bending>() = bendings[row[bending_]];
    if (const auto& stretch = stretch_limits[row[stretch_limit_]])
        scene.limits.get<StretchLimit>() = StretchLimit{.stretch = *stretch};
    add(contacts[row[contact_]], scene);
    if (const double speed = about(winds[row[wind_]]); speed > 0.0) {
        if (!scene.drag()) scene.drag() = 0.0;  // a wind that nothing feels is refused
        Wind& wind = scene.wind().emplace();
        wind.velocity = {speed, 0.0, 0.2 * speed};
        if (row[gusts_] > 0) wind.gusts = {0.3 * speed, 0.1 * speed, 0.3 * speed};
        wind.travelling = row[gusts_] == 2;
        wind.seed = mix(seed_) % 1000;
    }
    if (const double g = about(gravities[row[gravity_]]); g > 0.0)
        scene.gravity().emplace().acceleration = {0.0, -std::min(g, 1e4), 0.0};

    scene.time.method = static_cast<Method>(row[method_]);
    scene.time.precision = precisions[row[precision_]];
    of.threads = threads[row[threads_]];
    of.exact_dt = either[row[exact_]];
    const StepLevel step = steps[row[step_]];
    if (step.seconds > 0.0) scene.time.dt = step.seconds;
    if (step.share > 0.0) {
        const Model model = model_of(scene);
        auto limit = stable_step(scene.time.method, model);
        if (!limit.is_finite()) limit = stable_step(method_id<SemiImplicitEuler>, model);
        scene.time.dt = limit.seconds() * (covers ? step.share : step.share * draw.decades(0.1));
    }
    if (scene.time.dt) scene.time.dt = clamped(*scene.time.dt, settings::dt_range);
    return of;
}

std::optional<State<double>> beginning_of(const Case& of, const State<double>& usual) {
    if (of.begin == Begin::as_the_scene) return {};
    const Grid grid = model_of(of.scene).grid;
    State<double> state = usual;
    // Back from the middle on, so that every mass of one half lies on one of the other.
    const auto folded = [](int n, int count) { return n < (count + 1) / 2 ? n : count - 1 - n; };
    const glm::dvec3 hundred_kilometres{6e4, 0.0, 8e4};
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            auto x = usual.position.at(i, j);
            if (of.begin == Begin::one_point) x = {};
            if (of.begin == Begin::folded)
                x = grid.columns > 1 ? grid.rest(folded(i, grid.columns), j) : grid.rest(i, folded(j, grid.rows));
            if (of.begin == Begin::far_away) x += hundred_kilometres;
            state.position.set(i, j, x);
        }
    return state;
}

}  // namespace drapeau::extremes

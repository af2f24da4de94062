#include "scene/material.hpp"

#include "scene/settings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace drapeau {

namespace {

constexpr double within = 1.0 - 1e-9;  // of the longest cell: there one kind of springs would have no stiffness

/// How long a cell is for its width.
double slenderness(const FlagSettings& flag) {
    const Grid grid = spread(flag.columns, flag.rows, flag.width, flag.height);
    return grid.pitch_x / grid.pitch_y;
}

constexpr int most_masses = 4096;  // along a side

/// The count of masses along one side nearest to the one there is, such that cells are between 1/longest and longest of
/// what they are wide; `cells` is their number on that side for square ones.
std::optional<int> nearest_count(double cells, double longest, int now) {
    const double least = std::max(1.0, std::ceil(cells / (within * longest)));
    const double most = std::min(most_masses - 1.0, std::floor(cells * within * longest));
    if (!(least <= most)) return {};
    return static_cast<int>(std::clamp(static_cast<double>(now - 1), least, most)) + 1;
}
std::optional<int> fitting_rows(const Scene& scene, int columns) {
    const FlagSettings& flag = scene.flag;
    return nearest_count((columns - 1) * flag.height / flag.width, longest_cell(*scene.fabric), flag.rows);
}
std::optional<int> fitting_columns(const Scene& scene, int rows) {
    const FlagSettings& flag = scene.flag;
    return nearest_count((rows - 1) * flag.width / flag.height, longest_cell(*scene.fabric), flag.columns);
}

}  // namespace

bool do_cells_fit(const Scene& scene) {
    if (!scene.fabric || scene.flag.columns < 2 || scene.flag.rows < 2) return true;
    const double ratio = slenderness(scene.flag), longest = within * longest_cell(*scene.fabric);
    return std::max(ratio, 1.0 / ratio) <= longest;
}

std::optional<std::pair<int, int>> fitting_grid(const Scene& scene) {
    const FlagSettings& flag = scene.flag;
    const auto change = [](int from, int to) { return std::abs(std::log((to - 1.0) / (from - 1.0))); };
    std::optional<std::pair<int, int>> nearest;
    double least = INFINITY;
    for (int columns = 2; columns <= most_masses; ++columns)
        if (const auto rows = fitting_rows(scene, columns)) {
            const double all = change(flag.columns, columns) + change(flag.rows, *rows);
            if (all < least) least = all, nearest = {columns, *rows};
        }
    return nearest;
}

void fit_cells(Scene& scene, const FlagSettings& before) {
    if (do_cells_fit(scene)) return;
    FlagSettings& flag = scene.flag;
    const bool are_rows_given = flag.rows != before.rows;
    if (const auto count = are_rows_given ? fitting_columns(scene, flag.rows) : fitting_rows(scene, flag.columns))
        (are_rows_given ? flag.columns : flag.rows) = *count;
    else if (const auto grid = fitting_grid(scene))
        std::tie(flag.columns, flag.rows) = *grid;
}

void give_as_fabric(Scene& scene) {
    const SpringSettings springs = *scene.springs;
    const FlagSettings& flag = scene.flag;
    const Grid grid = spread(flag.columns, flag.rows, flag.width, flag.height);
    const double a = grid.pitch_x, b = grid.pitch_y;
    Fabric fabric;
    fabric.density = springs.mass / (a * b);
    const double s = springs.diagonal_stiffness.value_or(0.0) / springs.stiffness * 2.0 * a * b / (a * a + b * b);
    fabric.diagonal_share.reset();
    if (s > 0.0) fabric.diagonal_share = s;
    fabric.stretch_modulus = springs.stiffness * (1.0 + 2.0 * s) / (1.0 + s);
    fabric.damping_time.reset();
    if (springs.damping) fabric.damping_time = *springs.damping / springs.stiffness;
    if (springs.drag) fabric.drag_per_area = *springs.drag / (a * b);
    scene.fabric = fabric;
    scene.springs.reset();
    fit_cells(scene, flag);
}

void give_as_springs(Scene& scene) {
    const Model model = model_of(scene);
    const Springs& springs = model.springs;
    const double mean = std::sqrt(springs.along_hoist);
    SpringSettings given;
    given.mass = springs.mass;
    given.stiffness = mean * springs.stiffness;
    given.diagonal_stiffness = springs.diagonal_stiffness;
    if (springs.damping) given.damping = mean * *springs.damping;
    if (scene.fabric->drag_per_area) given.drag = *scene.fabric->drag_per_area * model.cell();
    scene.springs = given;
    scene.fabric.reset();
}

double usual_diagonals(const Scene& scene) {
    return scene.fabric ? fabric_of(scene.fabric->name).diagonal_share.value_or(0.5) : 0.5 * scene.springs->stiffness;
}

}  // namespace drapeau

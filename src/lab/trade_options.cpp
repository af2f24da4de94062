#include "trade_options.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "lists.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

long long batches_option(const std::string& option, const std::string& text, long long least) {
    constexpr double longest = 3600.0, rounding = 1e-3;
    const double seconds = number_option(option, text, {least > 0 ? 0.0166 : 0.0, longest}, "seconds");
    const double batches = seconds / batch_seconds, whole = std::round(batches);
    if (std::abs(batches - whole) <= rounding) return std::llround(whole);
    refuse(option, text,
           "a whole number of sixtieths of a second, such as " + rounded(std::ceil(batches) * batch_seconds, 6) + ",");
}

std::pair<int, int> grid_in(const std::string& text) {
    const auto cross = text.find('x');
    const auto side = [](const std::string& digits) {
        const bool is_whole =
            !digits.empty() && digits.size() < 6 && digits.find_first_not_of("0123456789") == std::string::npos;
        return is_whole ? std::stoi(digits) : 0;
    };
    const int columns = cross == std::string::npos ? 0 : side(text.substr(0, cross));
    const int rows = cross == std::string::npos ? 0 : side(text.substr(cross + 1));
    if (columns < 1 || rows < 1) refuse("--grids", text, "COLUMNSxROWS such as 23x15");
    return {columns, rows};
}

std::optional<double> limit_in(const std::string& text) {
    if (text == "off") return {};
    const auto share = number_in(text);
    if (!share || !(*share >= 0.0 && *share <= 10.0))
        refuse("--limits", text, "off or a share from 0 to 10, such as 0.05,");
    return *share;
}

/// Up to a batch, which may be given in decimals.
double step_in(const std::string& text) {
    constexpr double rounding = 1e-5;
    const auto number = number_in(text);
    const double least = settings::dt_range.lowest;
    if (number && *number >= least && *number <= batch_seconds * (1.0 + rounding))
        return std::min(*number, batch_seconds);
    refuse("--dt", text, "a number of seconds from " + shortest(least) + " to 1/60");
}

Scene scene_in(const TradeOptions& options) {
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set) assignments.push_back(assignment_in(text));
    return read_scene(find_scene(options.scene), assignments);
}

}  // namespace

double distance_in(const std::string& option, const std::string& text) {
    struct Unit {
        std::string_view name;
        double metres;
    };
    constexpr Unit units[] = {{"nm", 1e-9}, {"um", 1e-6}, {"µm", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}};
    constexpr double least = 1e-12, most = 1e3;
    const std::string_view whole = without_space(text);
    for (const auto& [name, metres] : units) {
        if (!whole.ends_with(name)) continue;
        const auto number = number_in(without_space(whole.substr(0, whole.size() - name.size())));
        if (number && *number * metres >= least && *number * metres <= most) return *number * metres;
        if (number) break;
    }
    refuse(option, text, "a distance from 0.001 nm to 1000 m with its unit (nm, um, mm, cm or m), such as 1mm,");
}

TradeRequest request_in(const TradeOptions& options, const Scene& scene) {
    TradeRequest request;
    constexpr double most_minutes = 7.0 * 24.0 * 60.0;
    request.batches_are_given = !options.seconds.empty();
    if (request.batches_are_given) request.batches = batches_option("--seconds", options.seconds, 1);
    request.settle = static_cast<double>(batches_option("--settle", options.settle, 0)) * batch_seconds;
    request.budget = 60.0 * number_option("--budget", options.budget, {0.01, most_minutes}, "minutes");
    if (!options.tolerance.empty()) request.tolerance = distance_in("--tolerance", options.tolerance);
    if (!options.write.empty() && !request.tolerance)
        throw InputError("--write: it saves the setting that --tolerance names; give --tolerance too");
    TradeChoice& choice = request.choice;
    choice.methods = names_option<Method>("--methods", options.methods, settings::method_names);
    choice.precisions = names_option<Precision>("--precisions", options.precisions, settings::precision_names);
    for (const std::string& item : items_of(options.dt)) choice.steps.push_back(step_in(item));
    for (const std::string& item : items_of(options.grids)) choice.grids.push_back(grid_in(item));
    for (const std::string& item : items_of(options.limits)) choice.limits.push_back(limit_in(item));
    choice.both_diagonals = options.both_diagonals;
    request.scene = scene;
    return request;
}

TradeRequest request_in(const TradeOptions& options) {
    TradeRequest request = request_in(options, Scene{});
    request.scene = scene_in(options);
    return request;
}

}  // namespace drapeau::lab

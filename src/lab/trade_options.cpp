#include "trade_options.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "lists.hpp"
#include "scene/settings.hpp"
#include "shared_options.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

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

}  // namespace

TradeRequest request_in(const TradeOptions& options, const Scene& scene) {
    TradeRequest request;
    read_comparison(options, request);
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
    request.scene = scene_in(options.scene, options.set);
    return request;
}

}  // namespace drapeau::lab

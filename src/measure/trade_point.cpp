#include "measure/trade_point.hpp"

#include "measure/same_cloth.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"
#include "scene/material.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

Variant named(const Scene& scene, const Scene& given) {
    const auto limit_of = [](const Scene& s) {
        const auto& limit = s.limits.get<StretchLimit>();
        return limit ? std::optional(limit->stretch) : std::nullopt;
    };
    Variant variant{fmt::format("{}x{}", scene.flag.columns, scene.flag.rows), "", scene};
    const auto differs = [&](const std::string& label) {
        variant.label += (variant.label.empty() ? "" : ", ") + label;
    };
    if (scene.flag.columns != given.flag.columns || scene.flag.rows != given.flag.rows)
        differs(fmt::format("{} x {}", scene.flag.columns, scene.flag.rows));
    const bool diagonals = scene.diagonals().has_value();
    if (diagonals != given.diagonals().has_value()) {
        variant.key += std::string(" diagonals=") + (diagonals ? "on" : "off");
        differs(diagonals ? "diagonal springs" : "no diagonal springs");
    }
    if (const auto limit = limit_of(scene); limit != limit_of(given)) {
        variant.key += " limit=" + (limit ? shortest(*limit) : "off");
        differs(limit ? "limit " + rounded(100.0 * *limit, 3) + " %" : "no limit");
    }
    return variant;
}

/// Whole numbers of steps in a batch, the coarsest first, none twice.
using Counts = std::vector<long long>;

long long count_of(double dt) {
    return std::llround(batch_seconds / whole_steps_per_batch(dt));
}

Counts usual_counts(Method method, const Model& model) {
    return with_method(method, [&]<class M>(const M& chosen) {
        constexpr double past = 1.15, below = 0.95;  // of the limit
        constexpr int finest = 8;                    // of the automatic step
        Counts counts;
        const StableStep stable = stable_step(chosen, model);
        if (stable.is_none()) {
            // What the others take: it shows what the method makes of it.
            const long long usual = count_of(automatic_step(SemiImplicitEuler{}, model));
            return Counts{usual, 4 * usual, 16 * usual};
        }
        if (stable.is_finite()) {
            const auto beyond = static_cast<long long>(std::floor(batch_seconds / (past * stable.seconds())));
            if (beyond >= 1) counts.push_back(beyond);
            if (below * stable.seconds() < M::coarsest_step) counts.push_back(count_of(below * stable.seconds()));
        }
        const long long usual = count_of(automatic_step(chosen, model));
        if (M::creates_energy) {  // a limit that only damping sets: far below those of others
            counts.push_back(usual);
            counts.push_back(count_of(automatic_step(SemiImplicitEuler{}, model)));
            return counts;
        }
        for (long long n = 1; n <= finest; n *= 2) counts.push_back(n * usual);
        return counts;
    });
}

}  // namespace

double TradePoint::dt() const {
    return batch_seconds / static_cast<double>(steps_a_batch);
}

Scene TradePoint::scene_on(const Variant& model) const {
    Scene scene = model.scene;
    scene.time.method = method;
    scene.time.precision = precision;
    scene.time.dt = dt();
    scene.time.tolerance.reset();
    return scene;
}

std::vector<Variant> variants_of(const Scene& scene, const TradeChoice& choice) {
    std::vector<Variant> variants{named(scene, scene)};
    const auto add = [&](const Scene& other) {
        check_scene(other);
        Variant variant = named(other, scene);
        const bool known =
            std::any_of(variants.begin(), variants.end(), [&](const Variant& v) { return v.key == variant.key; });
        if (!known) variants.push_back(std::move(variant));
    };
    for (const auto& [columns, rows] : choice.grids) add(same_cloth(scene, columns, rows));
    if (choice.both_diagonals)
        for (std::size_t n = 0, count = variants.size(); n < count; ++n) {
            Scene other = variants[n].scene;
            other.diagonals() = other.diagonals() ? std::nullopt : std::optional(usual_diagonals(other));
            add(other);
        }
    for (std::size_t n = 0, count = variants.size(); n < count; ++n)
        for (const auto& limit : choice.limits) {
            Scene other = variants[n].scene;
            auto& listed = other.limits.get<StretchLimit>();
            listed.reset();
            if (limit) listed = StretchLimit{.stretch = *limit};
            add(other);
        }
    return variants;
}

std::vector<TradePoint> points_of(const std::vector<Variant>& variants, const TradeChoice& choice) {
    std::vector<Method> methods = choice.methods;
    if (methods.empty())
        for (std::size_t n = 0; n < method_count; ++n) methods.push_back(static_cast<Method>(n));
    std::vector<Precision> precisions = choice.precisions;
    if (precisions.empty()) precisions = {Precision::single_precision, Precision::double_precision};

    std::vector<TradePoint> points;
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const Model model = model_of(variants[v].scene);
        const TimeSettings& own = variants[v].scene.time;
        for (const Method method : methods) {
            Counts counts;
            for (const double dt : choice.steps) counts.push_back(count_of(dt));
            if (counts.empty()) {
                counts = usual_counts(method, model);
                if (own.dt && own.method == method) counts.push_back(count_of(*own.dt));
            }
            std::sort(counts.begin(), counts.end());
            counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
            for (const Precision precision : precisions)
                for (const long long count : counts)
                    points.push_back(
                        {v, method, precision, count,
                         fmt::format("{} {} {} {}", name_of(method), count, name_of(precision), variants[v].key)});
        }
    }
    return points;
}

}  // namespace drapeau

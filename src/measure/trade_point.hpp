// Trade point: one setting of a scene whose error and cost are measured, and the list of those a sweep measures.
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace drapeau {

/// A model to compare: the scene as given (the first), or on another grid, without diagonal springs, with another
/// stretch limit.
struct Variant {
    std::string key;    // stable: "45x30", "45x30 diagonals=off limit=0.05"
    std::string label;  // for people, what differs from the scene; "" for the scene itself
    Scene scene;
};

struct TradePoint {
    std::size_t variant = 0;  // in the list of variants
    Method method{};
    Precision precision{};
    long long steps_a_batch = 1;
    std::string key;  // stable, names the point among all there are: "leapfrog 120 float 45x30"

    double dt() const;  // s
    /// The scene to run, with the step as the window takes it: a whole number of them in 1/60 s.
    Scene scene_on(const Variant& model) const;
};

/// What a sweep compares. An empty list is what the scene says, or every one there is.
struct TradeChoice {
    std::vector<Method> methods;
    std::vector<Precision> precisions;
    std::vector<double> steps;                  // s
    std::vector<std::pair<int, int>> grids;     // columns, rows
    bool both_diagonals = false;                // with and without them
    std::vector<std::optional<double>> limits;  // shares; nothing: no limit
};

/// The scene itself first. Throws InputError where one is impossible.
std::vector<Variant> variants_of(const Scene& scene, const TradeChoice& choice);

/// Every method in every precision: one step past its limit, one just below it, the automatic one and fractions of it.
/// A method without a limit, from its coarsest step on.
std::vector<TradePoint> points_of(const std::vector<Variant>& variants, const TradeChoice& choice);

}  // namespace drapeau

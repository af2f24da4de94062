// Case: case n of a seed: a scene of extremes, how it begins and how it is run. The first few hundred cases of a seed
// have every pair of extremes (covering.hpp); those after them take most settings as they usually are and a few extreme
// ones, each off by up to half a decade.
#pragma once

#include "extremes/covering.hpp"
#include "scene/scene.hpp"

#include "drapeau/state.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drapeau::extremes {

/// Where the masses begin, beyond what a scene file can say.
enum class Begin { as_the_scene, one_point, folded, far_away };

struct Case {
    std::uint64_t seed = 1;
    long long number = 0;
    Scene scene;
    Begin begin = Begin::as_the_scene;
    int threads = 1;
    bool exact_dt = true;  // a numeric step as given, or made to fill 1/60 s
};

/// How many levels each factor has, in the order of a row.
std::vector<int> level_counts();

/// The cases of one seed.
class Cases {
public:
    explicit Cases(std::uint64_t seed);
    /// So many cases have every pair.
    long long covering_count() const { return static_cast<long long>(rows_.size()); }
    Case at(long long number) const;

private:
    std::uint64_t seed_;
    std::vector<Row> rows_;
};

/// The start of a case that no scene file can say; `usual` is what its scene begins with.
std::optional<State<double>> beginning_of(const Case& of, const State<double>& usual);

}  // namespace drapeau::extremes

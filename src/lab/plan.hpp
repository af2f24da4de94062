// Plan: how the time asked for is filled with steps, and whether anybody would wait for that.
#pragma once

#include "run/simulation.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>

namespace drapeau::lab {

/// How the time is filled: whole batches as the window does, or so many steps of one length.
struct Plan {
    long long batches = 0;
    long long steps = 0;
    std::optional<double> dt;              // s, of those steps
    std::optional<Precision> precision{};  // that those steps need, the scene's dt being automatic
    std::string remark{};                  // why
};

/// Throws InputError where a given step does not fill the time (s), or an automatic one would be shorter than any that
/// may be given. `given_seconds`: the time as it was written.
Plan plan_for(const Scene& scene, double seconds, const std::string& given_seconds);

/// Refuses what would take longer than anybody waits, before it begins.
void check_duration(const Scene& scene, const Simulation& simulation, double seconds);

/// Ends in its first minute what turns out to take as long after all: nobody knows before how many sweeps a limit
/// needs.
void check_pace(double share_done, double wall);

}  // namespace drapeau::lab

// What makes a scene impossible, found in its values alone: a number out of its range, a flag of one mass, wind that
// nothing feels, more memory than there is.
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <string>

namespace drapeau {

struct SceneFault {
    std::string table;    // "" before the first table
    std::string key;      // "" if the fault is the table's
    std::string value;    // as a file would say it; "" if the fault is in no single value
    std::string allowed;  // what is allowed instead

    /// flag.columns = 0: a whole number from 1 to 4096 is allowed
    std::string text() const;
};

inline constexpr const char* two_materials =
    "the material is given by [springs] and [fabric]; leave out one of them (springs=off or fabric=off)";

std::optional<SceneFault> find_fault(const Scene& scene);

/// Whether there is a force that wind acts by.
bool feels_wind(const Scene& scene);

/// Bytes a run of this many masses takes, all its copies included.
double memory_of(double masses, Precision precision, bool has_added_air = false);

}  // namespace drapeau

#include "wind_streaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace drapeau {

namespace {

constexpr double longest_drift = 0.25;  // s; what is longer was a jump
constexpr double fades_within = 0.12;   // of the box, from a face

struct Box {
    glm::dvec3 low, size;
};

/// As wide and high as what the camera frames, and as deep as that is high.
Box around(const Framing& framing) {
    const glm::dvec3 size(framing.width, 0.75 * framing.height, framing.height);
    return {glm::dvec3(framing.centre) + glm::dvec3(0.0, 0.08 * framing.height, 0.0) - 0.5 * size, size};
}

double wrapped(double share) {
    return share - std::floor(share);
}

}  // namespace

void WindStreaks::drift(const Wind& wind, const Framing& framing, double time) {
    if (places_.empty())
        for (int n = 0; n < count; ++n) {
            glm::dvec3& place = places_.emplace_back();
            for (int axis = 0; axis < 3; ++axis) place[axis] = wrapped(random_at(7, std::uint64_t(axis), n));
        }
    const Box box = around(framing);
    const double passed = time - time_;
    const bool drifts = passed > 0.0 && passed < longest_drift;
    time_ = time;
    streaks_.clear();
    for (glm::dvec3& place : places_) {
        const glm::dvec3 here = wind.at(time, box.low + place * box.size);
        double inside = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            if (drifts) place[axis] = wrapped(place[axis] + here[axis] * passed / box.size[axis]);
            inside = std::min({inside, place[axis] / fades_within, (1.0 - place[axis]) / fades_within});
        }
        const glm::dvec3 to = box.low + place * box.size;
        streaks_.push_back({glm::vec3(to - double(trail) * here), glm::vec3(to), float(inside)});
    }
}

int beaufort(double speed) {
    constexpr std::array limits{0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7};
    return int(std::distance(limits.begin(), std::upper_bound(limits.begin(), limits.end(), speed)));
}

const char* beaufort_name(int force) {
    constexpr std::array names{"calm",         "light air",     "light breeze", "gentle breeze", "moderate breeze",
                               "fresh breeze", "strong breeze", "near gale",    "gale",          "strong gale",
                               "storm",        "violent storm", "hurricane"};
    return names[std::size_t(std::clamp(force, 0, 12))];
}

}  // namespace drapeau

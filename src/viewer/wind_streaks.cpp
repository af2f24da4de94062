#include "wind_streaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace drapeau {

namespace {

constexpr double longest_drift = 0.25;  // s; what is longer was a jump
constexpr double fades_within = 0.12;   // of the box, from a face
constexpr double life = 1.2;            // s, of a mote
constexpr double fades_for = 0.15;      // of its life, at both ends

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

// Gusts gather motes where the wind slackens, and all would come to drift there: each begins anew before long.
void WindStreaks::drift(const Wind& wind, const Framing& framing, double time) {
    places_.resize(count, glm::dvec3(0.0));
    lives_.resize(count, -1);
    const Box box = around(framing);
    const double passed = time - time_;
    const bool drifts = passed > 0.0 && passed < longest_drift;
    time_ = time;
    if (drifts) drifted_ += passed;
    streaks_.clear();
    for (std::size_t n = 0; n < places_.size(); ++n) {
        glm::dvec3& place = places_[n];
        const double lived = drifted_ / life + double(n) / count, age = lived - std::floor(lived);
        const bool begins = std::exchange(lives_[n], std::int64_t(lived)) != std::int64_t(lived);
        if (begins)
            for (int axis = 0; axis < 3; ++axis)
                place[axis] = wrapped(random_at(7, std::uint64_t(axis), lives_[n] * count + std::int64_t(n)));
        const glm::dvec3 here = wind.at(time, box.low + place * box.size);
        double strength = std::min({1.0, age / fades_for, (1.0 - age) / fades_for});
        for (int axis = 0; axis < 3; ++axis) {
            if (drifts && !begins) place[axis] = wrapped(place[axis] + here[axis] * passed / box.size[axis]);
            strength = std::min({strength, place[axis] / fades_within, (1.0 - place[axis]) / fades_within});
        }
        const glm::dvec3 to = box.low + place * box.size;
        streaks_.push_back({glm::vec3(to - double(trail) * here), glm::vec3(to), float(strength)});
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

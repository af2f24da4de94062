// Wind streaks: they drift with the wind and stay about the flag; the Beaufort scale is the one that is printed.
#include "catch.hpp"

#include "viewer/wind_streaks.hpp"

#include <cmath>

using namespace drapeau;

namespace {

const Framing framing{.centre = {0.75f, -0.5f, 0.0f}, .width = 2.0f, .height = 1.5f};

}  // namespace

TEST_CASE("streaks drift with the wind, as far as it blows in the time that passed") {
    const Wind wind{.velocity = {6.0, 0.0, -2.0}};
    WindStreaks streaks;
    streaks.drift(wind, framing, 0.0);
    const auto before = streaks.streaks();
    streaks.drift(wind, framing, 0.02);
    int followed = 0;
    for (std::size_t n = 0; n < before.size(); ++n) {
        const glm::vec3 moved = streaks.streaks()[n].to - before[n].to;
        if (std::abs(moved.x) > 1.0f || std::abs(moved.z) > 1.0f) continue;  // it came in again on the other side
        if (streaks.streaks()[n].strength < 0.12f) continue;                 // it has just begun anew
        ++followed;
        CHECK(moved.x == Approx(0.12f).margin(1e-4));
        CHECK(moved.y == Approx(0.0f).margin(1e-4));
        CHECK(moved.z == Approx(-0.04f).margin(1e-4));
    }
    CHECK(followed > WindStreaks::count / 2);
}

TEST_CASE("streaks stay in their box, fade out at its faces, and a jump in time does not move them") {
    const Wind wind{.velocity = {20.0, 3.0, 5.0}, .gusts = {5.0, 2.0, 5.0}};
    WindStreaks streaks;
    for (int n = 0; n < 600; ++n) {
        streaks.drift(wind, framing, n / 60.0);
        for (const Streak& streak : streaks.streaks()) {
            REQUIRE(std::abs(streak.to.x - framing.centre.x) <= 0.5f * framing.width + 1e-4f);
            REQUIRE(std::abs(streak.to.y - framing.centre.y) <= framing.height);
            REQUIRE(streak.strength >= 0.0f);
            REQUIRE(streak.strength <= 1.0f);
            if (std::abs(streak.to.x - framing.centre.x) > 0.499f * framing.width) REQUIRE(streak.strength < 0.02f);
        }
    }
    const auto before = streaks.streaks();
    streaks.drift(wind, framing, 100.0);
    CHECK(streaks.streaks().front().to == before.front().to);
}

TEST_CASE("travelling gusts do not gather the streaks in one place") {
    const Wind wind{.velocity = {20.0, 0.0, 0.0}, .gusts = {6.0, 3.0, 3.0}, .period = 1.0, .travelling = true};
    WindStreaks streaks;
    for (int n = 0; n < 600; ++n) streaks.drift(wind, framing, n / 60.0);
    int left = 0;
    for (const Streak& streak : streaks.streaks()) left += streak.to.x < framing.centre.x;
    CHECK(left > WindStreaks::count / 4);
    CHECK(left < 3 * WindStreaks::count / 4);
}

TEST_CASE("Beaufort's forces begin where the scale says, and the page of the wind says knots by the nautical mile") {
    CHECK(beaufort(0.0) == 0);
    CHECK(beaufort(0.29) == 0);
    CHECK(beaufort(0.3) == 1);
    CHECK(beaufort(5.4) == 3);
    CHECK(beaufort(5.5) == 4);
    CHECK(beaufort(20.8) == 9);
    CHECK(beaufort(32.6) == 11);
    CHECK(beaufort(80.0) == 12);
    CHECK(std::string(beaufort_name(8)) == "gale");
    CHECK(std::string(beaufort_name(12)) == "hurricane");
    CHECK(10.0 * knots_in_a_metre_per_second == Approx(19.438).epsilon(1e-4));
}

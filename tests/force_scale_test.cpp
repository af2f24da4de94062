// Force scale: a round number above the forces, that follows them without flicker.
#include "catch.hpp"

#include "viewer/force_scale.hpp"

#include <cmath>
#include <limits>

using namespace drapeau;

TEST_CASE("rounding up gives the smallest of 1, 2, 5 times a power of ten that is not below") {
    for (int exponent = -5; exponent <= 6; ++exponent) {
        const double decade = std::pow(10.0, exponent);
        CAPTURE(decade);
        for (const double step : {1.0, 2.0, 5.0}) CHECK(rounded_up(step * decade) == Approx(step * decade));
        CHECK(rounded_up(1.01 * decade) == Approx(2.0 * decade));
        CHECK(rounded_up(2.01 * decade) == Approx(5.0 * decade));
        CHECK(rounded_up(5.01 * decade) == Approx(10.0 * decade));
    }
    for (const double none : {0.0, -1.0, 1e-300, std::numeric_limits<double>::quiet_NaN()})
        CHECK(rounded_up(none) == Approx(1e-6));
}

TEST_CASE("the scale rises with the forces at once, to a round number above them") {
    ForceScale scale;
    for (const double newtons : {0.013, 0.6, 3.0, 40.0}) {
        CAPTURE(newtons);
        scale.follow(newtons);
        // Twice the root mean square, and never more than the next round number, which is at most 2.5 times as much.
        CHECK(scale.newtons() >= 2.0 * newtons * 0.99);
        CHECK(scale.newtons() <= 2.5 * 2.0 * newtons);
        CHECK(rounded_up(scale.newtons()) == Approx(scale.newtons()));
    }
}

TEST_CASE("the scale does not flicker where forces waver, around a round number or widely") {
    ForceScale scale;
    scale.follow(1.1);
    const double shown = scale.newtons();
    for (int batch = 0; batch < 600; ++batch) {
        scale.follow(batch % 3 == 0 ? 1.1 : batch % 3 == 1 ? 0.9 : 0.01);
        REQUIRE(scale.newtons() == shown);
    }
}

TEST_CASE("the scale comes down once the forces are gone for good, and stays down") {
    ForceScale scale;
    scale.follow(40.0);
    double before = scale.newtons();
    int changes = 0;
    for (int batch = 0; batch < 600; ++batch) {
        scale.follow(0.4);
        REQUIRE(scale.newtons() <= before);
        changes += scale.newtons() < before;
        before = scale.newtons();
    }
    CHECK(before >= 2.0 * 0.4 * 0.99);
    CHECK(before <= 5.0);
    CHECK(changes <= 7);  // of the round numbers from 100 to 1
}

TEST_CASE("forces that are no number leave the scale as it is") {
    ForceScale scale;
    scale.follow(3.0);
    const double shown = scale.newtons();
    for (const double broken : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        scale.follow(broken);
    CHECK(scale.newtons() == shown);
}

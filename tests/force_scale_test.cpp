// Force scale: a round number above the forces, that follows them without flicker.
#include "catch.hpp"

#include "viewer/force_scale.hpp"

#include <cmath>
#include <limits>

using namespace drapeau;

namespace {

constexpr int columns = 5, rows = 4;

Scene sheet() {
    Scene scene;
    scene.flag.columns = columns;
    scene.flag.rows = rows;
    scene.flag.width = columns - 1.0;
    scene.flag.height = rows - 1.0;
    scene.springs.stiffness = 100.0;
    return scene;
}

/// Every spring of the sheet stretched by `newtons` of force.
Snapshot pulled(double newtons) {
    const double length = 1.0 + newtons / 100.0;
    Snapshot s;
    s.columns = columns, s.rows = rows, s.stride = columns + 3;
    for (auto* part : {&s.x, &s.y, &s.z}) part->resize(std::size_t(s.stride) * rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            s.x[std::size_t(row * s.stride + column)] = float(column * length);
            s.y[std::size_t(row * s.stride + column)] = float(-row * length);
        }
    return s;
}

}  // namespace

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
        scale.follow(pulled(newtons), sheet());
        // Twice the root mean square, and never more than the next round number, which is at most 2.5 times as much.
        CHECK(scale.newtons() >= 2.0 * newtons * 0.99);
        CHECK(scale.newtons() <= 2.5 * 2.0 * newtons);
        CHECK(rounded_up(scale.newtons()) == Approx(scale.newtons()));
    }
}

TEST_CASE("the scale does not flicker where forces waver, around a round number or widely") {
    ForceScale scale;
    scale.follow(pulled(1.1), sheet());
    const double shown = scale.newtons();
    for (int batch = 0; batch < 600; ++batch) {
        scale.follow(pulled(batch % 3 == 0 ? 1.1 : batch % 3 == 1 ? 0.9 : 0.01), sheet());
        REQUIRE(scale.newtons() == shown);
    }
}

TEST_CASE("the scale comes down once the forces are gone for good, and stays down") {
    ForceScale scale;
    scale.follow(pulled(40.0), sheet());
    double before = scale.newtons();
    int changes = 0;
    for (int batch = 0; batch < 600; ++batch) {
        scale.follow(pulled(0.4), sheet());
        REQUIRE(scale.newtons() <= before);
        changes += scale.newtons() < before;
        before = scale.newtons();
    }
    CHECK(before >= 2.0 * 0.4 * 0.99);
    CHECK(before <= 5.0);
    CHECK(changes <= 7);  // of the round numbers from 100 to 1
}

TEST_CASE("a moment that is no number leaves the scale as it is") {
    ForceScale scale;
    scale.follow(pulled(3.0), sheet());
    const double shown = scale.newtons();
    Snapshot broken = pulled(3.0);
    broken.x[3] = std::numeric_limits<float>::quiet_NaN();
    scale.follow(broken, sheet());
    CHECK(scale.newtons() == shown);
}

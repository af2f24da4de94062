// The stretch that cloth is coloured by, and the velocities that are drawn: of cloths whose answer is known.
#include "catch.hpp"

#include "viewer/batch_track.hpp"
#include "viewer/stretch.hpp"
#include "viewer/velocity_lines.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace drapeau;

namespace {

constexpr float cell = 0.1f;
const SpringKinds square{{cell, 1.0f}, {cell, 1.0f}, {}};

/// Pulled so many times as long along the fly and along the hoist.
FieldBuffer<float> pulled(int columns, int rows, double along, double down) {
    FieldBuffer<float> position(columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            position.set(column, row, {double(cell) * along * column, -double(cell) * down * row, 0.0});
    return position;
}

}  // namespace

TEST_CASE("stretch at a mass is that of the direction that is pulled most, inside and at borders") {
    for (const auto& [along, down, expected] :
         {std::tuple{1.0, 1.0, 0.0}, {1.05, 1.0, 0.05}, {0.9, 1.02, 0.02}, {0.9, 0.97, -0.03}}) {
        CAPTURE(along, down);
        const auto position = pulled(5, 4, along, down);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 5; ++column)
                CHECK(stretch_at(position, square, column, row) == Approx(expected).margin(1e-6));
    }
}

TEST_CASE("shear stretches a diagonal alone, and is seen where there are diagonal springs") {
    FieldBuffer<float> position(3, 3);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            position.set(column, row, {double(cell) * (column + 0.1 * row), -double(cell) * row, 0.0});
    SpringKinds kinds = square;
    const double tilted = std::hypot(1.0, 0.1) - 1.0;  // of springs along the hoist
    CHECK(stretch_at(position, kinds, 1, 1) == Approx(tilted).margin(1e-6));
    kinds.diagonal = {cell * std::sqrt(2.0f), 1.0f};
    const double longer = std::hypot(1.1, 1.0) / std::sqrt(2.0) - 1.0;
    CHECK(stretch_at(position, kinds, 1, 1) == Approx(longer).margin(1e-6));
}

TEST_CASE("stretch at a mass is the mean of its two sides") {
    auto position = pulled(3, 1, 1.0, 1.0);
    position.set(2, 0, {2.2 * double(cell), 0.0, 0.0});
    const SpringKinds chain{{cell, 1.0f}, {}, {}};
    CHECK(stretch_at(position, chain, 0, 0) == Approx(0.0).margin(1e-6));
    CHECK(stretch_at(position, chain, 1, 0) == Approx(0.1).margin(1e-6));
    CHECK(stretch_at(position, chain, 2, 0) == Approx(0.2).margin(1e-6));
}

TEST_CASE("the usual stretch leaves one mass in twenty out, of large cloths too") {
    for (const int columns : {40, 400}) {
        CAPTURE(columns);
        // Of each row's columns the last fortieth is pulled to twice its length.
        auto position = pulled(columns, 20, 1.01, 1.0);
        const int taut = columns / 40;
        for (int row = 0; row < 20; ++row)
            for (int n = 0; n < taut; ++n)
                position.set(columns - taut + n, row,
                             position.at(columns - 1 - taut, row) + glm::dvec3(0.2 * (n + 1), 0.0, 0.0));
        CHECK(usual_stretch(position, square) == Approx(0.01).epsilon(0.01));
        StretchScale scale;
        scale.follow(position, square);
        CHECK(scale.share() == Approx(0.02));  // the round number above, but for rounding of positions
    }
}

TEST_CASE("the longest line of velocities stands for little more than the usual speed, once others are slower") {
    SpeedScale scale;
    FieldBuffer<float> velocity(1, 1);
    for (const double speed : {40.0, 9.0}) {  // of the only mass
        velocity.set(0, 0, {0.0, speed, 0.0});
        for (int moment = 0; moment < 200; ++moment) scale.follow(velocity);
        CHECK(scale.end() >= speed);
        CHECK(scale.end() <= 2.5 * speed / 0.95);
    }
    CHECK(scale.end() == Approx(10.0));
}

TEST_CASE("a snapshot's velocities are the run's own, and those of a kept moment are of that moment") {
    Scene scene;
    scene.flag.columns = 5, scene.flag.rows = 4;
    scene.flag.attach = Attach::none;
    scene.gravity().emplace();
    Simulation run(scene);
    const auto falls = [](const Snapshot& snapshot, double time) {
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 5; ++column) {
                const glm::dvec3 v = snapshot.velocity.at(column, row);
                CHECK(v.y == Approx(-9.81 * time).epsilon(1e-2));  // rounding of places shakes the springs
                CHECK(std::abs(v.x) + std::abs(v.z) < 1e-2);
            }
    };
    run.advance_batch();
    const auto kept = run.keep();
    for (int batch = 0; batch < 9; ++batch) run.advance_batch();
    Snapshot now, then;
    run.snapshot(now);
    CHECK(now.velocity.columns() == 0);  // what is not asked for is not copied
    run.velocity(now);
    kept->velocity(then);
    falls(now, run.time());
    falls(then, kept->time());

    // A film's frame lies between two batches.
    Simulation flight(scene);
    BatchTrack track(flight);
    const std::atomic<bool> goes_on{false};
    Snapshot frame;
    track.follow(2.4 * batch_seconds, frame, goes_on);
    CHECK(frame.time == Approx(2.4 * batch_seconds));
    falls(frame, frame.time);
}

TEST_CASE("velocities are lines along them, as long as they are fast, and few on fine grids") {
    Snapshot snapshot;
    snapshot.position = pulled(100, 60, 1.0, 1.0);
    CHECK(velocity_lines(snapshot, {cell, cell}, 1.0, 1.0).empty());  // none are known
    snapshot.velocity = FieldBuffer<float>(100, 60);
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 100; ++column) snapshot.velocity.set(column, row, {0.0, 0.0, 0.02 * column});
    CHECK(usual_speed(snapshot.velocity) == Approx(0.95 * 1.98).epsilon(0.03));

    const auto lines = velocity_lines(snapshot, {cell, cell}, 2.0, 0.5);
    CHECK(lines.size() < 20 * 13);
    CHECK(lines.size() > 14 * 8);
    float rightmost = 0.0f;
    for (const Streak& line : lines) {
        const float column = line.from.x / cell;
        CHECK(line.to.z - line.from.z == Approx(0.02f * column * 0.25f).margin(1e-4));
        CHECK(line.to.x == line.from.x);
        rightmost = std::max(rightmost, column);
    }
    CHECK(rightmost == Approx(99.0f).margin(1e-3));  // the end that moves most has its lines

    for (const Streak& line : velocity_lines(snapshot, {cell, cell}, 0.1, 0.5))
        CHECK(line.to.z - line.from.z < 1.5001f);
}

// Pacer: simulated time follows the wall clock, and what could not be asked for is never caught up.
#include "catch.hpp"

#include "drapeau/stability.hpp"
#include "viewer/pacer.hpp"

using namespace drapeau;

TEST_CASE("the pace asks for what the wall clock owes, at any frame rate") {
    for (const double frames_per_second : {7.0, 24.0, 60.0, 144.0, 1000.0}) {
        CAPTURE(frames_per_second);
        Pacer pace;
        constexpr int seconds = 10;
        int asked = 0;
        for (int frame = 0; frame < int(seconds * frames_per_second); ++frame) {
            asked += pace.batches(1.0 / frames_per_second, 0);
            // Never ahead of the clock, and at most one batch and one rounding of it behind.
            const double owed = (frame + 1) / frames_per_second / batch_seconds;
            CHECK(asked <= owed + 1e-6);
            CHECK(asked > owed - 1.0 - 1e-6);
        }
    }
}

TEST_CASE("a frame as long as a batch asks for one, every time") {
    Pacer pace;
    for (int frame = 0; frame < 1000; ++frame) REQUIRE(pace.batches(batch_seconds * (1.0 + 1e-12), 0) == 1);
}

TEST_CASE("what a busy simulation could not be asked for is not caught up") {
    Pacer pace;
    for (int frame = 0; frame < 100; ++frame) CHECK(pace.batches(batch_seconds, 3) == 0);
    // At most the batch that was owed in between, besides the one now due.
    CHECK(pace.batches(batch_seconds, 0) <= 2);
    CHECK(pace.batches(0.0, 0) == 0);
}

TEST_CASE("a slow frame asks for no more than a quarter of a second, and the rest is dropped") {
    Pacer pace;
    CHECK(pace.batches(3600.0, 0) == 15);
    CHECK(pace.batches(0.0, 0) <= 1);
    CHECK(pace.batches(0.0, 0) == 0);
}

TEST_CASE("the real-time factor is simulated over wall-clock seconds, unknown at first and after a pause") {
    for (const double factor : {0.1, 1.0, 2.5}) {
        CAPTURE(factor);
        Pacer pace;
        double wall = 100.0;
        for (int frame = 0; frame < 300; ++frame) {
            pace.observe(wall, factor * (wall - 100.0));
            if (frame == 1) CHECK(pace.real_time_factor() == 0.0);
            wall += 0.01;
        }
        // Sums of a few hundred hundredths.
        CHECK(pace.real_time_factor() == Approx(factor).epsilon(1e-9));
        CHECK(pace.frame_seconds() == Approx(0.01).epsilon(1e-9));
        pace.forget();
        CHECK(pace.real_time_factor() == 0.0);
    }
}

TEST_CASE("the real-time factor forgets what is a second old, and a run that began anew") {
    Pacer pace;
    double wall = 0.0, simulated = 0.0;
    const auto run = [&](double factor, int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            wall += 0.01;
            simulated += 0.01 * factor;
            pace.observe(wall, simulated);
        }
    };
    run(1.0, 200);
    run(0.5, 101);
    CHECK(pace.real_time_factor() == Approx(0.5).epsilon(1e-9));
    simulated = 0.0;
    run(0.25, 1);
    CHECK(pace.real_time_factor() == 0.0);
    run(0.25, 30);
    CHECK(pace.real_time_factor() == Approx(0.25).epsilon(1e-9));
}

// Slow motion: pictures lie on straight lines between the run's own, evenly in time; none is ahead of the run.
#include "catch.hpp"

#include "viewer/pacer.hpp"
#include "viewer/playback.hpp"
#include "viewer/slow_motion.hpp"

using namespace drapeau;

namespace {

/// Every mass at `x` m, at `time` s.
Snapshot at(double x, double time, int columns = 3) {
    Snapshot snapshot{.position = FieldBuffer<float>(columns, 2), .velocity = {}, .time = time, .steps = 0};
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < columns; ++i) snapshot.position.set(i, j, {x, 0.0, 0.0});
    return snapshot;
}

double shown(const SlowMotion& slow) {
    Snapshot snapshot;
    slow.show(snapshot);
    return snapshot.position.at(1, 1).x;
}

}  // namespace

TEST_CASE("a picture between two moments shows every mass at its share of the way") {
    Snapshot between;
    interpolate(at(1.0, 10.0), at(3.0, 20.0), 0.25, between);
    CHECK(between.time == 12.5);
    CHECK(between.position.at(2, 1).x == Approx(1.5));
    interpolate(at(1.0, 10.0), at(3.0, 20.0, 5), 0.25, between);  // no way leads from one grid to another
    CHECK(between.position.columns() == 5);
    CHECK(between.time == 20.0);
}

TEST_CASE("slow motion moves evenly through the moments that come and waits at the newest") {
    SlowMotion slow;
    CHECK(slow.wants(0.1));
    for (const double time : {0.0, 1.0, 2.0}) slow.add(at(10.0 * time, time));
    CHECK(!slow.wants(0.1));
    for (int n = 1; n <= 19; ++n) {
        slow.pass(0.1);
        CHECK(shown(slow) == Approx(double(n)));
    }
    CHECK(slow.wants(0.2));
    slow.pass(5.0);
    CHECK(shown(slow) == Approx(20.0));
    slow.add(at(40.0, 4.0));
    slow.pass(1.0);
    CHECK(shown(slow) == Approx(30.0));
    slow.add(at(7.0, 0.5));  // a run that began anew
    CHECK(shown(slow) == Approx(7.0));
}

TEST_CASE("a faster speed may have more batches under way, and ends of the ladder hold") {
    Pacer pace;
    CHECK(pace.batches(4.0 / 60.0, 4) == 0);
    CHECK(pace.batches(4.0 / 60.0, 4, 4.0) >= 4);
    Playback play;
    CHECK(play.speed().factor == 1.0);
    play.faster(100);
    CHECK(play.speed().factor == 4.0);
    play.faster(-100);
    CHECK(play.speed().factor == 0.01);
}

// OwnWork: what a frame costs the window itself.
#include "catch.hpp"

#include "viewer/own_work.hpp"

using namespace drapeau;

namespace {

double now = 0.0;  // s

/// A frame that works twice, `each` s long, and waits for the driver in between and afterwards.
void pass_frame(OwnWork& work, double each) {
    for (int stretch = 0; stretch < 2; ++stretch) {
        work.begin();
        now += each;
        work.pause();
        now += 10.0;
    }
    work.end_frame();
}

}  // namespace

TEST_CASE("the window's own work is what passes between begin and pause, a frame") {
    OwnWork work([] { return now; });
    CHECK(work.seconds() == 0.0);
    pass_frame(work, 3.0);  // the first makes what the others use
    CHECK(work.seconds() == 0.0);
    pass_frame(work, 0.002);
    CHECK(work.seconds() == Approx(0.004));
    pass_frame(work, 0.004);
    CHECK(work.seconds() == Approx(0.006));
}

TEST_CASE("the window's own work follows a change within some twenty frames, and one slow frame does not hide it") {
    OwnWork work([] { return now; });
    for (int frame = 0; frame < 200; ++frame) pass_frame(work, 0.001);
    pass_frame(work, 0.011);  // 20 ms more
    CHECK(work.seconds() < 0.0031);
    for (int frame = 0; frame < 100; ++frame) pass_frame(work, 0.003);
    CHECK(work.seconds() == Approx(0.006).epsilon(0.02));  // 0.95^100 = 0.006 of the difference is left
}

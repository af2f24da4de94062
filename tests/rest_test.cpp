// Rest: frames follow each other while something changes, and only then.
#include "catch.hpp"

#include "viewer/rest.hpp"

using namespace drapeau;

namespace {

/// Frames drawn after one with this activity before the loop waits.
int frames_after(const Activity& activity) {
    Rest rest;
    int frames = 0;
    for (double wait = rest.seconds(activity); wait == 0.0; wait = rest.seconds({})) ++frames;
    return frames;
}

}  // namespace

TEST_CASE("a window in which nothing changes waits") {
    Rest rest;
    CHECK(rest.seconds({}) >= 10.0);
    CHECK(rest.seconds({}) >= 10.0);
}

TEST_CASE("whatever happens is followed by the frames it takes to be seen, then the loop waits again") {
    for (const Activity& activity : {Activity{.events = true}, Activity{.simulation = true}, Activity{.runs = true}})
        CHECK(frames_after(activity) == 4);
}

TEST_CASE("a run that is seen never waits, one that nobody sees goes on without pictures") {
    Rest rest;
    for (int frame = 0; frame < 100; ++frame) CHECK(rest.seconds({.runs = true}) == 0.0);
    const double hidden = rest.seconds({.runs = true, .hidden = true});
    CHECK(hidden > 0.05);
    CHECK(hidden <= 0.25);  // a longer pause would not be caught up
    CHECK(frames_after({.hidden = true}) == 0);
}

TEST_CASE("a message that goes by itself ends the wait, and a text cursor blinks on") {
    Rest rest;
    const double wait = rest.seconds({.message_left = 0.3});
    CHECK(wait > 0.3);
    CHECK(wait < 0.35);
    CHECK(rest.seconds({.message_left = 5.0}) < 5.1);
    CHECK(rest.seconds({.typing = true}) == 0.0);  // the window without the message is drawn
    Rest other;
    CHECK(other.seconds({.typing = true}) > 0.0);
    CHECK(other.seconds({.typing = true}) < 0.3);
}

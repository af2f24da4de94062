// What a frame shows of every mass, and what it says of its own cost.
#include "app.hpp"
#include "pixels.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <regex>
#include <string>

using namespace drapeau::window_tests;

TEST_CASE_METHOD(StillFlag, "every mass is a dot of its own") {
    app.set("Texture", false);
    const Box flag = app.settle().box("flag");
    const Box around{flag.x0 - 15, flag.y0 - 15, flag.x1 + 15, flag.y1 + 15};
    const drapeau::Image without = app.picture();
    app.set("Masses", true);
    const drapeau::Image with = app.picture();

    Mask beside = changed(without, with, around);
    for (char& pixel : beside.set) pixel = !pixel;
    CHECK(enclosed_pieces(beside, 80) == 4 * 3);  // of about 150 pixels each

    app.set("Masses", false);
    CHECK(changed(without, app.picture(), around).count() == 0);
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag, "beside the time of a frame stands what the window itself takes of it") {
    const Look look = app.wait_until("a measurement", [](const Look& now) { return now.number("own_ms") > 0.0; });
    CHECK(look.number("own_ms") < 1000.0);
    const std::string said = look.controls.at("Reading: Frame").value;
    CHECK(std::regex_match(said, std::regex(R"(\S+ \S*s,  own [0-9.]+ ms)")));
    app.check_healthy();
}

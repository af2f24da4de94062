// What the desktop brings along: text of another size, small windows, names in any script, a window manager that died,
// windows that nobody sees.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <thread>

using namespace drapeau::window_tests;

TEST_CASE("a window manager that died is no reason to fail, least of all for a picture") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene), picture = folder / "picture.png";
    screen.leave_dead_window_manager();
    const Finished done =
        run({program(), scene, "--frames", "1", "--size", "320x240", "--screenshot", picture}, screen.surroundings());
    CAPTURE(done.errors);
    CHECK(done.status == 0);
    CHECK(done.errors.empty());
    CHECK(drapeau::load_image(picture).width == 320);

    screen.leave_dead_window_manager();
    App app(screen, {scene});
    app.check_healthy();
}

TEST_CASE("a paused window draws no frames until something happens") {
    const Screen screen;
    App app(screen, {"report", "--size", "900x640"});
    const auto rests = [](const Look& look) { return look.text("resting") == "1"; };
    CHECK(app.settle().text("resting") == "0");
    app.press("space");
    const Look paused = app.wait_until("its rest", rests);
    std::this_thread::sleep_for(Seconds(1.0));
    CHECK(app.look().number("frame") == paused.number("frame"));

    app.press("period");
    app.wait_until("a step", [&](const Look& look) { return look.number("steps") == paused.number("steps") + 1; });
    app.press("s");
    CHECK(app.look().controls.at("Springs").value == "1");
    app.wait_until("its rest", rests);

    // A message that goes by itself goes from a window at rest.
    app.press("p");
    app.wait_until("a message", [](const Look& look) { return look.text("message").starts_with("Saved"); });
    app.wait_until("it to be gone", [](const Look& look) { return look.text("message").empty(); });

    const Look before = app.wait_until("its rest", rests);
    app.press("space");
    app.wait_until("time to pass", [&](const Look& look) { return look.number("time") > before.number("time"); });
    app.check_healthy();
}

TEST_CASE("a window that nobody sees goes on with the run and draws next to nothing") {
    const Screen screen;
    App app(screen, {"report", "--size", "900x640"});
    app.settle();
    app.hide();
    const Look hidden = app.wait_until("its rest", [](const Look& look) { return look.text("resting") == "1"; });
    const Look later = app.wait_until(
        "a second of the run", [&](const Look& look) { return look.number("time") > hidden.number("time") + 1.0; });
    // Sixty are drawn where it is seen.
    CHECK(later.number("frame") - hidden.number("frame") < 30);
}

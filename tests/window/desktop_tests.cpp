// What the desktop brings along: text of another size, small windows, names in any script, a window manager that died,
// windows that nobody sees.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

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

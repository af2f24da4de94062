// Layout: the panel and the flag share the window, and neither covers the other at any size.
#include "catch.hpp"

#include "viewer/layout.hpp"

using namespace drapeau;

namespace {

AppState laid_out(float width, float height, float scale, bool opened) {
    AppState app;
    app.panel_opened = opened;
    lay_out(app, width, height, scale);
    return app;
}

}  // namespace

TEST_CASE("the panel never covers the view, nor half of a window that has room for it") {
    for (const float scale : {1.0f, 2.0f, 3.0f})
        for (const float width : {200.0f, 480.0f, 584.0f, 640.0f, 1280.0f, 3840.0f})
            for (const bool opened : {false, true}) {
                CAPTURE(scale, width, opened);
                const AppState app = laid_out(width, 0.75f * width, scale, opened);
                const Area &panel = app.panel_area, &view = app.view_area;
                CHECK(view.x1 == width);
                CHECK(panel.x1 <= view.x0);
                CHECK(view.width() >= (app.narrow ? 0.35f : 0.5f) * width);
                CHECK((panel.width() > 0.0f) == app.panel_open());
            }
}

TEST_CASE("in a narrow window the panel steps aside until it is opened, whatever it was in a wide one") {
    AppState app;
    for (const float width : {480.0f, 1280.0f, 480.0f}) {
        lay_out(app, width, 360.0f, 1.0f);
        CHECK(app.narrow == (width < 500.0f));
        CHECK(app.panel_open() == !app.narrow);
    }
    app.toggle_panel();
    lay_out(app, 480.0f, 360.0f, 1.0f);
    CHECK(app.panel_area.width() > 0.5f * 480.0f);
    app.toggle_panel();
    lay_out(app, 1280.0f, 800.0f, 1.0f);
    CHECK(app.panel_area.width() == 384.0f);
    app.toggle_panel();
    lay_out(app, 1280.0f, 800.0f, 1.0f);
    CHECK(!app.panel_open());
    CHECK(app.view_area.x0 == 0.0f);
}

TEST_CASE("a window that grows with its text is laid out alike") {
    const AppState usual = laid_out(1280.0f, 800.0f, 1.0f, false), large = laid_out(3840.0f, 2400.0f, 3.0f, false);
    CHECK(large.panel_area.x1 == 3.0f * usual.panel_area.x1);
    CHECK(laid_out(1280.0f, 1024.0f, 3.0f, false).narrow);
}

// Controls: what mouse and keys do, and that a drag which begins on a panel stays with the panel.
#include "catch.hpp"

#include "viewer/controls.hpp"

using namespace drapeau;

namespace {

using Kind = InputEvent::Kind;

struct Desk {
    AppState app;
    Camera camera;
    Controls controls;
    Framing framing;
    Claims claims;

    Desk() {
        app.view_area = {0.0f, 0.0f, 800.0f, 600.0f};
        app.claimed = {{0.0f, 0.0f, 100.0f, 600.0f}};
    }
    void happen(const std::vector<InputEvent>& events) { controls.apply(events, claims, framing, app, camera); }
    void key(Key key) { happen({{.kind = Kind::key, .key = key}}); }
    /// A letter, as its key gives it.
    void type(char letter, bool control = false) {
        happen({{.kind = Kind::key, .control = control, .letter = letter}});
    }
    /// A key that stands for `letter` and types `typed`.
    void type(char letter, char32_t typed) {
        happen({{.kind = Kind::key, .letter = letter}, {.kind = Kind::character, .typed = typed}});
    }
    void drag(glm::vec2 from, glm::vec2 to, MouseButton button, double time = 0.0) {
        happen({{.kind = Kind::press, .button = button, .time = time, .at = from},
                {.kind = Kind::move, .at = to},
                {.kind = Kind::release, .button = button, .at = to},
                {.kind = Kind::move, .at = from}});
    }
};

Question question_about(const std::string& file) {
    return question_before_overwriting("Overwrite it?", [file](AppState& app) { app.commands.overwrite = file; });
}

}  // namespace

TEST_CASE("a left drag turns by its whole length, a right one slides, and neither goes on after the button is up") {
    Desk turned, slid;
    turned.drag({400.0f, 300.0f}, {440.0f, 310.0f}, MouseButton::left);
    Camera expected;
    expected.turn({40.0f, 10.0f});
    CHECK(turned.camera.azimuth == expected.azimuth);
    CHECK(turned.camera.elevation == expected.elevation);
    CHECK(turned.camera.pan == glm::vec3(0.0f));

    slid.drag({400.0f, 300.0f}, {440.0f, 310.0f}, MouseButton::right);
    expected = {};
    expected.slide({40.0f, 10.0f}, slid.framing, slid.app.view_area);
    CHECK(slid.camera.pan == expected.pan);
    CHECK(slid.camera.pan != glm::vec3(0.0f));
    CHECK(slid.camera.azimuth == Camera::default_azimuth);
}

TEST_CASE("a drag or a wheel on a panel does not reach the flag, one that ends there does") {
    Desk desk;
    desk.drag({50.0f, 300.0f}, {400.0f, 300.0f}, MouseButton::left);
    desk.happen({{.kind = Kind::scroll, .at = {50.0f, 300.0f}, .amount = 3.0f}});
    CHECK(desk.camera.azimuth == Camera::default_azimuth);
    CHECK(desk.camera.zoom == 1.0f);

    desk.claims.mouse = true;
    desk.drag({300.0f, 300.0f}, {400.0f, 300.0f}, MouseButton::left);
    CHECK(desk.camera.azimuth == Camera::default_azimuth);

    desk.claims.mouse = false;
    desk.drag({400.0f, 300.0f}, {50.0f, 300.0f}, MouseButton::left);
    CHECK(desk.camera.azimuth != Camera::default_azimuth);
}

TEST_CASE("two clicks close in time and place reset the camera, others do not") {
    const auto reset_after = [](double seconds, glm::vec2 second) {
        Desk desk;
        desk.drag({400.0f, 300.0f}, {400.0f, 300.0f}, MouseButton::left, 1.0);
        CHECK(!desk.app.commands.reset_camera);
        desk.drag(second, second, MouseButton::left, 1.0 + seconds);
        return desk.app.commands.reset_camera;
    };
    CHECK(reset_after(0.2, {401.0f, 300.0f}));
    CHECK(!reset_after(1.0, {401.0f, 300.0f}));
    CHECK(!reset_after(0.2, {450.0f, 300.0f}));
}

TEST_CASE("every key does one thing, and pressed again undoes it where it is a switch") {
    Desk desk;
    const AppState before = desk.app;
    ViewSettings& view = desk.app.scene.view;
    const auto switches = [&](char key, bool& value) {
        CAPTURE(key);
        const bool was = value;
        desk.type(key);
        CHECK(value == !was);
        desk.type(key);
        CHECK(value == was);
    };
    switches('t', view.texture);
    switches('s', view.springs);
    switches('f', view.forces);
    switches('m', view.masses);
    switches('e', view.stretch);
    switches('v', view.velocities);
    switches('c', view.cloth);
    switches('w', view.wind);
    switches('a', desk.app.orbits);
    switches('o', desk.app.scenes_shown);
    switches('h', desk.app.panel_shown);
    CHECK(desk.app.scene == before.scene);

    desk.key(Key::space);
    CHECK(desk.app.paused);
    desk.type('r');
    CHECK(desk.app.commands.restart);
    desk.type('\0', U'.');
    CHECK(desk.app.commands.step);
    desk.type('p');
    CHECK(desk.app.commands.screenshot);
    desk.key(Key::home);
    CHECK(desk.app.commands.reset_camera);
    desk.type('q');
    CHECK(!desk.app.quits);
    desk.type('q', true);
    CHECK(desk.app.quits);
}

TEST_CASE("a symbol acts whichever key types it, and never together with the key's letter or name") {
    Desk desk;
    desk.type('\0', U'+');
    const float once = desk.camera.zoom;
    CHECK(once > 1.0f);
    desk.camera.zoom = 1.0f;
    desk.happen({{.kind = Kind::key, .key = Key::keypad_add}, {.kind = Kind::character, .typed = U'+'}});
    CHECK(desk.camera.zoom == once);
    desk.happen({{.kind = Kind::character, .typed = U'-'}});  // alone: from an input method
    CHECK(desk.camera.zoom == Approx(1.0f));

    // On a layout without Latin letters a letter's key types something else: a symbol comes first.
    desk.type('t', U'א');
    CHECK(!desk.app.scene.view.texture);
    desk.type('s', U'.');
    CHECK(desk.app.commands.step);
    CHECK(!desk.app.scene.view.springs);

    desk.app.commands = {};
    desk.happen({{.kind = Kind::key, .key = Key::keypad_decimal}, {.kind = Kind::character, .typed = U','}});
    CHECK(desk.app.commands.step);
}

TEST_CASE("what is held with Alt or Super is the desktop's, and letting a key go does nothing") {
    Desk desk;
    const Scene before = desk.app.scene;
    desk.happen({{.kind = Kind::key, .desktop = true, .letter = 's'}, {.kind = Kind::key_up, .letter = 's'}});
    CHECK(desk.app.scene == before);
}

TEST_CASE("diagonal springs come back as stiff as they were") {
    Desk desk;
    desk.app.scene.springs->diagonal_stiffness = 12.5;
    desk.type('d');
    CHECK(!desk.app.scene.springs->diagonal_stiffness);
    desk.type('d');
    CHECK(desk.app.scene.springs->diagonal_stiffness == 12.5);
}

TEST_CASE("keys are text while a text is typed, and shortcuts with control do nothing else") {
    Desk desk;
    desk.claims.keyboard = true;
    desk.type('r');
    desk.key(Key::space);
    CHECK(!desk.app.commands.restart);
    CHECK(!desk.app.paused);
    desk.claims.keyboard = false;
    desk.type('r', true);
    CHECK(!desk.app.commands.restart);
}

TEST_CASE("Escape closes a question first, then the list of keys, then the message") {
    Desk desk;
    say(desk.app, Message::Cause::image, "anything", true);
    desk.key(Key::f1);
    CHECK(desk.app.help_shown);
    desk.app.question = question_about("/tmp/a.toml");
    desk.key(Key::escape);
    CHECK(!desk.app.question);
    CHECK(!desk.app.commands.overwrite);
    CHECK(desk.app.help_shown);
    desk.key(Key::escape);
    CHECK(!desk.app.help_shown);
    CHECK(desk.app.message.text == "anything");
    desk.key(Key::escape);
    CHECK(desk.app.message.text.empty());
}

TEST_CASE("Enter agrees to what is asked, and does nothing where nothing is") {
    Desk desk;
    desk.key(Key::enter);
    CHECK(!desk.app.commands.overwrite);
    desk.app.question = question_about("/tmp/a.toml");
    desk.claims.keyboard = true;  // a text is typed
    desk.key(Key::enter);
    CHECK(!desk.app.commands.overwrite);
    desk.claims.keyboard = false;
    desk.key(Key::enter);
    CHECK(desk.app.commands.overwrite == "/tmp/a.toml");
    CHECK(!desk.app.question);
}

TEST_CASE("quitting asks first while a film is being made") {
    Desk desk;
    desk.app.film.under_way = true;
    desk.type('q', true);
    CHECK(!desk.app.quits);
    REQUIRE(desk.app.question);
    desk.key(Key::escape);
    CHECK(!desk.app.quits);
    desk.type('q', true);
    desk.key(Key::enter);
    CHECK(desk.app.quits);
}

TEST_CASE("a dropped scene file is a scene, any other an image") {
    Desk desk;
    desk.happen({{.kind = Kind::drop, .file = "/tmp/a flag.toml"}, {.kind = Kind::drop, .file = "/tmp/flag.png"}});
    CHECK(desk.app.commands.load_scene == "/tmp/a flag.toml");
    CHECK(desk.app.commands.load_texture == "/tmp/flag.png");
    // As some programs drop it.
    for (const std::string scene : {"file:///tmp/a%20flag.toml\r\n", "/tmp/FLAG.TOML", "'/tmp/a flag.toml'"}) {
        Desk other;
        other.happen({{.kind = Kind::drop, .file = scene}});
        CHECK(other.app.commands.load_scene == scene);
        CHECK(!other.app.commands.load_texture);
    }
}

TEST_CASE("a shift drag is a hand on the cloth until the button is up, another is pressed, or Escape") {
    const auto press = [](MouseButton button, bool shift, glm::vec2 at) {
        return InputEvent{.kind = InputEvent::Kind::press, .button = button, .shift = shift, .at = at};
    };
    const auto begun = [&] {
        Desk desk;
        desk.happen({press(MouseButton::left, true, {400.0f, 300.0f}), {.kind = Kind::move, .at = {450.0f, 250.0f}}});
        CHECK(desk.app.hand.is_busy());
        CHECK(desk.camera.azimuth == Camera::default_azimuth);
        return desk;
    };
    Desk up = begun();
    up.happen({{.kind = Kind::release, .button = MouseButton::left, .at = {-50.0f, 900.0f}}});  // beside the window
    CHECK_FALSE(up.app.hand.is_busy());
    CHECK_FALSE(up.app.hand.take_click());
    Desk other = begun();
    other.happen({press(MouseButton::right, false, {50.0f, 300.0f})});  // on the panel
    CHECK_FALSE(other.app.hand.is_busy());
    Desk escaped = begun();
    escaped.app.help_shown = true;
    escaped.key(Key::escape);
    CHECK_FALSE(escaped.app.hand.is_busy());
    CHECK(escaped.app.help_shown);
    Desk panel;
    panel.happen({press(MouseButton::left, true, {50.0f, 300.0f})});
    CHECK_FALSE(panel.app.hand.is_busy());
}

TEST_CASE("two presses are a double click within 0.4 s, less what the second waited while a frame was drawn") {
    const auto reset_by = [](double apart, double waited) {
        Desk desk;
        desk.drag({400.0f, 300.0f}, {400.0f, 300.0f}, MouseButton::left, 1.0);
        desk.happen({{.kind = Kind::press,
                      .button = MouseButton::left,
                      .time = 1.0 + apart,
                      .waited = waited,
                      .at = {400.0f, 300.0f}}});
        return desk.app.commands.reset_camera;
    };
    CHECK(reset_by(0.39, 0.0));
    CHECK_FALSE(reset_by(0.41, 0.0));
    CHECK(reset_by(0.9, 0.55));
    CHECK_FALSE(reset_by(0.9, 0.45));
}

TEST_CASE("a click is a press and a release in one place, once, and no part of a drag or a double click") {
    Desk desk;
    desk.happen({{.kind = Kind::press, .button = MouseButton::left, .time = 1.0, .at = {400.0f, 300.0f}},
                 {.kind = Kind::move, .at = {401.0f, 302.0f}},
                 {.kind = Kind::release, .button = MouseButton::left, .at = {401.0f, 302.0f}}});
    CHECK(desk.app.hand.take_click());
    CHECK_FALSE(desk.app.hand.take_click());
    desk.drag({401.0f, 302.0f}, {401.0f, 302.0f}, MouseButton::left, 1.2);
    CHECK_FALSE(desk.app.hand.take_click());
    // Away and back is a drag all the same.
    desk.happen({{.kind = Kind::press, .button = MouseButton::left, .time = 5.0, .at = {400.0f, 300.0f}},
                 {.kind = Kind::move, .at = {440.0f, 300.0f}},
                 {.kind = Kind::move, .at = {400.0f, 300.0f}},
                 {.kind = Kind::release, .button = MouseButton::left, .at = {400.0f, 300.0f}}});
    CHECK_FALSE(desk.app.hand.take_click());
    desk.drag({400.0f, 300.0f}, {400.0f, 300.0f}, MouseButton::right, 9.0);
    CHECK_FALSE(desk.app.hand.take_click());
}

TEST_CASE("U and L haul the flag from mark to mark between the pole's foot and its top") {
    Desk desk;
    auto& halyard = desk.app.scene.flag.halyard;
    desk.type('u');
    CHECK_FALSE(halyard);  // it is at the top, and nothing is to haul it
    desk.type('l');
    CHECK(*halyard == Approx(0.95));
    halyard = 0.52;
    desk.type('l');
    CHECK(*halyard == Approx(0.45));
    for (int n = 0; n < 40; ++n) desk.type('u');
    CHECK(*halyard == 1.0);
    for (int n = 0; n < 40; ++n) desk.type('l');
    CHECK(*halyard == 0.0);
    Desk free;
    free.app.scene.flag.attach = Attach::none;
    free.type('l');
    CHECK_FALSE(free.app.scene.flag.halyard);
}

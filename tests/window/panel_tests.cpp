// What the panel's controls set, and what becomes of input that is wrong.
#include "app.hpp"
#include "pixels.hpp"
#include "still_flag.hpp"

#include "catch.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

using namespace drapeau::window_tests;

namespace {

struct SettingsOfStillFlag : StillFlag {
    /// The flag below the message box.
    Box clear_of_messages() {
        const Box flag = app.settle().box("flag");
        return {flag.x0, flag.y0 + 0.3 * flag.height(), flag.x1, flag.y1};
    }
};

std::string flag_file(const std::string& name) {
    return std::string(DRAPEAU_ASSETS) + "/flags/" + name;
}

/// Opens the list `label`, takes `entry` of it and waits until it is chosen.
void choose(App& app, const std::string& label, const std::string& entry) {
    app.click(label);
    app.wait_until("the list", [&](const Look& look) { return look.has(label + ": " + entry); });
    app.settle();
    app.click(label + ": " + entry);
    app.wait_until("the choice",
                   [&](const Look& look) { return look.has(label) && look.controls.at(label).value == entry; });
}

/// The label in the UI map that shows that a setting has its control.
template <class Settings, class Value>
std::string sign_of(const std::string& table, const drapeau::settings::Key<Settings, Value>& field) {
    const std::string name = drapeau::settings::full_name(table, field.key), label = field.about.label;
    if (name == "wind.velocity") return "Wind speed";  // as speed and direction
    if (name == "time.dt") return "Step chosen automatically";
    if (std::is_same_v<Value, glm::dvec3>) return label + " across";
    if (std::is_same_v<Value, std::optional<double>> || name == "limit.stretch") return label + " on";
    return label;
}

}  // namespace

TEST_CASE("every setting of a scene has its control") {
    using namespace drapeau::settings;
    const bool of_fabric = GENERATE(false, true);
    drapeau::Scene scene;
    if (of_fabric) {
        scene.springs.reset();
        scene.fabric.emplace();
    }
    scene.drag() = 0.0006;
    scene.wind().emplace();
    scene.gravity().emplace();
    scene.terms.get<drapeau::Air>().emplace();
    scene.terms.get<drapeau::Bending>().emplace();
    scene.limits.get<drapeau::Ground>().emplace();
    scene.limits.get<drapeau::Pole>().emplace();
    scene.flag.columns = 5, scene.flag.rows = 4;
    scene.view.cloth = false;  // only the panel is looked at
    Screen screen;
    TemporaryFolder folder;
    App app(screen, {written(folder, "all.toml", drapeau::write_scene(scene)), "--size", "900x640"});
    app.press("space");
    each_table(scene, [&](const std::string& table, const auto& settings, const auto& keys) {
        if (table == "springs" || table == "fabric") {
            if (!listed(settings)) return;
        } else if (of_fabric || table.empty()) {  // as with springs; the name is the window's title
            return;
        }
        const std::string page = table == "flag"   ? "Flag"
                                 : table == "wind" ? "Wind"
                                 : table == "time" ? "Time"
                                                   : "Springs";
        app.click("Page: " + page);
        app.wait_until("the page", [&](const Look& look) { return look.controls.at("Page: " + page).value == "1"; });
        if (table == "view") app.click("Page: View");
        app.settle();
        app.wheel(app.look().box("panel").at(0.5, 0.5), 30);  // back to its top: what follows only scrolls down
        app.settle();
        each_key(keys, [&](const auto& field) {
            if (table == "view" && field.key == "texture_proportions") app.click("Page: Flag");
            if (table == "view" && field.key == "background") app.click("Page: View");
            app.show(sign_of(table, field));
            CHECK(app.look().has(sign_of(table, field)));
        });
    });
}

TEST_CASE_METHOD(SettingsOfStillFlag, "a broken image gives a message and leaves the flag as it was") {
    const std::string whole = read_text(flag_file("france.png"));
    std::filesystem::create_directory(folder / "folder.png");
    const std::vector<std::string> bad{
        folder / "missing.png",
        written(folder, "text.png", "this is no picture"),
        written(folder, "nothing.png", ""),
        written(folder, "half.png", whole.substr(0, whole.size() / 2)),
        folder / "folder.png",
    };
    app.show("Image file");
    const Box box = clear_of_messages();
    const drapeau::Image before = app.picture();
    const std::string texture = app.look().text("texture");
    for (const std::string& broken : bad) {
        CAPTURE(broken);
        app.type("Image file", broken);
        const std::string name = std::filesystem::path(broken).filename().string();
        app.wait_until("a message about " + name,
                       [&name](const Look& look) { return look.text("message").find(name) != std::string::npos; });
        CHECK(app.look().text("texture") == texture);
        CHECK(changed(before, app.picture(), box).count() == 0);
        app.press("Escape");
        app.wait_until("the message to be gone", [](const Look& look) { return look.text("message").empty(); });
    }
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "a broken scene gives a message and leaves the flag as it was") {
    const std::vector<std::string> bad{
        folder / "missing.toml",
        written(folder, "nothing.toml", ""),
        written(folder, "unknown.toml", still_scene + "colour = \"red\"\n"),
        written(folder, "binary.toml", std::string("\0\x7f\xff\0", 4)),
    };
    const Box box = clear_of_messages();
    app.click("Page: Time");
    app.show("Scene file");
    app.wait_until("the page", [](const Look& look) { return look.has("Scene file"); });
    const drapeau::Image before = app.picture();
    for (const std::string& broken : bad) {
        CAPTURE(broken);
        app.type("Scene file", broken);
        const std::string name = std::filesystem::path(broken).filename().string();
        app.wait_until("a message about " + name,
                       [&name](const Look& look) { return look.text("message").find(name) != std::string::npos; });
        const Look look = app.look();
        CHECK(look.text("scene") == "Still");
        CHECK(look.number("columns") == 4);
        CHECK(look.number("rows") == 3);
        CHECK(changed(before, app.picture(), box).count() == 0);
        app.press("Escape");
        app.wait_until("the message to be gone", [](const Look& now) { return now.text("message").empty(); });
    }

    // A good one after all that is taken.
    app.type("Scene file", "drum");
    app.wait_until("the drum", [](const Look& look) { return look.text("scene") == "Drum"; });
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "a path in a field means what it seems to mean") {
    app.click("Page: Time");
    app.show("Save as");
    app.type("Save as", "'~/t1' ");
    app.wait_until("the scene to be saved", [](const Look& look) {
        const std::string& said = look.text("message");
        return said.starts_with("Saved /") && said.ends_with("/t1.toml");
    });
    app.press("Escape");
    for (const std::string name : {"t1", "~/t1", "'t1.toml'", "t1 "}) {
        CAPTURE(name);
        app.show("Scene file");
        app.type("Scene file", "drum");
        app.wait_until("the drum", [](const Look& look) { return look.text("scene") == "Drum"; });
        app.type("Scene file", name);
        app.wait_until("the scene saved", [](const Look& look) { return look.text("scene") == "Still"; });
    }
    app.click("Page: Flag");
    app.show("Image file");
    app.type("Image file", "'japan' ");
    app.wait_until("the image", [](const Look& look) { return look.text("texture").ends_with("japan.png"); });
    app.type("Image file", "japn");
    app.wait_until("a suggestion", [](const Look& look) {
        return look.text("message").find("did you mean japan?") != std::string::npos;
    });
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "an image file lies on the flag the right way up and the right way round") {
    app.show("Image file");
    app.type("Image file", flag_file("test-pattern.png"));
    const Look look = app.wait_until("the test pattern", [](const Look& now) {
        return now.text("texture").find("test-pattern") != std::string::npos;
    });
    const Box flag = look.box("flag");
    const drapeau::Image picture = app.picture();

    // The corner cells are a twelfth by an eighth; between their letters and their lower rim they are one colour.
    const Colour top_hoist = colour_around(picture, flag.at(0.5 / 12, 0.95 / 8 - 0.01), 1);
    const Colour top_fly = colour_around(picture, flag.at(11.5 / 12, 0.95 / 8 - 0.01), 1);
    const Colour bottom_hoist = colour_around(picture, flag.at(0.5 / 12, 7.1 / 8), 1);
    const Colour bottom_fly = colour_around(picture, flag.at(11.5 / 12, 7.1 / 8), 1);
    CHECK(top_hoist.red > std::max(top_hoist.green, top_hoist.blue) + 60);
    CHECK(top_fly.green > std::max(top_fly.red, top_fly.blue) + 40);
    CHECK(bottom_hoist.blue > std::max(bottom_hoist.red, bottom_hoist.green) + 60);
    CHECK(bottom_fly.red > bottom_fly.blue + 60);
    CHECK(bottom_fly.green > bottom_fly.blue + 60);
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag,
                 "the list of images changes the flag, and the flag takes its proportions if wished") {
    app.show("Image");
    app.click("Image");
    app.wait_until("the list", [](const Look& look) { return look.has("Image: germany"); });
    app.click("Image: germany");
    const Look german = app.wait_until(
        "the image", [](const Look& look) { return look.text("texture").find("germany") != std::string::npos; });
    const Box flag = german.box("flag");
    const drapeau::Image picture = app.picture();
    const Colour top = colour_around(picture, flag.at(0.5, 1.0 / 6)),
                 middle = colour_around(picture, flag.at(0.5, 0.5));
    const Colour bottom = colour_around(picture, flag.at(0.5, 5.0 / 6));
    CHECK(std::max({top.red, top.green, top.blue}) < 70);
    CHECK(middle.red > middle.green + 60);
    CHECK(bottom.red > bottom.blue + 60);
    CHECK(bottom.green > bottom.blue + 40);

    // The German flag is 5 to 3 where the scene's is 3 to 2.
    const double before = flag.width() / flag.height();
    app.show("Shaped like its image");
    app.set("Shaped like its image", true);
    app.press("r");
    app.wait_until("a longer flag", [before](const Look& look) {
        const Box now = look.box("flag");
        return now.width() / now.height() > 1.05 * before;
    });
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "dragging a slider sets the grid and does not turn the flag") {
    const Look before = app.settle();
    const Box slider = before.controls.at("Columns").box;
    app.drag(slider.at(0.3, 0.5), before.box("view").at(0.5, 0.5));
    const Look after = app.wait_until("more columns", [](const Look& look) { return look.number("columns") > 50; });
    CHECK(after.text("columns") == after.controls.at("Columns").value);
    CHECK(after.number("rows") == 3);
    CHECK(after.text("azimuth") == before.text("azimuth"));
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "a slider's end in per cent is saved as that share") {
    app.show("Prestretch");
    const Box slider = app.look().controls.at("Prestretch").box;
    app.drag(slider.at(0.1, 0.5), {slider.x1 + 40.0, slider.at(0.1, 0.5).y});
    const Look look = app.wait_until(
        "the end of the slider", [](const Look& now) { return std::stod(now.controls.at("Prestretch").value) > 49.9; });
    CHECK(std::stod(look.controls.at("Prestretch").value) == 50.0);
    app.click("Page: Time");
    app.show("Save as");
    app.type("Save as", folder / "stretched.toml");
    app.wait_until("the file", [&](const Look&) { return std::filesystem::exists(folder / "stretched.toml"); });
    CHECK(read_text(folder / "stretched.toml").find("prestretch = 0.5 ") != std::string::npos);
    app.check_healthy();
}

TEST_CASE_METHOD(SettingsOfStillFlag, "a number may be typed with a decimal comma") {
    app.show("Width");
    app.type_number("Width", "0,75");
    app.wait_until("the width", [](const Look& look) { return look.controls.at("Width").value == "0.75"; });
    app.type_number("Height", "0.25");
    app.wait_until("the height", [](const Look& look) { return look.controls.at("Height").value == "0.25"; });
    app.show("Columns");
    app.type_number("Columns", "12,5");
    const Look whole = app.wait_until("what is said of it", [](const Look& look) {
        return !look.text("message").empty();  // 12 stands there before the comma does
    });
    CHECK(whole.text("message") == "Columns is a whole number: 13 is taken.");
    CHECK(whole.controls.at("Columns").value == "13");
    app.check_healthy();
}

TEST_CASE("choosing forward Euler says how slow it is and what helps, and the flag goes on as it was") {
    const Screen screen;
    App app(screen, without_cloth("report", "900x800"));
    app.click("Page: Time");
    choose(app, "Method", "forward-euler");
    const Look slow = app.wait_until("the remark", [](const Look& look) { return look.has("Reading: Slow"); });
    CHECK(slow.controls.at("Reading: Slow").value.find("slower than real time") != std::string::npos);
    CHECK(slow.controls.at("Reading: Slow").value.find("Semi-implicit-euler") != std::string::npos);
    CHECK(slow.has("Reading: Precision remark"));
    app.check_healthy();
}

TEST_CASE("the clock stops, goes on by steps, and begins anew") {
    const Screen screen;
    App app(screen, without_cloth("report"));
    app.wait_until("time to pass", [](const Look& look) { return look.number("time") > 0.05; });
    app.press("space");
    const Look paused = app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    app.settle();
    const Look still = app.settle();
    CHECK(app.settle().number("time") == still.number("time"));
    CHECK(still.number("time") >= paused.number("time"));

    app.press("period");
    app.wait_until("one step", [&](const Look& look) { return look.number("steps") == still.number("steps") + 1; });

    app.press("r");
    app.wait_until("the start", [&](const Look& look) { return look.number("time") < 0.5 * still.number("time"); });
    app.check_healthy();
}

TEST_CASE("a run that diverges stops on its last good frame and names a step that is safe") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "apart.toml", diverging_scene()), "--size", "900x640"});
    const Look apart =
        app.wait_until("the end of the run", [](const Look& look) { return look.number("diverged") == 1; });
    CHECK(apart.text("message").find("limit") != std::string::npos);
    const Box view = apart.box("view"), flag = apart.box("flag");
    CHECK(flag.width() > 0.1 * view.width());
    CHECK(view.contains(flag.at(0.5, 0.5)));

    app.click("Use the safe step");
    app.wait_until("it to go on", [&](const Look& look) {
        return look.number("diverged") == 0 && look.number("time") > apart.number("time") + 0.1;
    });
    app.check_healthy();
}

TEST_CASE("a refusal is told once: closed while the flag plays it stays closed, and a later message takes its place") {
    const Screen screen;
    const TemporaryFolder folder;
    std::vector<std::string> unfelt = without_cloth("report");
    unfelt.insert(unfelt.end(), {"--set", "wind=off", "--set", "springs.drag=off"});
    App app(screen, unfelt);
    const auto after_a_while = [&app] {
        const double now = app.look().number("time");
        return app.wait_until("time to pass", [now](const Look& look) { return look.number("time") > now + 0.3; });
    };
    app.click("Page: Wind");
    for (int time = 0; time < 2; ++time) {
        // Wind needs drag to be felt by.
        app.click("Wind");
        const Look refused =
            app.wait_until("the refusal", [](const Look& look) { return !look.text("message").empty(); });
        CHECK(refused.text("message").find("drag") != std::string::npos);
        CHECK(after_a_while().text("message") == refused.text("message"));
        CHECK(app.look().controls.at("Wind").value == "0");
        if (time > 0) break;
        app.click("Close");
        CHECK(after_a_while().text("message").empty());
    }

    app.click("Page: Time");
    app.show("Save as");
    app.type("Save as", folder / "kept.toml");
    app.wait_until("the scene to be saved",
                   [](const Look& look) { return look.text("message").starts_with("Saved "); });
    CHECK(after_a_while().text("message").starts_with("Saved "));
    CHECK(std::filesystem::exists(folder / "kept.toml"));
    app.check_healthy();
}

TEST_CASE("the error of the run is shown, and a tolerance makes the step smaller until it is met") {
    const Screen screen;
    App app(screen, {"report", "--size", "1280x800", "--set", "flag.columns=16", "--set", "flag.rows=11", "--set",
                     "view.cloth=false"});
    const auto value = [](const Look& look, const std::string& label) { return look.controls.at(label).value; };
    const Look measured = app.wait_until("an error", [&](const Look& look) {
        return look.has("Reading: Error") && value(look, "Reading: Error").find("mm/s") != std::string::npos;
    });
    CHECK(value(measured, "Reading: Step limit") == "stiffness of the springs");
    const double error = std::stod(value(measured, "Reading: Error"));  // mm/s
    CHECK(error > 0.01);
    CHECK(error < 20.0);

    app.click("Page: Time");
    app.show("Tolerance on");
    app.set("Tolerance on", true);
    app.type_number("Tolerance", "0.1");
    const Look met = app.wait_until("the tolerance to be met", [&](const Look& look) {
        return value(look, "Reading: Step limit").find(" of 0.1 mm/s asked") != std::string::npos;
    });
    // Nothing is wider than the panel, in which every control ends at the same place.
    const double right = met.controls.at("Page: View").box.x1;
    for (const auto& [label, control] : met.controls)
        if (label.starts_with("Reading: ")) {
            INFO(label << ": " << control.value);
            CHECK(control.box.x1 <= right + 1.0);
        }
    // A step that is given has no tolerance.
    app.set("Step chosen automatically", false);
    app.wait_until("the step to be given", [&](const Look& look) {
        return !look.has("Tolerance on") && value(look, "Reading: Step limit") == "none: the step is given";
    });
    CHECK(app.look().text("message").empty());
    app.check_healthy();
}

TEST_CASE("springs become a fabric, which keeps its cells short on any grid and brings the values of its name") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, without_cloth(std::string(DRAPEAU_ASSETS) + "/scenes/linear-drag/breeze.toml", "1280x800"));
    const auto value = [&app](const std::string& label) { return app.look().controls.at(label).value; };
    app.click("Page: Springs");
    CHECK(value("Material") == "springs");
    choose(app, "Material", "fabric");
    app.wait_until("the fabric", [](const Look& look) { return look.has("Stretch modulus"); });
    CHECK_FALSE(app.look().has("Stiffness"));
    // 122 mg on cells of 34.1 x 32.4 mm; 800 and 400 N/m, s = 1/2 but for the cells' shape, so Y is 4/3 of 800.
    CHECK(std::stod(value("Density")) == Approx(110.4).margin(0.6));
    CHECK(std::stod(value("Stretch modulus")) == Approx(1066.0).epsilon(0.01));
    choose(app, "Fabric", "canvas");
    app.wait_until("its density", [&](const Look&) { return std::stod(value("Density")) == 340.0; });
    CHECK(value("Air drag on") == "1");

    app.click("Page: Flag");
    app.type_number("Columns", "170");  // of cells a third as wide as before: at a share of 0.07 four times would do
    app.wait_until("the columns", [](const Look& look) { return look.controls.at("Columns").value == "170"; });
    CHECK(value("Rows") == "30");
    app.type_number("Columns", "200");
    app.wait_until("more rows", [&](const Look& look) { return look.controls.at("Rows").value == "33"; });
    CHECK(app.look().text("message").empty());

    app.click("Page: Time");
    app.show("Save as");
    app.type("Save as", folder / "canvas.toml");
    app.wait_until("the scene to be saved",
                   [](const Look& look) { return look.text("message").starts_with("Saved "); });
    const drapeau::Scene saved = drapeau::read_scene(folder / "canvas.toml");
    CHECK(saved.fabric->name == drapeau::FabricName::canvas);
    CHECK(saved.fabric->stretch_modulus == 1000.0);
    CHECK(saved.flag.rows == 33);
    app.check_healthy();
}

TEST_CASE("the wind goes with the drag that felt it, which is said, and one undo brings both back") {
    const Screen screen;
    App app(screen, without_cloth("report"));
    app.click("Page: Springs");
    app.show("Air drag on");
    app.set("Air drag on", false);
    app.wait_until("a message",
                   [](const Look& look) { return look.text("message").find("wind is off") != std::string::npos; });
    CHECK(app.settle().controls.at("Air drag on").value == "0");
    app.click("Page: Wind");
    CHECK(app.settle().controls.at("Wind").value == "0");
    app.press("ctrl+z");
    app.wait_until("the wind", [](const Look& look) { return look.controls.at("Wind").value == "1"; });
    app.click("Page: Springs");
    app.show("Air drag on");
    CHECK(app.settle().controls.at("Air drag on").value == "1");
    app.check_healthy();
}

TEST_CASE("the stretch limit and travelling gusts are switched on, and the panel says what the limit achieved") {
    const Screen screen;
    App app(screen, without_cloth("report"));
    app.click("Page: Springs");
    app.show("Stretch limit on");
    app.click("Stretch limit on");
    const Look limited = app.wait_until("the limit", [](const Look& look) {
        return look.has("Reading: Limit") &&
               look.controls.at("Reading: Limit").value.find("sweeps") != std::string::npos;
    });
    CHECK(limited.controls.at("Reading: Limit").value.find(" of 10.0 %") != std::string::npos);
    app.show("Stretch limit");  // the reading may have come over it
    CHECK(app.look().controls.at("Stretch limit").value == "10");
    app.show("Back: Stretch limit");
    app.click("Back: Stretch limit");
    app.wait_until("no limit", [](const Look& look) { return !look.has("Reading: Limit"); });

    app.click("Page: Wind");
    app.show("Travelling gusts");
    app.set("Travelling gusts", true);
    const double now = app.look().number("time");
    app.wait_until("time to pass", [now](const Look& look) { return look.number("time") > now + 0.1; });
    CHECK(app.look().text("message").empty());
    app.check_healthy();
}

TEST_CASE("every method can be chosen by its name") {
    const Screen screen;
    App app(screen, without_cloth("report"));
    app.click("Page: Time");
    for (const std::string method : {"leapfrog", "rk4", "semi-implicit-euler"}) {
        CAPTURE(method);
        choose(app, "Method", method);
        const double now = app.look().number("time");
        app.wait_until("time to pass", [now](const Look& look) { return look.number("time") > now + 0.1; });
        CHECK(app.look().text("message").empty());
    }
    app.click("Method");
    CHECK(app.wait_until("the list", [](const Look& look) { return look.has("Method: rk4"); })
              .has("Method: forward-euler"));
    app.press("Escape");
    app.check_healthy();
}

// What the palette finds besides keys and settings: the panel's buttons, and each choice of a list.
#include "catch.hpp"

#include "viewer/app_state.hpp"

using namespace drapeau;

namespace {

PaletteItem first(const AppState& app, const std::string& typed) {
    CAPTURE(typed);
    const auto found = matching(palette_items(app), typed);
    REQUIRE(!found.empty());
    return found.front();
}

}  // namespace

TEST_CASE("every button of the panel is found by what it says, or by what it is about", "[palette]") {
    AppState app;
    for (const auto& [typed, label] : std::vector<std::pair<std::string, std::string>>{
             {"save scene", "Save scene"},
             {"save shape", "Save shape"},
             {"obj", "Save shape"},
             {"plots", "Plots"},
             {"film", "Film"},
             {"gallery of flags", "Gallery of flags"},
             {"gallery of scenes", "Gallery of scenes"},
             {"reset all", "Reset all"},
             {"reset to defaults", "Reset what the window remembers to defaults"},
             {"price each", "Price each part"},
             {"measure settings", "Measure settings"},
             {"copy the scene", "Copy the scene as text"},
             {"paste", "Paste a scene"},
             {"save as", "Save as"},
         }) {
        CHECK(first(app, typed).label == label);
    }
    choose(first(app, "save shape"), app);
    CHECK(app.commands.save_shape);
    choose(first(app, "plots"), app);
    CHECK(app.playback.plots);
    choose(first(app, "gallery of scenes"), app);
    CHECK(app.scenes_shown);
    choose(first(app, "save scene"), app);
    CHECK(app.mark->presses);
    CHECK(app.mark->page == 3);
}

TEST_CASE("each choice of a list is found by the list and its name, and sets it", "[palette]") {
    AppState app;
    const auto set = [&app](const std::string& typed) { choose(first(app, typed), app); };
    set("background: studio");
    CHECK(app.scene.view.background == Background::studio);
    set("method: rk4");
    CHECK(app.scene.time.method == method_id<Rk4>);
    set("attach: top");
    CHECK(app.scene.flag.attach == Attach::top);
    CHECK(first(app, "held by: top").detail == "flag.attach, chosen");
    set("precision: double");
    CHECK(app.scene.time.precision == Precision::double_precision);
    set("material: fabric");
    REQUIRE(app.scene.fabric);
    CHECK_FALSE(app.scene.springs);
    set("fabric: canvas");
    CHECK(app.scene.fabric->name == FabricName::canvas);
    CHECK(app.scene.fabric->density == fabric_of(FabricName::canvas).density);
    CHECK(app.message.text == "Fabric: canvas");
    set("material: springs");
    CHECK(app.scene.springs);
    set("1280 x 720");
    CHECK(film_sizes[std::size_t(app.film.size)] == glm::ivec2(1280, 720));
}

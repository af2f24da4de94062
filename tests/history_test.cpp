// History: what was set is taken back and set again, change by change, and every change has a name.
#include "catch.hpp"

#include "viewer/history.hpp"
#include "viewer/scene_difference.hpp"

using namespace drapeau;

namespace {

struct Edited {
    History history;
    Scene scene;

    Edited() { history.begin({scene, {}}); }
    void set(int columns, unsigned control = 0) {
        scene.flag.columns = columns;
        history.observe({scene, {}}, control);
    }
    /// Columns after an undo; 0 if there is nothing to undo.
    int undo() {
        const auto entry = history.undo();
        if (entry) scene = entry->scene;
        return entry ? scene.flag.columns : 0;
    }
    int redo() {
        const auto entry = history.redo();
        if (entry) scene = entry->scene;
        return entry ? scene.flag.columns : 0;
    }
};

}  // namespace

TEST_CASE("changes are taken back and set again in their order, and a new one forgets those taken back", "[history]") {
    Edited edited;
    const int first = edited.scene.flag.columns;
    CHECK(edited.undo() == 0);
    edited.set(10);
    edited.set(20);
    CHECK(edited.history.undone() == "Columns");
    CHECK(edited.undo() == 10);
    CHECK(edited.undo() == first);
    CHECK(edited.undo() == 0);
    CHECK(edited.redo() == 10);
    CHECK(edited.history.redone() == "Columns");
    edited.set(30);
    CHECK(edited.redo() == 0);
    CHECK(edited.undo() == 10);
}

TEST_CASE("what one control does while it is held is one change, the next time it is another", "[history]") {
    Edited edited;
    const int first = edited.scene.flag.columns;
    for (const int columns : {11, 12, 13}) edited.set(columns, 7);
    edited.set(13, 0);  // let go
    for (const int columns : {14, 15}) edited.set(columns, 7);
    for (const int columns : {16, 17}) edited.set(columns, 8);  // another one, at once
    CHECK(edited.undo() == 15);
    CHECK(edited.undo() == 13);
    CHECK(edited.undo() == first);
    CHECK(edited.undo() == 0);
}

TEST_CASE("what follows by itself belongs to its change, and a change that was refused is none", "[history]") {
    Edited edited;
    const Scene first = edited.scene;
    edited.scene.view.texture_proportions = true;
    edited.history.observe({edited.scene, {}});
    edited.scene.flag.width = 2.0;
    edited.history.amend({edited.scene, {}});
    CHECK(edited.history.undone() == "Width and Shaped like its image");
    edited.undo();
    CHECK(edited.scene == first);

    edited.set(4000, 7);
    edited.history.amend({first, {}});
    CHECK(edited.history.undone().empty());
    edited.set(12, 7);  // the drag goes on
    CHECK(edited.undo() == first.flag.columns);
}

TEST_CASE("an earlier moment with its settings is looked at, and what was set since can still be undone", "[history]") {
    Edited edited;
    const Scene first = edited.scene;
    edited.set(50);
    edited.history.look_at({first, {}});
    edited.history.look_at({edited.scene, {}});
    edited.history.amend({edited.scene, {}});
    CHECK(edited.history.undone() == "Columns");
    CHECK(edited.undo() == first.flag.columns);
}

TEST_CASE("only so many changes are kept", "[history]") {
    Edited edited;
    const int changes = int(History::max_changes) + 50;
    for (int i = 1; i <= changes; ++i) edited.set(1 + i);
    int undone = 0;
    while (edited.undo()) ++undone;
    CHECK(undone == int(History::max_changes));
    CHECK(edited.scene.flag.columns == 1 + 50);
}

TEST_CASE("an image is gone back to with the settings that name it", "[history]") {
    History history;
    Scene scene;
    history.begin({scene, "/flags/japan.png"});
    scene.flag.texture = "france.png";
    history.observe({scene, "/flags/france.png"});
    CHECK(history.undone() == "Image");
    CHECK(history.undo()->image == "/flags/japan.png");
    CHECK(history.redo()->image == "/flags/france.png");
}

TEST_CASE("a difference is named by its settings, by its table, or by their number", "[history]") {
    const Scene scene;
    CHECK(difference_between(scene, scene).empty());
    Scene other = scene;
    other.time.dt = 1e-3;
    CHECK(difference_between(scene, other) == "Step size");
    other.flag.rows = 7;
    CHECK(difference_between(scene, other) == "Rows and Step size");
    other.flag.columns = 7;
    CHECK(difference_between(scene, other) == "3 settings");
    Scene windy = scene;
    windy.wind().emplace();
    CHECK(difference_between(scene, windy) == "Wind");
    CHECK(difference_between(windy, scene) == "Wind");
    Scene fabric = scene;
    fabric.springs.reset();
    fabric.fabric.emplace();
    CHECK(difference_between(scene, fabric) == "Material");
}

// The page on masses, springs, and on the terms and limits that have no page of their own.
#include "panels.hpp"

#include "scene/check.hpp"
#include "scene/material.hpp"
#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

namespace {

void choose_material(AppState& app, Widgets& widgets) {
    int index = app.scene.fabric ? 1 : 0;
    if (!widgets.choice("Material", index, {"springs", "fabric"}, app.origin.fabric ? 1 : 0,
                        "Springs: every mass and spring by itself, so that another grid is another cloth. Fabric: the "
                        "same cloth on every grid. A change leaves the flag about as it is, but for friction, which a "
                        "fabric has none of."))
        return;
    index == 1 ? give_as_fabric(app.scene) : give_as_springs(app.scene);
    app.diagonals.reset();
}

void edit_springs(AppState& app, Widgets& widgets) {
    SpringSettings& springs = *app.scene.springs;
    const SpringSettings origin = app.origin.springs.value_or(springs);
    each_key(springs_keys, [&](const auto& field) { edit(widgets, "springs", field, springs, origin); });
}

void edit_fabric(AppState& app, Widgets& widgets) {
    Fabric& fabric = *app.scene.fabric;
    const FabricName before = fabric.name;
    const Fabric origin = app.origin.fabric.value_or(fabric_of(before));
    each_key(fabric_keys, [&](const auto& field) { edit(widgets, "fabric", field, fabric, origin); });
    bring_fabric(app, before);
}

/// A wind that nothing feels is no scene: it goes with the last that felt it.
void leave_out_unfelt_wind(AppState& app) {
    app.scene.wind().reset();
    say(app, Message::Cause::typed, "The wind is off too, for nothing feels it now. Ctrl Z brings both back.", false);
}

}  // namespace

void draw_springs_page(AppState& app, Widgets& widgets) {
    const bool was_felt = feels_wind(app.scene);
    choose_material(app, widgets);
    if (app.scene.fabric)
        edit_fabric(app, widgets);
    else
        edit_springs(app, widgets);
    ImGui::Spacing();
    Limits::for_all(app.scene.limits, [&]<class Limit>(std::optional<Limit>& limit) {
        edit_table(widgets, limit, app.origin.limits.get<Limit>());
    });
    Terms::for_all(app.scene.terms, [&]<class Term>(std::optional<Term>& term) {
        constexpr bool has_table = requires {
            Term::table;
        };
        if constexpr (has_table && !std::is_same_v<Term, Wind>)
            edit_table(widgets, term, app.origin.terms.get<Term>(), usual_term<Term>(app.scene));
    });
    if (app.scene.wind() && was_felt && !feels_wind(app.scene)) leave_out_unfelt_wind(app);
}

}  // namespace drapeau

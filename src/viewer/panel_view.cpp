// The page on what is seen beside what the panel's head switches.
#include "panels.hpp"

#include "setting_controls.hpp"

namespace drapeau {

using namespace settings;

void draw_view_page(AppState& app, Widgets& widgets) {
    ViewSettings& view = app.scene.view;
    const auto edit_view = [&](auto member) {
        edit(widgets, "view", row_of(member, view_keys), view, app.origin.view);
    };
    edit_view(&ViewSettings::background);
    edit_view(&ViewSettings::wind);
    edit_view(&ViewSettings::stretch);
    edit_view(&ViewSettings::velocities);
    edit_view(&ViewSettings::colours);
    // Fixed, a range begins where the automatic one is.
    const auto edit_range = [&](auto member, double now) {
        auto row = row_of(member, view_keys);
        row.control.usual = now;
        edit(widgets, "view", row, view, app.origin.view);
    };
    edit_range(&ViewSettings::force_range, app.status.force_scale);
    edit_range(&ViewSettings::stretch_range, app.status.stretch_scale);
    edit_range(&ViewSettings::velocity_range, app.status.speed_scale);
    edit_view(&ViewSettings::bare_grid);
    edit_view(&ViewSettings::person);
}

}  // namespace drapeau

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
    edit_view(&ViewSettings::bare_grid);
    edit_view(&ViewSettings::person);
}

}  // namespace drapeau

// The page on masses, springs, and on the terms and limits that have no page of their own.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

void draw_springs_page(AppState& app, Widgets& widgets) {
    each_key(springs_keys,
             [&](const auto& field) { edit(widgets, "springs", field, app.scene.springs, app.origin.springs); });
    ImGui::Spacing();
    Limits::for_all(app.scene.limits, [&]<class Limit>(std::optional<Limit>& limit) {
        edit_table(widgets, limit, app.origin.limits.get<Limit>());
    });
    Terms::for_all(app.scene.terms, [&]<class Term>(std::optional<Term>& term) {
        constexpr bool has_table = requires {
            Term::table;
        };
        if constexpr (has_table && !std::is_same_v<Term, Wind>) edit_table(widgets, term, app.origin.terms.get<Term>());
    });
}

}  // namespace drapeau

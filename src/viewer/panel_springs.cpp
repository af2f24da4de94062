// The page on masses, springs, and on the terms and limits that have no page of their own.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

void draw_springs_page(Session& session, Widgets& widgets) {
    each_key(springs_keys, [&](const auto& field) {
        edit(widgets, "springs", field, session.scene.springs, session.origin.springs);
    });
    ImGui::Spacing();
    Limits::for_all(session.scene.limits, [&]<class Limit>(std::optional<Limit>& limit) {
        edit_table(widgets, limit, session.origin.limits.get<Limit>());
    });
    Terms::for_all(session.scene.terms, [&]<class Term>(std::optional<Term>& term) {
        constexpr bool has_table = requires {
            Term::table;
        };
        if constexpr (has_table && !std::is_same_v<Term, Wind>)
            edit_table(widgets, term, session.origin.terms.get<Term>());
    });
}

}  // namespace drapeau

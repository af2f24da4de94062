// The page on masses, springs and gravity.
#include "panels.hpp"

#include <imgui.h>

namespace drapeau {

namespace {

void edit_limit(Session& session, Widgets& widgets) {
    const auto share_of = [](const std::optional<StretchLimit>& limit) {
        return limit ? std::optional(limit->stretch) : std::nullopt;
    };
    auto& limit = session.scene.limits.get<StretchLimit>();
    auto share = share_of(limit);
    if (!widgets.term(
            "Stretch limit", share, {.low = 2.0, .high = 50.0, .format = "%.1f %%", .shown_per_unit = 100.0},
            share_of(session.origin.limits.get<StretchLimit>()), StretchLimit{}.stretch,
            "How much longer than at rest a spring may get. After every step, springs that are longer are "
            "shortened. A higher limit lets the cloth stretch more; a limit well below the stretch without one "
            "takes many times as long."))
        return;
    limit = share ? std::optional(StretchLimit{*share}) : std::nullopt;
}

void edit_gravity(Session& session, Widgets& widgets) {
    auto& gravity = session.scene.gravity();
    const Gravity origin = session.origin.gravity().value_or(Gravity{});
    bool on = gravity.has_value();
    if (widgets.toggle("Gravity", on, "Gravity on or off.")) gravity = on ? std::optional(origin) : std::nullopt;
    if (!gravity) return;
    const glm::dvec3 usual = origin.acceleration;
    const Range range{.low = -30.0, .high = 30.0, .format = "%.2f m/s\xc2\xb2"};
    widgets.slider("Gravity along", gravity->acceleration.x, range, usual.x,
                   "Acceleration along the fly; positive is away from the pole.");
    widgets.slider("Gravity up", gravity->acceleration.y, range, usual.y,
                   "Acceleration upwards: -9.8 on Earth, -1.6 on the Moon.");
    widgets.slider("Gravity across", gravity->acceleration.z, range, usual.z,
                   "Acceleration across the flag; positive is towards its front.");
}

}  // namespace

void draw_springs_page(Session& session, Widgets& widgets) {
    SpringSettings& springs = session.scene.springs;
    const SpringSettings& origin = session.origin.springs;
    widgets.slider(
        "Mass", springs.mass,
        {.low = 0.01, .high = 100.0, .logarithmic = true, .format = "%.3g g", .shown_per_unit = 1000.0}, origin.mass,
        "Of every mass. Heavier cloth swings more slowly, stretches more under its weight and allows a larger step.");
    const Range stiffness{.low = 1.0, .high = 20000.0, .logarithmic = true, .format = "%.4g N/m"};
    widgets.slider(
        "Stiffness", springs.stiffness, stiffness, origin.stiffness,
        "k of the springs to the four side neighbours. Stiffer cloth stretches less and needs a smaller step.");
    widgets.term("Diagonal stiffness", springs.diagonal_stiffness, stiffness, origin.diagonal_stiffness,
                 session.diagonal_stiffness,
                 "k of the springs to the four diagonal neighbours, which resist shear. Stiffer springs need a smaller "
                 "step.");
    edit_limit(session, widgets);
    widgets.term("Damping", springs.damping,
                 {.low = 1e-5, .high = 1.0, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"}, origin.damping, 0.002,
                 "c of every spring. It damps vibration along springs and leaves motion of the whole flag alone. More "
                 "damping needs a smaller step.");
    widgets.term(
        "Air drag", springs.drag, {.low = 1e-6, .high = 0.1, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"},
        origin.drag, 0.0006,
        "d of every mass against the air; wind pushes through it. More drag makes the cloth follow the air more "
        "closely.");
    widgets.term("Friction", springs.friction,
                 {.low = 1e-6, .high = 0.1, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"}, origin.friction,
                 0.0001,
                 "c_f of every mass against its own velocity, whatever the air does. More friction slows all motion.");

    ImGui::Spacing();
    edit_gravity(session, widgets);
}

}  // namespace drapeau

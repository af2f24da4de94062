// The page on masses, springs and gravity.
#include "panels.hpp"

#include <imgui.h>

namespace drapeau {

void draw_springs_page(Session& session, Widgets& widgets) {
    SpringSettings& springs = session.scene.springs;
    const SpringSettings& origin = session.origin.springs;
    widgets.slider(
        "Mass", springs.mass,
        {.low = 0.01, .high = 100.0, .logarithmic = true, .format = "%.3g g", .shown_per_unit = 1000.0}, origin.mass,
        "Of every mass. Heavier cloth hangs and swings more slowly, stretches more, and allows a larger step.");
    const Range stiffness{.low = 1.0, .high = 20000.0, .logarithmic = true, .format = "%.4g N/m"};
    widgets.slider(
        "Stiffness", springs.stiffness, stiffness, origin.stiffness,
        "k of the springs to the four side neighbours. Stiffer cloth stretches less and needs a smaller step.");
    widgets.term("Diagonal stiffness", springs.diagonal_stiffness, stiffness, origin.diagonal_stiffness,
                 session.diagonal_stiffness,
                 "k of the springs to the four diagonal neighbours, which resist shear. Stiffer needs a smaller step.");
    widgets.term("Damping", springs.damping,
                 {.low = 1e-5, .high = 1.0, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"}, origin.damping, 0.002,
                 "c along every spring: calms its vibration, leaves motion of the whole flag alone. A lot needs a "
                 "smaller step.");
    widgets.term("Air drag", springs.drag,
                 {.low = 1e-6, .high = 0.1, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"}, origin.drag, 0.0006,
                 "d of every mass against the air. It is also what the wind pulls on.");
    widgets.term("Friction", springs.friction,
                 {.low = 1e-6, .high = 0.1, .logarithmic = true, .format = "%.3g N\xc2\xb7s/m"}, origin.friction,
                 0.0001, "c_f of every mass against its own velocity, wind or not.");

    auto& gravity = session.scene.gravity;
    bool on = gravity.has_value();
    ImGui::Spacing();
    if (widgets.toggle("Gravity", on, "Whether anything weighs."))
        gravity = on ? std::optional(session.origin.gravity.value_or(GravitySettings{})) : std::nullopt;
    if (!gravity) return;
    const glm::dvec3 usual = session.origin.gravity.value_or(GravitySettings{}).acceleration;
    const Range range{.low = -30.0, .high = 30.0, .format = "%.2f m/s\xc2\xb2"};
    widgets.slider("Gravity along", gravity->acceleration.x, range, usual.x,
                   "Acceleration along the fly, away from the pole.");
    widgets.slider("Gravity up", gravity->acceleration.y, range, usual.y,
                   "Acceleration upwards: -9.8 on Earth, -1.6 on the Moon.");
    widgets.slider("Gravity across", gravity->acceleration.z, range, usual.z, "Acceleration towards the flag's front.");
}

}  // namespace drapeau

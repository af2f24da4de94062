// The settings of a scene, one row each. The row drives reading, writing and checking scene files, every message about
// the key, --set on the command lines, the panel's control and docs/scene.md. To add a setting, add its member to the
// settings, the fabric or the term it belongs to and its row here. A term or limit with a table of its own needs a
// tuple of rows, keys_of<Term>; the list of terms does the rest.
#pragma once

#include "scene/setting.hpp"

#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace drapeau::settings {

inline constexpr std::tuple scene_keys{
    Key{"name", &Scene::name, About{"Name", "", "shown in the window's title"}},
};

inline constexpr std::tuple flag_keys{
    Key{"columns", &FlagSettings::columns,
        About{"Columns", "", "masses along the fly, away from the pole",
              "More columns show finer folds and take more time. Of springs they make the flag heavier, for every mass "
              "weighs "
              "the same; of a fabric the cloth stays the same."},
        Range{1, 4096}, Control{{1, 200}}},
    Key{"rows", &FlagSettings::rows,
        About{"Rows", "", "masses along the hoist, down the pole", "More rows do the same."}, Range{1, 4096},
        Control{{1, 200}}},
    Key{"width", &FlagSettings::width,
        About{"Width", "m", "along the fly, at rest", "A wider flag has longer springs, not more of them."},
        Range{1e-3, 1e3}, Control{{0.1, 5}, false, "%.2f"}},
    Key{"height", &FlagSettings::height,
        About{"Height", "m", "along the hoist, at rest", "A higher flag has longer springs, not more of them."},
        Range{1e-3, 1e3}, Control{{0.1, 5}, false, "%.2f"}},
    Key{"attach", &FlagSettings::attach,
        About{"Held by", "",
              "hoist, grommets (the two hoist corners), top, corner, sides (hoist and fly), edges, all or none",
              "Which masses are held in place."}},
    Key{"start", &FlagSettings::start,
        About{"Starts", "", "flat, hanging (settled without wind) or crumpled", "How the flag begins, after Restart."}},
    Key{"prestretch", &FlagSettings::prestretch,
        About{"Prestretch", "", "share; 0.1 starts 10 % longer than rest",
              "A larger share gives the flag more elastic energy to begin with, after Restart."},
        Range{-0.9, 10}, Control{{0, 50}, false, "%.0f", 100, "%"}},
    Key{"disturbance", &FlagSettings::disturbance,
        About{"Disturbance", "m", "ripples of a flat start; 0 keeps it in its plane",
              "A flat flag without ripples stays in its plane for ever, unless something pushes it out. auto: a "
              "nanometre "
              "where nothing does."},
        Range{0, 1}, Control{{0, 50}, false, "%.3g", 1000, "mm", 0.002}, "auto"},
    Key{"halyard", &FlagSettings::halyard,
        About{"Halyard", "", "share of the pole at which the flag's upper corner hangs; 1: at its top, 0.5: half-mast",
              "A flag that flies is hauled up or down at 0.5 m/s, at most until its foot reaches the ground. Off: it "
              "stays where it is held."},
        Range{0, 1}, Control{{0, 100}, false, "%.0f", 100, "%", 1.0}, "off"},
    Key{"texture", &FlagSettings::texture, About{"Image", "", "image file, beside this file or in assets/flags"}},
};

inline constexpr Range stiffness_range{1e-9, 1e9}, damping_range{0, 1e6};
inline constexpr Control stiffness_control{{1, 20000}, true, "%.4g", 1, "", 100};

inline constexpr std::tuple springs_keys{
    Key{"mass", &SpringSettings::mass,
        About{"Mass", "kg", "of every mass",
              "Heavier cloth swings more slowly, stretches more under its weight and allows a larger step."},
        Range{1e-9, 1e6}, Control{{0.01, 100}, true, "%.3g", 1000, "g"}, "", true},
    Key{"stiffness", &SpringSettings::stiffness,
        About{"Stiffness", "N/m", "of springs between side neighbours (k)",
              "Stiffer cloth stretches less and needs a smaller step."},
        stiffness_range, stiffness_control, "", true},
    Key{"diagonal_stiffness", &SpringSettings::diagonal_stiffness,
        About{"Diagonal stiffness", "N/m", "of springs between diagonal neighbours (k_d)",
              "They resist shear. Stiffer springs need a smaller step."},
        stiffness_range, stiffness_control},
    Key{"damping", &SpringSettings::damping,
        About{
            "Damping", "N·s/m", "along every spring (c)",
            "It damps vibration along springs and leaves motion of the whole flag alone. More damping needs a smaller "
            "step."},
        damping_range, Control{{1e-5, 1}, true, "%.3g", 1, "", 0.002}},
    Key{"drag", &SpringSettings::drag,
        About{"Air drag", "N·s/m", "of every mass against the air (d), the same edge-on and broadside",
              "Wind pushes through it. More drag makes the cloth follow the air more closely."},
        damping_range, Control{{1e-6, 0.1}, true, "%.3g", 1, "", 0.0006}},
    Key{"friction", &SpringSettings::friction,
        About{"Friction", "N·s/m", "of every mass, whatever the air does (c_f)", "More friction slows all motion."},
        damping_range, Control{{1e-6, 0.1}, true, "%.3g", 1, "", 0.0001}},
};

inline constexpr std::tuple fabric_keys{
    Key{"name", &Fabric::name,
        About{"Fabric", "", "what it is made of: its values are taken where none is given",
              "Another fabric brings values of its own."}},
    Key{"density", &Fabric::density,
        About{"Density", "kg/m²", "mass per area", "A heavier cloth swings more slowly and allows a larger step."},
        Range{1e-6, 1e6}, Control{{10, 1000}, true, "%.0f", 1000, "g/m²"}},
    Key{"stretch_modulus", &Fabric::stretch_modulus,
        About{"Stretch modulus", "N/m", "pull per width over stretch, along the threads (Y)",
              "Stiffer cloth stretches less and needs a smaller step."},
        stiffness_range, Control{{10, 20000}, true, "%.4g"}},
    Key{"diagonal_share", &Fabric::diagonal_share,
        About{"Diagonal share", "", "of diagonal springs' stiffness to that of others, on square cells (s)",
              "They resist shear: little in woven cloth, at 0.5 alike in all directions. Off: nothing does, and half "
              "of all springs are saved."},
        Range{1e-6, 1e3}, Control{{0.01, 1}, true, "%.3f", 1, "", 0.1}, "off"},
    Key{"damping_time", &Fabric::damping_time,
        About{"Damping time", "s", "damping over stiffness of every spring (tau)",
              "A longer one damps vibration along springs sooner and needs a smaller step. Off: none is computed."},
        Range{0, 1e3}, Control{{1e-3, 10}, true, "%.3g", 1000, "ms", 5e-5}, "off"},
    Key{"drag_per_area", &Fabric::drag_per_area,
        About{"Air drag", "N·s/m³", "per area, against the air, the same edge-on and broadside",
              "Wind pushes through it. More drag makes the cloth follow the air more closely."},
        damping_range, Control{{1e-2, 100}, true, "%.3g", 1, "", 0.5}},
};

/// The keys of a term's or limit's own table, and what a reader of its table should know.
template <class Term>
inline constexpr std::tuple keys_of{};
template <class Term>
inline constexpr std::string_view remark_on = "";

template <>
inline constexpr std::string_view remark_on<SpringSettings> =
    "Every mass and every spring alike, borders too: another grid is another cloth. A scene has either this table or "
    "[fabric].";
template <>
inline constexpr std::string_view remark_on<Fabric> =
    "The same cloth on every grid: masses and springs follow from the cells, and borders are as light as their share "
    "of it. Defaults are those of the named fabric, here knitted polyester (docs/model.md has all). A scene has either "
    "this table or [springs].";

template <>
inline constexpr std::tuple keys_of<Gravity>{
    Key{"acceleration", &Gravity::acceleration,
        About{"Gravity", "m/s²", "y is up", "-9.81 upwards is the Earth's, -1.62 the Moon's."}, Range{-1e4, 1e4},
        Control{{-30, 30}, false, "%.2f"}},
};

template <>
inline constexpr std::string_view remark_on<Air> =
    "The air pushes faces broadside and drags along them. It takes the place of springs.drag, unless that is given "
    "too.";
template <>
inline constexpr std::tuple keys_of<Air>{
    Key{"density", &Air::density,
        About{"Air density", "kg/m³", "of the air (rho)", "Denser air pushes harder and brakes more."}, Range{0, 1e3},
        Control{{0, 5}, false, "%.2f"}},
    Key{"pressure", &Air::pressure,
        About{"Face pressure", "", "drag coefficient of a face that the air meets broadside (C_d)",
              "A higher one lets the wind push faces harder. Off: no pressure is computed."},
        Range{0, 100}, Control{{0, 3}, false, "%.2f", 1, "", 1.2}, "off"},
    Key{"skin", &Air::skin,
        About{"Skin friction", "", "drag coefficient of the air along a face (C_f)",
              "A higher one drags the flag taut and calms its ripples. Off: none is computed."},
        Range{0, 100}, Control{{0, 0.3}, false, "%.3f", 1, "", 0.05}, "off"},
    Key{"added", &Air::added,
        About{"Added air", "", "the air that moves along with the cloth",
              "It outweighs the cloth and makes it flutter in steady wind. It is found once in several steps. Bending "
              "with damping keeps ripples as fine as the grid down."}},
    Key{"cutoff", &Air::cutoff,
        About{"Cutoff", "m", "half the length of the shortest waves that carry air along; of added air alone",
              "A longer one lets only longer waves flutter."},
        Range{1e-3, 1e3}, Control{{0.02, 0.5}, false, "%.2f"}},
};

template <>
inline constexpr std::string_view remark_on<Bending> =
    "Threads resist being curved. A named fabric brings its own rigidity, 8 to 70 µN·m (docs/model.md); more makes "
    "wider "
    "folds, which coarse grids need to be folds of the cloth and not of the grid.";
template <>
inline constexpr std::tuple keys_of<Bending>{
    Key{"stiffness", &Bending::stiffness,
        About{"Bending rigidity", "N·m", "what a strip resists being curved with, over its width (B)",
              "A higher one makes wider, calmer folds. Large values need a smaller step."},
        Range{0, 1e6}, Control{{1, 1e5}, true, "%.4g", 1e6, "µN·m"}},
    Key{"damping", &Bending::damping,
        About{"Bending damping", "1/s", "how fast the shortest wave of the grid is braked; longer waves far less",
              "It calms ripples as fine as the grid, and next to nothing else. Off: none is computed."},
        Range{0, 1e6}, Control{{1, 1e4}, true, "%.0f", 1, "", 200.0}, "off"},
};

template <>
inline constexpr std::string_view remark_on<Wind> =
    "Wind is felt through drag of springs or fabric, or through [air], so it needs one of them.";
template <>
inline constexpr std::tuple keys_of<Wind>{
    Key{"velocity", &Wind::velocity,
        About{"Wind", "m/s", "the mean; x away from the pole, y up, z towards the viewer",
              "Faster wind lifts the flag and stretches its springs more."},
        Range{-1e6, 1e6}, Control{{-40, 40}, false, "%.1f"}},
    Key{"gusts", &Wind::gusts,
        About{"Gusts", "m/s", "rms on each axis, added to the mean",
              "Higher is more violent; across the flag, it flaps more."},
        Range{0, 1e6}, Control{{0, 15}, false, "%.1f"}},
    Key{"period", &Wind::period,
        About{"Gust period", "s", "how fast gusts change", "A longer period makes them change more slowly."},
        Range{1e-3, 1e6}, Control{{0.1, 20}, true, "%.2f"}},
    Key{"travelling", &Wind::travelling,
        About{"Travelling gusts", "", "gusts run along the flag with the mean wind; false: the same everywhere",
              "They move at 1 m/s at least, and reach the pole before the fly. Travelling gusts take more time."}},
    Key{"seed", &Wind::seed,
        About{"Seed", "", "a different seed gives different gusts", "The same seed always repeats them."},
        Range{0, static_cast<double>(max_seed)}, Control{{1, 100}}},
};

template <>
inline constexpr std::tuple keys_of<StretchLimit>{
    Key{"stretch", &StretchLimit::stretch,
        About{"Stretch limit", "", "share; 0.05: no spring longer than 1.05 times its rest length",
              "After every step, springs that are longer are shortened. A higher limit lets the cloth stretch more; a "
              "limit well below the stretch without one takes several times as long."},
        Range{0, 10}, Control{{2, 50}, false, "%.1f", 100, "%"}, "", true},
};

template <>
inline constexpr std::string_view remark_on<Ground> =
    "Masses do not go below it; they lie on it without a bounce. Without this table ground is drawn, but nothing "
    "touches it.";
template <>
inline constexpr std::tuple keys_of<Ground>{
    Key{"height", &Ground::height,
        About{"Ground", "m", "its height; the flag's upper corner at full mast is at 0, and the pole stands on it",
              "A deeper one gives a longer pole."},
        Range{-1e3, 1e3}, Control{{-10, 0}, false, "%.2f"}},
    Key{"friction", &Ground::friction,
        About{"Ground friction", "", "coefficient, of the cloth on it (mu)", "A higher one lets the cloth slide less."},
        Range{0, 100}, Control{{0, 2}, false, "%.2f"}},
};

template <>
inline constexpr std::string_view remark_on<Pole> =
    "An upright pole of any height along the hoist, that the flag wraps around. Masses are kept half a cell further "
    "out "
    "where cells are wide, so that threads between them do not cut into it. Without this table a pole is drawn, but "
    "nothing touches it.";
template <>
inline constexpr std::tuple keys_of<Pole>{
    Key{"radius", &Pole::radius, About{"Pole radius", "m", "of the pole", "A thicker one is wrapped in fewer turns."},
        Range{1e-4, 10}, Control{{5, 100}, false, "%.0f", 1000, "mm"}},
    Key{"friction", &Pole::friction,
        About{"Pole friction", "", "coefficient, of the cloth on it (mu)", "A higher one holds what wraps around it."},
        Range{0, 100}, Control{{0, 2}, false, "%.2f"}},
};

inline constexpr Range dt_range{1e-9, 1e3};  // s

inline constexpr std::tuple time_keys{
    Key{"method", &TimeSettings::method, About{"Method", "", "how a step is taken; docs/model.md lists the methods"}},
    Key{"dt", &TimeSettings::dt,
        About{"Step size", "s", "\"auto\" is a share of the largest stable step",
              "A larger step takes less time and is less accurate; above the stability limit the run diverges. The "
              "window "
              "rounds it down to a whole number of steps per 1/60 s."},
        dt_range, Control{{0.01, 1000.0 / 60.0}, true, "%.4g", 1000, "ms"}, "auto"},
    Key{"precision", &TimeSettings::precision,
        About{"Precision", "", "float or double",
              "Floating-point type. double takes about twice the time and matters in long or very accurate runs."}},
    Key{"half_kick_start", &TimeSettings::half_kick_start,
        About{
            "Half-kick start", "", "semi-implicit-euler begins half a kick back; other methods take no notice",
            "The velocity is stored half a step behind the position, as the method's own motion has it. Costs nothing "
            "and makes short runs several times more accurate; without damping the order is 2."}},
    Key{"tolerance", &TimeSettings::tolerance,
        About{"Tolerance", "m/s", "the error of positions in a second of simulated time; with an automatic step only",
              "The automatic step also stays small enough for this error (root mean square over the masses, measured "
              "over 0.1 s). A smaller tolerance takes more time: half of it twice as much with a method of order 1."},
        Range{1e-9, 1e3}, Control{{0.001, 100}, true, "%.3g", 1000, "mm/s", 0.001}, "off"},
};

inline constexpr std::tuple view_keys{
    Key{"texture", &ViewSettings::texture, About{"Texture", "", "the image on the cloth", "Off: plain cloth. Key T"}},
    Key{"cut_out", &ViewSettings::cut_out,
        About{"Cut out", "", "no cloth where the image is transparent",
              "The flag has its image's outline; off: pale cloth. The simulated cloth is rectangular either way."}},
    Key{"cloth", &ViewSettings::cloth, About{"Cloth", "", "the surface between the masses", "Key C"}},
    Key{"springs", &ViewSettings::springs, About{"Springs", "", "every spring as a line", "Key S"}},
    Key{"forces", &ViewSettings::forces,
        About{"Force colours", "", "springs coloured by their force, white to red",
              "A scale in newtons stands below the flag. Key F"}},
    Key{"masses", &ViewSettings::masses, About{"Masses", "", "every mass as a point", "Key M"}},
    Key{"wind", &ViewSettings::wind,
        About{"Wind shown", "", "an arrow as long as the wind is fast, and streaks that drift with it",
              "The arrow points where the wind of this moment blows to, gusts included. Key W"}},
    Key{"reference", &ViewSettings::reference,
        About{
            "Reference", "", "a wireframe of the same flag, computed far more accurately from then on",
            "By rk4 in double at half its automatic step, on a spare thread, under the same wind. How far the flag has "
            "gone from it is shown in mm. A change of settings begins it anew. Key G"}},
    Key{"texture_proportions", &ViewSettings::texture_proportions,
        About{"Shaped like its image", "", "the flag takes the proportions of its image",
              "The width follows from the height."}},
    Key{"background", &ViewSettings::background,
        About{"Background", "", "sky, studio or transparent",
              "studio: a plain backdrop, softly lit, with a floor that takes the shadow. transparent: neither sky nor "
              "ground; screenshots, and films of formats that can, keep it transparent."}},
    Key{"stretch", &ViewSettings::stretch,
        About{"Stretch colours", "", "the cloth coloured by how far it is stretched",
              "At every mass by the direction of its springs that is stretched most, so that cloth is slack only where "
              "no direction is taut. A scale in % stands below the flag. Key E"}},
    Key{"velocities", &ViewSettings::velocities,
        About{
            "Velocities", "", "a line from masses along their velocity",
            "As long as the mass is fast; a scale in m/s stands below the flag. On fine grids not every mass has one. "
            "Key V"}},
    Key{"colours", &ViewSettings::colours,
        About{"Colours", "", "of forces and stretch: red or viridis",
              "red: forces from white to red, stretch from blue (compressed) to red. viridis: from dark blue to "
              "yellow, ever lighter, which can be read by the colour-blind and in print without colours."}},
    Key{"force_range", &ViewSettings::force_range,
        About{"Force range", "N", "at the end of the force colours",
              "A larger one shows strong springs apart, a smaller one weak springs. auto: a round number that follows "
              "the forces."},
        Range{1e-9, 1e9}, Control{{1e-3, 1e3}, true, "%.3g", 1, "", 1.0}, "auto"},
    Key{"stretch_range", &ViewSettings::stretch_range,
        About{"Stretch range", "",
              "share at the ends of the stretch colours; 0.05: from 5 % compressed to 5 % stretched",
              "A larger one shows strong stretch apart, a smaller one weak stretch. auto: a round number that follows "
              "the stretch."},
        Range{1e-6, 10}, Control{{0.01, 100}, true, "%.3g", 100, "%", 0.05}, "auto"},
    Key{"velocity_range", &ViewSettings::velocity_range,
        About{"Velocity range", "m/s", "of a line as long as the scale below the flag",
              "A larger one makes lines shorter. auto: a round number that follows the velocities."},
        Range{1e-6, 1e6}, Control{{0.01, 100}, true, "%.3g", 1, "", 5.0}, "auto"},
    Key{"bare_grid", &ViewSettings::bare_grid,
        About{"Bare grid", "", "flat facets between the masses, as they are simulated",
              "Off: a smooth surface through all masses, which shows folds as cloth has them. Neither changes the "
              "simulation."}},
    Key{"person", &ViewSettings::person,
        About{"Person", "", "a figure 1.75 m tall beside the flag, as a scale", "Shows how large the flag is."}},
};

/// Calls visit for the table of a term or limit, if it has one.
template <class Listed, class Visit>
void visit_table_of(Listed& listed, Visit&& visit) {
    using Term = typename std::remove_const_t<Listed>::value_type;
    if constexpr (requires { Term::table; }) visit(Term::table, listed, keys_of<Term>);
}

/// Calls visit(table name, settings or optional settings, its keys) in the order of a file. The keys before the first
/// table have the name "".
template <class AnyScene, class Visit>
void each_table(AnyScene& scene, Visit&& visit) {
    visit("", scene, scene_keys);
    visit("flag", scene.flag, flag_keys);
    visit("springs", scene.springs, springs_keys);
    visit("fabric", scene.fabric, fabric_keys);
    Terms::for_all(scene.terms, [&](auto& term) { visit_table_of(term, visit); });
    Limits::for_all(scene.limits, [&](auto& limit) { visit_table_of(limit, visit); });
    visit("time", scene.time, time_keys);
    visit("view", scene.view, view_keys);
}

template <class Keys, class Visit>
void each_key(const Keys& keys, Visit&& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, keys);
}

template <class Keys>
std::vector<std::string_view> names_in(const Keys& keys) {
    std::vector<std::string_view> names;
    each_key(keys, [&](const auto& field) { names.push_back(field.key); });
    return names;
}

/// Settings a scene may list or not, seen alike: a pointer, null when not listed.
template <class Settings>
auto* listed(Settings& settings) {
    return &settings;
}
template <class Settings>
auto* listed(std::optional<Settings>& settings) {
    return settings ? &*settings : nullptr;
}
template <class Settings>
auto* listed(const std::optional<Settings>& settings) {
    return settings ? &*settings : nullptr;
}

}  // namespace drapeau::settings

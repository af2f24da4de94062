// Scene: what a scene file says, as plain data: the settings a model is built from (model_of), how it is integrated,
// and what the window shows. What a scene does not list (an empty optional) is not computed.
#pragma once

#include "drapeau/fabric.hpp"
#include "drapeau/methods/list.hpp"
#include "drapeau/model.hpp"

#include <optional>
#include <string>

namespace drapeau {

enum class Start { flat, hanging, crumpled };
enum class Precision { single_precision, double_precision };
enum class Background { sky, studio, transparent };
enum class Colours { red, viridis };  // of forces and stretch

/// The grid of masses and how it begins. Column i, row j rests at (i * width/(columns-1), -j * height/(rows-1), 0).
struct FlagSettings {
    int columns = 45;     // masses along the fly; with one column the width is unused
    int rows = 30;        // masses along the hoist; with one row the height is unused
    double width = 1.5;   // m
    double height = 1.0;  // m
    Attach attach = Attach::hoist;
    Start start = Start::flat;
    double prestretch = 0.0;  // share; 0.1 starts 10 % longer than rest in both directions
    // m, ripples that a flat flag begins with: with none (0) it stays in the plane of wind and gravity for ever.
    // Absent: a nanometre where nothing pushes out of that plane, which grows if the plane is not stable.
    std::optional<double> disturbance;
    std::string texture;  // file name; the physics ignores it
    // Share of the pole at which the flag's upper corner hangs: 1 at its top, 0.5 half-mast. What is held is hauled
    // there where it changes. Absent: at the top, and nothing hauls.
    std::optional<double> halyard{};

    bool operator==(const FlagSettings&) const = default;
};

/// The report's own numbers: every mass and every spring alike, borders too.
struct SpringSettings {
    double mass = 0.0001;                      // kg, of every mass
    double stiffness = 200.0;                  // k of structural springs, N/m; larger needs a smaller step
    std::optional<double> diagonal_stiffness;  // k of diagonal springs, N/m; absent: no diagonal springs
    std::optional<double> damping;             // c of every spring, N s/m; larger needs a smaller step
    std::optional<double> drag;                // d of every mass against the air, N s/m
    std::optional<double> friction;            // c_f of every mass, N s/m

    bool operator==(const SpringSettings&) const = default;
};

struct TimeSettings {
    Method method = method_id<SemiImplicitEuler>;
    std::optional<double> dt;  // s; absent: "auto", the largest step the closed stability bound allows
    Precision precision = Precision::single_precision;
    bool half_kick_start = false;  // of semi-implicit Euler
    // m per simulated second, the error that an automatic step may make; absent: any
    std::optional<double> tolerance{};

    bool operator==(const TimeSettings&) const = default;
};

/// What the window shows; the physics ignores it.
struct ViewSettings {
    bool texture = true;
    bool cut_out = true;  // where the texture is transparent there is no cloth to be seen
    bool cloth = true;
    bool springs = false;
    bool forces = false;
    bool masses = false;
    bool wind = false;                 // an arrow, and streaks that drift with the air
    bool reference = false;            // the same flag, computed far more accurately, as a wireframe
    bool texture_proportions = false;  // the flag takes the proportions of its texture
    Background background = Background::sky;
    bool bare_grid = false;  // flat facets between the masses, not the smooth surface through them
    bool person = false;     // a figure of 1.75 m stands beside the flag
    bool stretch = false;    // the cloth is coloured by how far it is stretched
    Colours colours = Colours::red;
    std::optional<double> force_range{};    // N, at the end of the force colours; absent: it follows the forces
    std::optional<double> stretch_range{};  // share, at the ends of the stretch colours; absent: it follows the stretch
    bool velocities = false;                // a line from masses along their velocity
    std::optional<double> velocity_range{};  // m/s, of the legend's longest line; absent: it follows the velocities

    bool operator==(const ViewSettings&) const = default;
};

struct Scene {
    std::string name = "Report";
    FlagSettings flag;
    std::optional<SpringSettings> springs{SpringSettings{}};  // one of these two gives the material
    std::optional<Fabric> fabric{};
    Terms terms;    // those with a table of their own; drag and friction stand with the material
    Limits limits;  // passes after the move
    TimeSettings time;
    ViewSettings view;

    // What either material may leave out: springs say it for each of them, a fabric for all that it is.
    std::optional<double>& diagonals() { return fabric ? fabric->diagonal_share : springs->diagonal_stiffness; }
    const std::optional<double>& diagonals() const { return const_cast<Scene*>(this)->diagonals(); }
    std::optional<double>& damping() { return fabric ? fabric->damping_time : springs->damping; }
    const std::optional<double>& damping() const { return const_cast<Scene*>(this)->damping(); }
    std::optional<double>& drag() { return fabric ? fabric->drag_per_area : springs->drag; }
    const std::optional<double>& drag() const { return const_cast<Scene*>(this)->drag(); }
    std::optional<Gravity>& gravity() { return terms.get<Gravity>(); }
    const std::optional<Gravity>& gravity() const { return terms.get<Gravity>(); }
    std::optional<Wind>& wind() { return terms.get<Wind>(); }
    const std::optional<Wind>& wind() const { return terms.get<Wind>(); }

    bool operator==(const Scene&) const = default;
};

/// The model that a scene describes.
inline Model model_of(const Scene& scene) {
    const auto& [columns, rows, width, height, attach, start, prestretch, disturbance, texture, halyard] = scene.flag;
    const Grid grid = spread(columns, rows, width, height);
    if (scene.fabric) return model_of(*scene.fabric, grid, attach, scene.terms, scene.limits);
    const SpringSettings& s = *scene.springs;
    Terms terms = scene.terms;
    if (s.drag) terms.add(AirDrag{*s.drag});
    if (s.friction) terms.add(Friction{*s.friction});
    return Model(grid, {s.mass, s.stiffness, s.diagonal_stiffness, s.damping}, attach, terms, scene.limits);
}

}  // namespace drapeau

// Scene: what is modelled, and how, as plain data. What a scene does not list (an empty optional) is not computed.
// The TOML form of the same thing is read and written by the programs, not by the core.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace drapeau {

enum class Attach { hoist, grommets, top, corner, edges, all, none };
enum class Start { flat, hanging, crumpled };
enum class Method { forward_euler, semi_implicit_euler };
enum class Precision { single_precision, double_precision };

/// The grid of masses and how it begins. Column i, row j rests at (i * width/(columns-1), -j * height/(rows-1), 0).
struct FlagSettings {
    int columns = 45;     // masses along the fly; with one column the width is unused
    int rows = 30;        // masses along the hoist; with one row the height is unused
    double width = 1.5;   // m
    double height = 1.0;  // m
    Attach attach = Attach::hoist;
    Start start = Start::flat;
    double prestretch = 0.0;  // share; 0.1 starts 10 % longer than rest in both directions
    std::string texture;      // file name; the physics ignores it

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

struct GravitySettings {
    glm::dvec3 acceleration{0.0, -9.8, 0.0};  // m/s2

    bool operator==(const GravitySettings&) const = default;
};

/// Wind is a pure function of (seed, absolute time): mean + gusts. Felt through drag.
struct WindSettings {
    glm::dvec3 velocity{0.0};  // m/s, the mean
    glm::dvec3 gusts{0.0};     // m/s, rms on each axis
    double period = 1.5;       // s, how fast gusts change; larger is slower
    std::uint64_t seed = 1;

    bool operator==(const WindSettings&) const = default;
};

struct TimeSettings {
    Method method = Method::semi_implicit_euler;
    std::optional<double> dt;  // s; absent: "auto", the largest step the closed stability bound allows
    Precision precision = Precision::single_precision;

    bool operator==(const TimeSettings&) const = default;
};

/// What the window shows; the physics ignores it.
struct ViewSettings {
    bool texture = true;
    bool cloth = true;
    bool springs = false;
    bool forces = false;
    bool masses = false;
    bool texture_proportions = false;  // the flag takes the proportions of its texture

    bool operator==(const ViewSettings&) const = default;
};

struct Scene {
    std::string name = "Report";
    FlagSettings flag;
    SpringSettings springs;
    std::optional<GravitySettings> gravity;
    std::optional<WindSettings> wind;
    TimeSettings time;
    ViewSettings view;

    bool operator==(const Scene&) const = default;
};

}  // namespace drapeau

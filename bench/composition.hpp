// Composition: a flag composed in C++ by who embeds the core, as a subject. It is compiled for this machine and the
// programs are not, so what is handed over is plain numbers.
#pragma once

#include "subject.hpp"

#include "drapeau/field.hpp"

#include <memory>

namespace drapeau {
enum class Attach;
}

namespace drapeau::bench {

/// Numbers of a model; what it lists besides structural springs.
struct Composition {
    int columns, rows;
    double pitch_x, pitch_y;  // m
    Attach attach;
    double mass, stiffness, diagonal_stiffness, damping;  // kg, N/m, N/m, N s/m
    double gravity[3], drag, wind[3];                     // m/s2, N s/m, m/s
    bool has_diagonals, is_damped, has_gravity, has_drag, has_wind;
    bool in_double;
    Field<const double> position, velocity;  // of the start state; outlive the subject
};

/// Whole steps of the flag with semi-implicit Euler.
std::unique_ptr<Subject> make_composition(const Composition& c);

}  // namespace drapeau::bench

// Cases: what the benchmark times. One case is one kind of work on one grid.
#pragma once

#include "scene.hpp"

#include <string>
#include <vector>

namespace drapeau::bench {

enum class Work {
    step,      // whole steps, as the programs take them (Engine)
    terms,     // whole steps of a flag composed in C++, its terms switched off one by one
    forces,    // the springs' forces, stored instead of applied
    snapshot,  // what the renderer is handed each frame: a copy of the state; the upload by OpenGL is not in it
    copy,      // the plain copy of a state, memcpy of its six components
    report     // whole steps of the report's own arrangement
};

struct Terms {
    bool diagonal = true, damping = true, gravity = true, drag = true, wind = true;

    bool operator==(const Terms&) const = default;
    /// Names of what is there, "structural" first.
    std::vector<std::string> names() const;
    /// "all", or what is missing: "no-damping".
    std::string label() const;
};

struct Case {
    Work work = Work::step;
    int columns = 2, rows = 2;
    Method method = Method::semi_implicit_euler;
    Precision precision = Precision::single_precision;
    int threads = 1;
    Terms terms = {};

    std::string name() const;  // step/64x64/semi-implicit-euler/float/threads:1/all
    long long masses() const { return static_cast<long long>(columns) * rows; }
    std::size_t bytes_a_real() const { return precision == Precision::single_precision ? 4 : 8; }
    std::size_t state_bytes() const { return static_cast<std::size_t>(masses()) * 6 * bytes_a_real(); }
};

const char* name_of(Work work);

/// Every case, grouped by work; within a group by grid.
std::vector<Case> all_cases();

/// The flag all cases fly: the report's model, its masses as far apart as on a flag of 1.5 m and 45 columns.
Scene flag_scene(int columns, int rows, Method method, const Terms& terms);

}  // namespace drapeau::bench

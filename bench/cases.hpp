// Cases: what the benchmark times. One case is one kind of work on one grid.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drapeau::bench {

enum class Work {
    step,       // whole steps, as the programs take them (Engine)
    watched,    // whole batches as the programs take them: steps, ledger, readings and snapshots (Simulation)
    accounted,  // whole steps that sum the work of every force
    measure,    // energy and stretch of the state as it is
    terms,      // whole steps of a flag composed in C++, its terms switched off one by one
    mode,       // one look at the fastest mode, which the live limit takes for every thirty steps
    forces,     // accelerations stored instead of applied
    snapshot,   // what the renderer is handed each frame: a copy of the positions; the upload by OpenGL is not in it
    copy,       // the plain copy of a state, memcpy of its six components
    report      // whole steps of the report's own arrangement
};

enum class Blowing { still, steady, travelling_x, travelling_xy };

/// What a case's model lists besides masses and structural springs.
struct Listing {
    bool diagonal = true, damping = true, gravity = true, drag = true;
    Blowing wind = Blowing::steady;
    bool limit = false;
    bool faces = false;  // the air on faces, instead of drag
    bool bending = false;
    bool contacts = false;  // ground and pole

    bool operator==(const Listing&) const = default;
    /// Names of what is there, "structural" first.
    std::vector<std::string> names() const;
    /// "all", or what is missing or more than usual: "no-damping", "travelling".
    std::string label() const;
};

struct Case {
    Work work = Work::step;
    int columns = 2, rows = 2;
    Method method = method_id<SemiImplicitEuler>;
    Precision precision = Precision::single_precision;
    int threads = 1;
    Listing listing = {};

    std::string name() const;  // step/64x64/semi-implicit-euler/float/threads:1/all
    long long masses() const { return static_cast<long long>(columns) * rows; }
    std::size_t bytes_a_real() const { return precision == Precision::single_precision ? 4 : 8; }
};

const char* name_of(Work work);
bool takes_steps(Work work);

/// Every case, grouped by work; within a group by grid.
std::vector<Case> all_cases();

/// The flag a case flies: the report's model, its masses as far apart as on a flag of 1.5 m and 45 columns. Its step is
/// the automatic one.
Scene scene_of(const Case& c);

}  // namespace drapeau::bench

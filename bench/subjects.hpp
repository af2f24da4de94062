// Subjects: what is timed, each able to return to its start state and to repeat its work.
#pragma once

#include "cases.hpp"

#include "run/engine.hpp"

#include <cstdint>
#include <memory>

namespace drapeau::bench {

class Subject {
public:
    virtual ~Subject() = default;
    virtual void restore() = 0;
    /// Does the work `times` times: as many steps, copies, evaluations.
    virtual void run(int times) = 0;
    /// Of the bits of the result, padding excluded; comparable among subjects of the same work and precision.
    virtual std::uint64_t hash() const = 0;
    /// Of the state (share); NaN if it is not finite.
    virtual double greatest_stretch() const = 0;

    double dt = 0.0;  // s, the step of subjects that take steps
};

/// The subject of a case, in its start state.
std::unique_ptr<Subject> make_subject(const Case& c, const Masses& start);

/// Whole steps of a flag composed in C++ from the case's terms.
std::unique_ptr<Subject> make_composition(const Case& c, const Masses& start);

/// A flag in flight: rippled, every mass moving, flown for a moment by the core in double.
const Masses& start_state(int columns, int rows);

/// The step (s) "auto" takes: 0.9 of the stable one, a whole number of them in 1/60 s.
double auto_step(double largest_stable);

}  // namespace drapeau::bench

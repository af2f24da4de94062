// Subjects of the cases.
#pragma once

#include "cases.hpp"
#include "subject.hpp"

#include <memory>

namespace drapeau::bench {

/// The subject of a case, in its start state; `start` outlives it. Watched batches begin at rest, as programs do.
std::unique_ptr<Subject> make_subject(const Case& c, const State<double>& start);

/// The plain steps that a case of watched, accounted or measured ones is compared with, of the same state.
std::unique_ptr<Subject> make_plain_rival(const Case& c, const State<double>& start);

/// A flag in flight: rippled, every mass moving, flown for a moment by the core in double.
const State<double>& flying_state(int columns, int rows);

/// The step (s) that "auto" takes.
double auto_step(Method method, const Model& model);

}  // namespace drapeau::bench

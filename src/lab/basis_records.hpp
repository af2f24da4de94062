// Basis records: what part files of every comparison of motions keep alike: numbers, distances, statistics, and what
// points are judged by. What is not finite is null in JSON. Reading throws Json::exception or std::out_of_range for
// what no sweep wrote.
#pragma once

#include "measure/basis.hpp"
#include "parts.hpp"

namespace drapeau::lab {

/// Any number; NAN for null.
double number(const Json& json);
/// One that is not below zero: a distance, an error, a time; NAN for null.
double amount(const Json& json);
/// The same where there must be one.
double known_amount(const Json& json);
/// A whole number above zero, small enough for all that is made of it.
long long count(const Json& json);

Json apart_json(const Apart& apart);
Apart apart_in(const Json& json);
TipStatistics statistics_in(const Json& json);

Json basis_json(const Basis& basis);
Basis basis_in(const Json& json);

}  // namespace drapeau::lab

// Trade analysis: what follows from the points measured: the efficient front, orders, the setting to recommend.
#pragma once

#include "measure/trade_measure.hpp"

#include <vector>

namespace drapeau {

/// Places in the list of those that no other point beats in both error and cost, the cheapest first. Points that
/// diverged, that were not measured or whose error is below what the reference resolves are left out.
std::vector<std::size_t> efficient_front(const std::vector<Measured>& points);

/// The order that errors show, from the finest steps that the reference resolves, in double.
struct OrderFit {
    std::size_t variant = 0;
    Method method{};
    double order = 0.0;
    int points = 0;
};
std::vector<OrderFit> orders_of(const std::vector<Measured>& points);

/// ms of processor time a simulated second that the steps of one that diverged would take: as those of the same method,
/// of the same precision if there are some. NAN where none was measured.
double expected_cost(const std::vector<Measured>& points, const Measured& diverged);

/// Whether the error, at the end and over the time, is at most `tolerance` (m), as far as the reference can tell.
bool meets(const Measured& point, double tolerance);

/// The places of those that meet it, the cheapest first.
std::vector<std::size_t> all_within(const std::vector<Measured>& points, double tolerance);

}  // namespace drapeau

// Budget: what a comparison of motions may take.
#pragma once

#include "io/error.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <string>

namespace drapeau {

/// The budget does not suffice for what must be done before anything can be compared.
class BudgetError : public InputError {
public:
    /// `least`, `allowed`: s.
    BudgetError(const std::string& what_takes, double least, double allowed)
        : InputError(fmt::format(
              "--budget: {} take about {} min, and {} min is allowed; allow more, or compare fewer --seconds",
              what_takes, rounded(least / 60.0, 2), rounded(allowed / 60.0, 3))),
          least_(least) {}
    double least() const { return least_; }  // s

private:
    double least_;
};

}  // namespace drapeau

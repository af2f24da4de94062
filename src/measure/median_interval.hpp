// The median of few numbers, and an interval that holds the median they were drawn around, whatever their distribution.
//
// Each of n independent draws lies below the true median with probability 1/2, so the number of draws below it is
// binomial. With the draws in order, x_1 <= .. <= x_n, the interval [x_k, x_{n+1-k}] misses the median only if fewer
// than k draws lie on one of its sides:
//
//   P(x_k <= median <= x_{n+1-k}) = 1 - 2 sum_{i<k} C(n, i) / 2^n
//
// The interval takes the largest k that keeps this at 95 % or more. Source: W. R. Thompson, On confidence ranges for
// the median and other expectation distributions for populations of unknown distribution form, Ann. Math. Stat. 7
// (1936).
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace drapeau {

struct MedianInterval {
    double median, low, high;
    double coverage;  // probability that [low, high] holds the true median; never less where draws can be equal
};

constexpr double min_coverage = 0.95;
constexpr int min_draws = 6;  // even [x_1, x_5] of five draws has a coverage of 93.75 % only

/// Probability that [x_k, x_{n+1-k}] holds the median, 1 <= k <= (n + 1) / 2.
inline double coverage_of_order_statistics(int n, int k) {
    // C(n, i) / 2^n by its logarithm: neither factor fits a double for a thousand draws.
    const double log_all = n * std::log(2.0);
    double log_term = -log_all, below = 0.0;
    for (int i = 0; i < k; ++i) {
        below += std::exp(log_term);
        log_term += std::log(n - i) - std::log(i + 1);
    }
    return 1.0 - 2.0 * below;
}

/// The k of the narrowest interval with enough coverage.
inline int rank_of_lower_end(int n) {
    assert(n >= min_draws);
    int k = 1;
    while (2 * (k + 1) <= n && coverage_of_order_statistics(n, k + 1) >= min_coverage) ++k;
    return k;
}

inline MedianInterval median_interval(std::vector<double> draws) {
    std::sort(draws.begin(), draws.end());
    const int n = static_cast<int>(draws.size()), k = rank_of_lower_end(n);
    return {.median = (draws[(n - 1) / 2] + draws[n / 2]) / 2.0,
            .low = draws[k - 1],
            .high = draws[n - k],
            .coverage = coverage_of_order_statistics(n, k)};
}

}  // namespace drapeau

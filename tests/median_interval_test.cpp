#include "measure/median_interval.hpp"

#include "catch.hpp"

#include <limits>
#include <numeric>
#include <random>

using namespace drapeau;

namespace {

/// 1, 2, .. n in a shuffled order: x_k is k.
std::vector<double> ranks(int n) {
    std::vector<double> all(n);
    std::iota(all.begin(), all.end(), 1.0);
    std::shuffle(all.begin(), all.end(), std::minstd_rand(1));
    return all;
}

}  // namespace

TEST_CASE("The median's interval takes the ranks and has the coverage of the binomial distribution") {
    // Counted by hand: 1 - 2 sum_{i<k} C(n, i) / 2^n for the largest k that keeps it above 0.95.
    struct Expected {
        int n, k;
        double coverage;
    };
    for (const auto& e :
         {Expected{6, 1, 31.0 / 32.0},              // 1 - 2 * 1 / 64
          Expected{8, 1, 127.0 / 128.0},            // 1 - 2 * 1 / 256; with k = 2 only 119/128
          Expected{9, 2, 123.0 / 128.0},            // 1 - 2 * (1 + 9) / 512
          Expected{11, 2, 253.0 / 256.0},           // 1 - 2 * (1 + 11) / 2048
          Expected{20, 6, 125647.0 / 131072.0}}) {  // 1 - 2 * (1 + 20 + 190 + 1140 + 4845 + 15504) / 2^20
        CAPTURE(e.n);
        const auto interval = median_interval(ranks(e.n));
        CHECK(interval.median == (e.n + 1) / 2.0);
        CHECK(interval.low == e.k);
        CHECK(interval.high == e.n + 1 - e.k);
        // A dozen exponentials and their sum, each right to some units in the last place
        CHECK(interval.coverage == Approx(e.coverage).epsilon(1e-13));
    }
}

TEST_CASE("Fewer draws than six have no interval of 95 %, and six are enough") {
    CHECK(coverage_of_order_statistics(min_draws - 1, 1) < min_coverage);
    CHECK(coverage_of_order_statistics(min_draws, 1) >= min_coverage);
}

TEST_CASE("Thousands of draws neither overflow nor lose their coverage") {
    const int n = 5000, k = rank_of_lower_end(n);
    CHECK(coverage_of_order_statistics(n, k) >= min_coverage);
    CHECK(coverage_of_order_statistics(n, k + 1) < min_coverage);
    // Nearly normal: k = n / 2 - 1.96 sqrt(n) / 2, and the steps between two k are wider than what differs.
    CHECK(std::abs(k - (n / 2.0 - 1.96 * std::sqrt(n) / 2.0)) < 2.0);
}

TEST_CASE("One wild draw on each side moves neither the median nor the interval of eleven") {
    auto draws = ranks(11);
    *std::find(draws.begin(), draws.end(), 11.0) = std::numeric_limits<double>::infinity();
    *std::find(draws.begin(), draws.end(), 1.0) = -1e300;
    const auto interval = median_interval(draws);
    CHECK(interval.median == 6.0);
    CHECK(interval.low == 2.0);
    CHECK(interval.high == 10.0);
}

TEST_CASE("Intervals hold the median as often as they claim, of a lopsided distribution too") {
    // exp of an exponential draw: its median is 2, its mean infinite.
    std::mt19937 random(7);
    std::exponential_distribution<double> exponential;
    constexpr int n = 20, trials = 4000;
    int held = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> draws(n);
        for (double& draw : draws) draw = std::exp(exponential(random));
        const auto interval = median_interval(draws);
        held += interval.low <= 2.0 && 2.0 <= interval.high;
    }
    // Four standard deviations of a count of 4000 with probability 0.9586: 4 sqrt(0.9586 * 0.0414 / 4000) = 0.0126
    CHECK(std::abs(held / double(trials) - 0.9586) < 0.0126);
}

// What threads share, in tests that the thread sanitizer watches: without it a race may well go unseen.
#include "drapeau/team.hpp"

#include "catch.hpp"

using namespace drapeau;

TEST_CASE("Beyond a barrier every thread sees what all others wrote before it", "[threads]") {
    constexpr int threads = 3, rounds = 2000;
    SpinBarrier barrier(threads);
    Workers workers(threads);
    // Two sets in turns, as the seams of a team: one is written while the other is read.
    long long written[2][threads] = {};
    int missed[threads] = {};
    workers.run([&](int n) {
        for (int round = 1; round <= rounds; ++round) {
            auto& now = written[round % 2];
            now[n] = round;
            barrier.wait();
            for (const long long other : now) missed[n] += other != round;
        }
    });
    for (const int count : missed) CHECK(count == 0);
}

TEST_CASE("Every worker does every job once, and the caller sees what it did", "[threads]") {
    for (const int threads : {1, 2, 4}) {
        Workers workers(threads);
        REQUIRE(workers.count() == threads);
        std::vector<int> done(threads);
        for (int job = 1; job <= 500; ++job) {
            workers.run([&](int n) { ++done[n]; });
            for (const int times : done) REQUIRE(times == job);
        }
    }
}

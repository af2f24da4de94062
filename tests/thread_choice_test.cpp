// ThreadChoice: on an idle machine most threads share a step, on a busy one few do, and it follows when that changes.
#include "catch.hpp"

#include "viewer/thread_choice.hpp"

#include <set>

using namespace drapeau;

namespace {

/// s a step, of work that takes 1 s on one thread: shared evenly where each thread has a processor to itself; else
/// every step lasts until the system lets the last one run.
double seconds_with(int threads, int idle_processors) {
    constexpr double meeting = 0.01, put_aside = 4.0;
    return threads <= idle_processors ? 1.0 / threads + meeting * threads : put_aside;
}

/// The number in use after so many batches, and what they took in all.
double seconds_of(ThreadChoice& choice, int batches, int idle_processors) {
    double seconds = 0.0;
    for (int n = 0; n < batches; ++n) {
        const double one = seconds_with(choice.threads(), idle_processors);
        choice.took(one);
        seconds += one;
    }
    return seconds;
}

}  // namespace

TEST_CASE("threads that all have a processor share every step, but for a few trials") {
    ThreadChoice choice(7);
    CHECK(choice.threads() == 7);
    const double seconds = seconds_of(choice, 1000, 8);
    // Trials follow each other at twice the distance every time, and one takes 0.36 instead of 0.21.
    CHECK(seconds < 1.02 * 1000 * seconds_with(7, 8));
    CHECK(choice.threads() == 7);
}

TEST_CASE("on a busy machine it comes to as few as are faster, soon") {
    for (const int idle : {1, 2, 3}) {
        ThreadChoice choice(15);
        CAPTURE(idle);
        seconds_of(choice, 40, idle);  // two thirds of a second of simulated time
        CHECK(seconds_of(choice, 1000, idle) < 1.1 * 1000 * seconds_with(idle == 1 ? 1 : 2, idle));
    }
}

TEST_CASE("what it comes to follows the machine") {
    ThreadChoice choice(8);
    seconds_of(choice, 500, 1);
    CHECK(choice.threads() <= 2);
    seconds_of(choice, 4000, 8);  // a minute
    CHECK(seconds_of(choice, 100, 8) < 1.3 * 100 * seconds_with(8, 8));
    seconds_of(choice, 100, 1);
    CHECK(seconds_of(choice, 1000, 1) < 1.1 * 1000 * seconds_with(1, 1));
}

TEST_CASE("a machine that becomes busy is noticed within some batches, however long all was well") {
    for (int before = 3000; before < 3000 + 40; ++before) {
        CAPTURE(before);
        ThreadChoice choice(8);
        seconds_of(choice, before, 16);
        REQUIRE(choice.threads() >= 4);
        // Three slow ones show it, a pair lie between three trials, of which the one with one thread is faster.
        constexpr int enough = 3 + 3 * (2 + 1);
        CHECK(seconds_of(choice, enough + 100, 1) < enough * seconds_with(8, 1) + 1.15 * 100 * seconds_with(1, 1));
    }
}

TEST_CASE("one thread stays alone") {
    ThreadChoice choice(1);
    std::set<int> used;
    for (int n = 0; n < 100; ++n) {
        used.insert(choice.threads());
        choice.took(1.0 + n % 3);
    }
    CHECK(used == std::set{1});
}

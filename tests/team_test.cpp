// What threads share, in tests that the thread sanitizer watches: without it a race may well go unseen.
#include "drapeau/team.hpp"

#include "catch.hpp"
#include "sanitized.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <vector>
#include <system_error>
#include <thread>

using namespace drapeau;
using testing::sanitized;  // sanitizers need more address space than a test can take away

TEST_CASE("Where members meet every one sees what all others wrote before", "[threads]") {
    constexpr int members = 3, rounds = 2000;
    Team team(members);
    // Two sets in turns, as the halos of a stepper: one is written while the other is read.
    long long written[2][members] = {};
    int missed[members] = {};
    team.run([&](int n) {
        for (int round = 1; round <= rounds; ++round) {
            auto& now = written[round % 2];
            now[n] = round;
            team.meet();
            for (const long long other : now) missed[n] += other != round;
        }
    });
    for (const int count : missed) CHECK(count == 0);
}

TEST_CASE("Every member runs every region once, and the caller sees what it did", "[threads]") {
    for (const int members : {1, 2, 4}) {
        Team team(members);
        REQUIRE(team.members() == members);
        std::vector<int> done(members);
        for (int region = 1; region <= 500; ++region) {
            team.run([&](int n) { ++done[n]; });
            for (const int times : done) REQUIRE(times == region);
        }
    }
}

TEST_CASE("The caller is member 0", "[threads]") {
    Team team(2);
    std::thread::id of[2];
    team.run([&](int n) { of[n] = std::this_thread::get_id(); });
    CHECK(of[0] == std::this_thread::get_id());
    CHECK(of[1] != of[0]);
}

TEST_CASE("A team that the system gives too few threads for throws, and leaves none behind", "[threads]") {
    if (sanitized) return;
    // In a child of its own, which has so little address space left that some of a thousand stacks of 8 MiB fit and
    // not all. It ends with 0 if the team threw, its threads were joined and a smaller team works; a hang is ended by
    // its alarm.
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        alarm(20);
        const auto threads_here = [] {
            int count = -1;
            if (FILE* status = std::fopen("/proc/self/status", "r")) {
                char line[256];
                while (std::fgets(line, sizeof line, status)) std::sscanf(line, "Threads: %d", &count);
                std::fclose(status);
            }
            return count;
        };
        long long pages = 0;
        if (FILE* size = std::fopen("/proc/self/statm", "r")) {
            if (std::fscanf(size, "%lld", &pages) != 1) _exit(5);
            std::fclose(size);
        }
        const auto used = static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE));
        const rlim_t limit = used + (rlim_t{200} << 20);
        const rlimit little{limit, limit};
        if (setrlimit(RLIMIT_AS, &little) != 0) _exit(4);
        try {
            Team team(1000);
            _exit(1);
        } catch (const std::system_error&) {
        } catch (...) {
            _exit(2);
        }
        if (threads_here() != 1) _exit(3);
        Team small(3);
        int done[3] = {};
        small.run([&](int n) { done[n] = 1; });
        _exit(done[0] + done[1] + done[2] == 3 ? 0 : 6);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

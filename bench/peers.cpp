#include "peers.hpp"

#include "subjects.hpp"

#include "io/error.hpp"

#include "run/engine.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace drapeau::bench {

#if defined(DRAPEAU_PEER_BULLET)

namespace {

Flight fly_core(const Case& c) {
    const auto engine = make_engine(model_of(scene_of(c)), c.method, c.precision);
    const Clock clock{.dt = auto_step(c.method, engine->model())};
    const auto steps = std::llround(batch_seconds / clock.dt);

    Flight flight{std::numeric_limits<double>::max(), -1.0};
    Report report;
    for (long long frame = 0; frame < frames_flown; ++frame) {
        const auto begin = std::chrono::steady_clock::now();
        engine->advance(clock, frame * steps, (frame + 1) * steps, no_step, report, nullptr);
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        if (frame < frames_flown - frames_watched) continue;
        flight.ms_a_frame = std::min(flight.ms_a_frame, ms);
        flight.greatest_stretch =
            std::max(flight.greatest_stretch, engine->measure(clock.at((frame + 1) * steps)).max_stretch);
    }
    return flight;
}

void print(const char* who, const std::string& how, const Flight& flight) {
    std::printf("  %-8s  %-28s  %10.3f  %10.2f\n", who, how.c_str(), flight.ms_a_frame,
                100.0 * flight.greatest_stretch);
    std::fflush(stdout);
}

}  // namespace

void run_peers() {
    struct Size {
        int columns, rows;
    };
    for (const auto& [columns, rows] : {Size{45, 30}, Size{128, 128}}) {
        const Case c{.columns = columns, .rows = rows};
        const Flight core = fly_core(c);
        std::printf("%d x %d masses\n  %-8s  %-28s  %10s  %10s\n", columns, rows, "who", "how", "ms a frame",
                    "stretch, %");
        print("drapeau", "semi-implicit-euler, auto", core);

        // Smaller steps stiffen Bullet's cloth; the first that is about as stiff as the core's is the one to compare.
        constexpr int iterations = 4, max_substeps = 64;
        constexpr double about = 1.1;
        bool as_stiff = false;
        for (int substeps = 1; substeps <= max_substeps && !as_stiff; substeps *= 2) {
            const Flight bullet = fly_bullet(scene_of(c), substeps, iterations);
            as_stiff = bullet.greatest_stretch <= about * core.greatest_stretch;
            print("Bullet", std::to_string(substeps) + " substeps of " + std::to_string(iterations) + " iterations",
                  bullet);
            if (as_stiff)
                std::printf("  At equal greatest stretch drapeau takes %.2f of Bullet's time.\n",
                            core.ms_a_frame / bullet.ms_a_frame);
        }
        if (!as_stiff) std::printf("  Bullet does not get as stiff with %d substeps a frame.\n", max_substeps);
    }
}

#else

void run_peers() {
    throw InputError("no peer was compiled in: install libbullet-dev, configure and build again");
}

#endif

}  // namespace drapeau::bench

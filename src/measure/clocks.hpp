// Clocks: the processor time this process has used, whatever else the machine does meanwhile, and time on the wall.
#pragma once

#include <chrono>
#include <ctime>

namespace drapeau {

/// s of processor time of all threads since the process began; only differences mean anything.
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// s of time on the wall; likewise.
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace drapeau

// Clocks: the processor time this thread, or this process, has used, whatever else goes on meanwhile, and time on the
// wall.
#pragma once

#include <chrono>
#include <ctime>

namespace drapeau {

/// s of processor time of all threads, or of the one that asks; only differences mean anything.
inline double processor_seconds(clockid_t whose = CLOCK_PROCESS_CPUTIME_ID) {
    timespec now{};
    clock_gettime(whose, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
inline double thread_seconds() {
    return processor_seconds(CLOCK_THREAD_CPUTIME_ID);
}

/// s of time on the wall; likewise.
inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace drapeau

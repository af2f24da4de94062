// Interruption: whether a signal has asked the program to end, for work that first removes what it has not finished.
#pragma once

#include <array>
#include <csignal>

namespace drapeau {

/// While it lives, SIGINT, SIGTERM and SIGHUP are only noted. One that the program was started to ignore stays ignored.
class Interruption {
public:
    Interruption() {
        received = 0;
        for (std::size_t n = 0; n < signals.size(); ++n) {
            before_[n] = std::signal(signals[n], [](int signal) { received = signal; });
            if (before_[n] == SIG_IGN) std::signal(signals[n], SIG_IGN);
        }
    }
    ~Interruption() {
        for (std::size_t n = 0; n < signals.size(); ++n) std::signal(signals[n], before_[n]);
    }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    int signal() const { return received; }  // the last one; 0: none

private:
    static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
    static inline volatile std::sig_atomic_t received = 0;
    std::array<void (*)(int), 3> before_{};
};

}  // namespace drapeau

// Step aside: what a thread does whose work nobody waits for.
#pragma once

#include <unistd.h>

namespace drapeau {

/// Lets every other thread go first, the more the further it steps; on Linux this thread alone is meant.
inline void step_aside(int below_others = 10) {
    static_cast<void>(nice(below_others));
}

}  // namespace drapeau

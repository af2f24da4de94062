// drapeau-lab run: simulates a scene for a time, says what it cost and writes where every mass is.
#pragma once

#include <string>
#include <vector>

namespace drapeau::lab {

struct RunOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::string seconds;           // s of simulated time
    std::string method;            // "" is the scene's own, as with dt and precision
    std::string dt;                // s, or "auto"
    std::string precision;         // float or double
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    int threads = 1;
    std::string state;  // files to write; "" writes none
    std::string json;
    std::string csv;
    bool force = false;  // whatever time it is estimated to take
};

/// The exit status: good or diverged. Throws InputError for bad input, before anything is computed or written.
int run(const RunOptions& options);

}  // namespace drapeau::lab

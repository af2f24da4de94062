// drapeau-lab stability: the largest stable step of every method over stiffness and damping, measured and in theory.
#pragma once

#include "part_file.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

struct StabilityOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    // Lists, separated by commas; "" is every method, and some around what the scene says.
    std::string methods;
    std::string stiffness;  // N/m
    std::string damping;    // N s/m
    std::string json;       // files to write; "" writes none
    std::string plot;
    PartOptions part;
};

/// The exit status. Throws InputError for bad input, before anything is computed or written.
int stability(const StabilityOptions& options);

}  // namespace drapeau::lab

// drapeau-lab price: what each part of a scene costs in time and what leaving it out changes, and the smallest scene
// that stays within a tolerance.
#pragma once

#include <string>
#include <vector>

namespace drapeau::lab {

struct PriceOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    std::string settle = "2";      // s
    std::string seconds;           // s; "" is 0.5, or less where the motion is chaotic
    std::string budget = "2";      // minutes
    std::string tolerance;         // "1mm"; "" leaves nothing out
    std::string write;             // files to write; "" writes none
    std::string json;
    std::string plot;  // a picture, .svg or .png; "" draws none
};

/// The exit status: good, not met or diverged. Throws InputError for bad input, before anything is computed or written.
int price(const PriceOptions& options);

}  // namespace drapeau::lab

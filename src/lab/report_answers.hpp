// Report answers: from what a command found, as its JSON has it, a sentence or two for who reads no further.
#pragma once

#include "parts.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

std::vector<std::string> trade_answers(const Json& found, const Scene& scene);
std::vector<std::string> stability_answers(const Json& found, const Scene& scene);
std::vector<std::string> price_answers(const Json& found, const Scene& scene);
std::vector<std::string> converge_answers(const Json& found, const Scene& scene);

}  // namespace drapeau::lab

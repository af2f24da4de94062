// Comparison options: what every comparison of a scene's motions takes on the command line, and what that means.
#pragma once

#include "io/command_line.hpp"
#include "measure/comparison_request.hpp"
#include "part_file.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

struct ComparisonOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    std::string settle = "2";      // s
    std::string seconds;           // s; "" is 0.5, or less where the motion is chaotic
    std::string budget = "2";      // minutes
    std::string tolerance;         // "1mm"; "" asks for none
    PartOptions part;
};

/// Adds them to a command, their defaults being what they are; --tolerance where `tolerance` says what it does.
void add_comparison_options(CLI::App& command, ComparisonOptions& options, const std::string& tolerance = "");

/// Reads all but the scene into the request. Throws InputError that names the option, its value and what is allowed.
void read_comparison(const ComparisonOptions& options, ComparisonRequest& request);

/// Throws InputError where motions are compared past the horizon (s), so that nothing holds within a tolerance there.
void check_tolerance(const ComparisonOptions& options, double compared, double horizon);

// What of them identifies a sweep, the scene apart.
Json comparison_json(const ComparisonOptions& options);
/// Throws Json::exception.
void read_comparison_json(const Json& json, ComparisonOptions& options);

}  // namespace drapeau::lab

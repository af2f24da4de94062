// Converge report: what was found of steps and grids, as tables for a person and as JSON for programs.
#pragma once

#include "converge_sweep.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace drapeau::lab {

/// What was compared, and what is known of it: a few lines.
std::string compared_text(const ConvergeRequest& request, const ConvergeFindings& found);
std::string steps_table(const ConvergeFindings& found);
std::string grids_table(const ConvergeRequest& request, const ConvergeFindings& found);
nlohmann::ordered_json as_json(const ConvergeRequest& request, const ConvergeFindings& found);

}  // namespace drapeau::lab

// Price report: what a study found, as tables for a person and as JSON for programs.
#pragma once

#include "measure/price_study.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace drapeau::lab {

/// What was compared, and what is known of it: a few lines.
std::string compared_text(const PriceStudy& study);
std::string parts_table(const PriceStudy& study, const Prices& prices);
/// What can be left out within the tolerance, what that saves, and whether it holds.
std::string reduction_text(const PriceStudy& study, const Reduction& reduction);
/// Whether something was left out, and its check held.
bool holds(const PriceStudy& study, const Reduction& reduction);

/// The scene that is left as a file, each thing left out as a comment. `file`: the scene's own.
std::string reduced_text(const PriceStudy& study, const Reduction& reduction, const std::filesystem::path& file);

nlohmann::ordered_json as_json(const PriceStudy& study, const Prices& prices,
                               const std::optional<Reduction>& reduction);

}  // namespace drapeau::lab

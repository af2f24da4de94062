// What a command measured: one list that becomes a table for a person, a JSON object and a CSV row for programs.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace drapeau::lab {

struct Result {
    std::string key;       // for programs, with its unit: "kinetic_energy_J"
    nlohmann::json value;  // for programs; a number that is not finite is null, in CSV nothing
    std::string label;     // for a person; "" leaves it out of the table
    std::string text;      // for a person, with its unit
};

std::string as_table(const std::vector<Result>& results);
std::string as_json(const std::vector<Result>& results);
/// A header and a row, as RFC 4180 has them.
std::string as_csv(const std::vector<Result>& results);

}  // namespace drapeau::lab

// What a command measured: one list that becomes a table for a person, a JSON object and a CSV row for programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drapeau::lab {

struct Result {
    std::string key;    // for programs, with its unit: "kinetic_energy_J"
    std::string value;  // for programs: a JSON value
    std::string label;  // for a person; "" leaves it out of the table
    std::string text;   // for a person, with its unit
};

/// A number for programs: shortest round-trip digits, null if it is not finite.
std::string json_number(double value);

std::string as_table(const std::vector<Result>& results);
std::string as_json(const std::vector<Result>& results);
std::string as_csv(const std::vector<Result>& results);

}  // namespace drapeau::lab

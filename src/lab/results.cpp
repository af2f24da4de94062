#include "results.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

/// A field of a CSV row. (A number reads the same in JSON.)
std::string csv_field(const nlohmann::json& value) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) return "";
    if (!value.is_string()) return value.dump();
    std::string text = value;
    if (text.find_first_of("\",\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string as_table(const std::vector<Result>& results) {
    std::size_t width = 0;
    for (const Result& result : results) width = std::max(width, result.label.size());
    std::string table;
    for (const Result& result : results) {
        if (result.label.empty()) continue;
        table += result.label + std::string(width + 2 - result.label.size(), ' ') + result.text + "\n";
    }
    return table;
}

std::string as_json(const std::vector<Result>& results) {
    nlohmann::ordered_json object;
    for (const Result& result : results) object[result.key] = result.value;
    return object.dump(2) + "\n";
}

std::string as_csv(const std::vector<Result>& results) {
    std::string header, row;
    for (const Result& result : results) {
        const std::string_view separator = header.empty() ? "" : ",";
        header.append(separator).append(result.key);
        row.append(separator).append(csv_field(result.value));
    }
    return header + "\n" + row + "\n";
}

}  // namespace drapeau::lab

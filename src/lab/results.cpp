#include "results.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

std::string json_number(double value) {
    return std::isfinite(value) ? shortest(value) : "null";
}

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
    std::string json = "{\n";
    for (const Result& result : results) {
        json += "  " + in_quotes(result.key) + ": " + result.value + (&result == &results.back() ? "\n" : ",\n");
    }
    return json + "}\n";
}

std::string as_csv(const std::vector<Result>& results) {
    std::string header;
    std::string row;
    for (const Result& result : results) {
        const std::string_view separator = header.empty() ? "" : ",";
        header.append(separator).append(result.key);
        row.append(separator).append(result.value == "null" ? "" : result.value);
    }
    return header + "\n" + row + "\n";
}

}  // namespace drapeau::lab

#include "compare.hpp"

#include "io/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace drapeau::bench {
namespace {

std::vector<Minimum> minima_in_file(const std::string& file) {
    if (std::filesystem::is_directory(file)) throw InputError(file + " is a folder, not a file of this benchmark");
    std::ifstream stream(file);
    if (!stream) throw InputError(file + " cannot be read: " + std::strerror(errno));
    return minima_in(stream, file);
}

}  // namespace

std::vector<Minimum> minima_in(std::istream& results, const std::string& source) {
    std::vector<Minimum> minima;
    try {
        const auto parsed = nlohmann::json::parse(results);
        for (const auto& c : parsed.at("cases")) {
            const double ns = c.at("ns_per_mass_step").at("min").get<double>();
            if (!(std::isfinite(ns) && ns > 0.0)) throw InputError(source + ": a time is not above zero");
            minima.push_back({c.at("name").get<std::string>(), ns});
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(source + " is not a result of this benchmark (JSON with an array \"cases\")");
    }
    return minima;
}

void compare_files(const std::string& file_a, const std::string& file_b) {
    const auto a = minima_in_file(file_a), b = minima_in_file(file_b);
    int both = 0;
    double logarithms = 0.0;
    std::printf("%-64s  %9s  %9s  %6s\n", "case (minima, ns a mass and step)", "A", "B", "B / A");
    for (const Minimum& one : a) {
        const auto other = std::find_if(b.begin(), b.end(), [&](const Minimum& m) { return m.name == one.name; });
        if (other == b.end()) continue;
        std::printf("%-64s  %9.3f  %9.3f  %6.3f\n", one.name.c_str(), one.ns, other->ns, other->ns / one.ns);
        logarithms += std::log(other->ns / one.ns);
        ++both;
    }
    if (both == 0) throw InputError(file_a + " and " + file_b + " have no case in common");
    std::printf("%-64s  %9s  %9s  %6.3f\n", "geometric mean", "", "", std::exp(logarithms / both));
    const auto only = [both](const std::vector<Minimum>& all) { return static_cast<int>(all.size()) - both; };
    if (only(a) > 0 || only(b) > 0) std::printf("Only in A: %d cases; only in B: %d.\n", only(a), only(b));
}

}  // namespace drapeau::bench

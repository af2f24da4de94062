#include "shared_options.hpp"

#include "lists.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <cmath>

namespace drapeau::lab {

long long batches_option(const std::string& option, const std::string& text, long long least) {
    constexpr double longest = 3600.0, rounding = 1e-3;  // s; batches
    constexpr double shortest_one = 0.01666;             // s: one batch, but for that rounding
    const double seconds = number_option(option, text, {least > 0 ? shortest_one : 0.0, longest}, "seconds");
    const double batches = seconds / batch_seconds, whole = std::round(batches);
    if (std::abs(batches - whole) <= rounding) return std::llround(whole);
    refuse(option, text,
           "a whole number of sixtieths of a second, such as " + rounded(std::ceil(batches) * batch_seconds, 6) + ",");
}

double budget_option(const std::string& minutes) {
    constexpr double most_minutes = 7.0 * 24.0 * 60.0;
    return 60.0 * number_option("--budget", minutes, {0.01, most_minutes}, "minutes");
}

double distance_in(const std::string& option, const std::string& text) {
    struct Unit {
        std::string_view name;
        double metres;
    };
    constexpr Unit units[] = {{"nm", 1e-9}, {"um", 1e-6}, {"µm", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}};
    constexpr double least = 1e-12, most = 1e3;
    const std::string_view whole = without_space(text);
    for (const auto& [name, metres] : units) {
        if (!whole.ends_with(name)) continue;
        const auto number = number_in(without_space(whole.substr(0, whole.size() - name.size())));
        if (number && *number * metres >= least && *number * metres <= most) return *number * metres;
        if (number) break;
    }
    refuse(option, text, "a distance from 0.001 nm to 1000 m with its unit (nm, um, mm, cm or m), such as 1mm,");
}

std::pair<int, int> grid_in(const std::string& text) {
    const auto cross = text.find('x');
    const auto side = [](const std::string& digits) {
        const bool is_whole =
            !digits.empty() && digits.size() < 6 && digits.find_first_not_of("0123456789") == std::string::npos;
        return is_whole ? std::stoi(digits) : 0;
    };
    const int columns = cross == std::string::npos ? 0 : side(text.substr(0, cross));
    const int rows = cross == std::string::npos ? 0 : side(text.substr(cross + 1));
    if (columns < 1 || rows < 1) refuse("--grids", text, "COLUMNSxROWS such as 23x15");
    return {columns, rows};
}

Scene scene_in(const std::string& scene, const std::vector<std::string>& set) {
    std::vector<Assignment> assignments;
    for (const std::string& text : set) assignments.push_back(assignment_in(text));
    return read_scene(find_scene(scene), assignments);
}

}  // namespace drapeau::lab

#include "record.hpp"

#include "kernels/kernels.hpp"
#include "scene/file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cinttypes>
#include <ctime>
#include <fstream>
#include <thread>

namespace drapeau::bench {
namespace {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) {
            const auto colon = line.find(": ");
            if (colon != std::string::npos) return line.substr(colon + 2);
        }
    return "unknown";
}

template <class Number>
nlohmann::json or_null(const std::optional<Number>& number) {
    return number ? nlohmann::json(*number) : nlohmann::json(nullptr);
}

std::string hexadecimal(std::uint64_t n) {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, n);
    return text;
}

const char* heading_of(const Case& c) {
    switch (c.work) {
        case Work::step:
            return "Whole steps, as the programs take them";
        case Work::watched:
            return "Whole batches, as the programs take them: steps, ledger, readings, snapshots";
        case Work::accounted:
            return "Whole steps that sum the work of every force";
        case Work::measure:
            return "Energy and stretch of the state";
        case Work::mode:
            return "A look at the fastest mode, of which there is one for thirty steps";
        case Work::terms:
            return "Whole steps of a flag composed in C++, its terms switched off one by one";
        case Work::forces:
            return "Accelerations stored instead of applied";
        case Work::snapshot:
            return "Snapshot handed to the renderer (the upload by OpenGL is not in it)";
        case Work::copy:
            return "Plain copy of the state";
        case Work::report:
            break;
    }
    return "The report's own arrangement";
}

std::string shown(const std::optional<double>& number, const char* format) {
    if (!number) return "-";
    char text[32];
    std::snprintf(text, sizeof text, format, *number);
    return text;
}

}  // namespace

Machine Machine::here() {
    char date[32];
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return {.cpu = cpu_model(),
            .compiler = DRAPEAU_COMPILER,
            .flags = DRAPEAU_FLAGS,
            .kernel_target = drapeau::kernel_target(),
            .date = date,
            .threads = static_cast<int>(std::thread::hardware_concurrency())};
}

nlohmann::json to_json(const Machine& machine, const Peaks& peaks, const std::vector<Record>& records) {
    nlohmann::json levels = nlohmann::json::array();
    for (const auto& level : peaks.levels)
        levels.push_back(
            {{"name", level.name},
             {"bytes", &level == &peaks.levels.back() ? nlohmann::json(nullptr) : nlohmann::json(level.bytes)},
             {"load_bytes_per_ns", level.load},
             {"update_bytes_per_ns", level.update},
             {"copy_bytes_per_ns", level.copy}});
    nlohmann::json cases = nlohmann::json::array();
    for (const auto& r : records)
        cases.push_back({{"name", r.c.name()},
                         {"work", name_of(r.c.work)},
                         {"columns", r.c.columns},
                         {"rows", r.c.rows},
                         {"method", drapeau::name_of(r.c.method)},
                         {"precision", drapeau::name_of(r.c.precision)},
                         {"threads", r.c.threads},
                         {"terms", r.c.listing.names()},
                         {"ns_per_mass_step", {{"min", r.ns_min}, {"median", r.ns_median}}},
                         {"repeats", r.repeats},
                         {"ratio_to_report", or_null(r.ratio_to_report)},
                         {"ratio_to_copy", or_null(r.ratio_to_copy)},
                         {"ratio_to_plain", or_null(r.ratio_to_plain)},
                         {"ratio_to_one_thread", or_null(r.ratio_to_one_thread)},
                         {"floor_ns", r.floor.ns},
                         {"floor_bound_by", r.floor.bound_by},
                         {"counted_per_mass",
                          {{"multiplications", r.counts.multiplications},
                           {"additions", r.counts.additions},
                           {"others", r.counts.others},
                           {"loads", r.counts.loads},
                           {"stores", r.counts.stores}}},
                         {"realtime_factor", or_null(r.realtime_factor)},
                         {"state_hash", hexadecimal(r.state_hash)},
                         {"greatest_stretch", r.greatest_stretch}});
    return {{"machine",
             {{"cpu", machine.cpu},
              {"threads", machine.threads},
              {"compiler", machine.compiler},
              {"flags", machine.flags},
              {"kernel_target", machine.kernel_target},
              {"date", machine.date}}},
            {"peaks",
             {{"multiply_adds_per_ns", {{"float", peaks.multiply_adds[0]}, {"double", peaks.multiply_adds[1]}}},
              {"levels", levels}}},
            {"cases", cases}};
}

void print_head(const Machine& machine, const Peaks& peaks) {
    std::printf("%s, %d hardware threads; %s %s; kernels for %s; %s\n", machine.cpu.c_str(), machine.threads,
                machine.compiler.c_str(), machine.flags.c_str(), machine.kernel_target.c_str(), machine.date.c_str());
    std::printf("Peaks of one core: %.1f multiply-adds/ns float, %.1f double.", peaks.multiply_adds[0],
                peaks.multiply_adds[1]);
    std::printf(" Bytes/ns (load, update in place, copy):");
    for (const auto& level : peaks.levels)
        std::printf(" %s %.0f, %.0f, %.0f%s", level.name.c_str(), level.load, level.update, level.copy,
                    &level == &peaks.levels.back() ? ".\n" : ";");
}

void print_row(const Record& r, const Record* previous) {
    if (!previous || previous->c.work != r.c.work) {
        std::printf("\n%s\n", heading_of(r.c));
        constexpr const char* columns =
            "%11s  %-19s  %-6s  %7s  %-22s  %8s  %8s  %8s  %-10s  %6s  %8s  %7s  %6s  %6s  "
            "%9s  %7s\n";
        std::printf(columns, "grid", "method", "real", "threads", "terms", "ns min", "median", "floor ns", "set by",
                    "/floor", "faster", "faster", "copies", "plain", "real time", "stretch");
        std::printf(columns, "masses", "", "", "", "", "mass-step", "mass-step", "", "", "", "x report", "x one",
                    "a step", "steps", "x", "%");
    }
    const std::string grid = std::to_string(r.c.columns) + " x " + std::to_string(r.c.rows);
    std::printf("%11s  %-19s  %-6s  %7d  %-22s  %8.3f  %8.3f  %8.3f  %-10s  %6.1f  %8s  %7s  %6s  %6s  %9s  %7.2f\n",
                grid.c_str(), std::string(drapeau::name_of(r.c.method)).c_str(),
                std::string(drapeau::name_of(r.c.precision)).c_str(), r.c.threads, r.c.listing.label().c_str(),
                r.ns_min, r.ns_median, r.floor.ns, r.floor.bound_by.c_str(), r.ns_min / r.floor.ns,
                shown(r.ratio_to_report, "%.2f").c_str(), shown(r.ratio_to_one_thread, "%.2f").c_str(),
                shown(r.ratio_to_copy, "%.2f").c_str(), shown(r.ratio_to_plain, "%.3f").c_str(),
                shown(r.realtime_factor, "%.4g").c_str(), 100.0 * r.greatest_stretch);
    std::fflush(stdout);
}

}  // namespace drapeau::bench

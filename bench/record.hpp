// Records: what one run of the benchmark measured, as a table for people and as JSON for programs.
#pragma once

#include "floor.hpp"
#include "timing.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace drapeau::bench {

struct Record {
    Case c;
    double ns_min = 0.0, ns_median = 0.0;  // a mass and step
    int repeats = 0;
    std::optional<double> ratio_to_report = {};  // how many times faster than the report's arrangement: min over min
    std::optional<double> ratio_to_copy = {};    // how many plain copies of the state a step takes
    std::optional<double> ratio_to_plain = {};   // plain steps' time that a step, or a measurement, takes: median
    std::optional<double> ratio_to_one_thread = {};  // how many times faster than one thread: min over min
    Floor floor = {};
    Counts counts = {};
    std::optional<double> realtime_factor = {};  // simulated over elapsed time
    std::uint64_t state_hash = 0;                // after `checked_times` times from the start state
    double greatest_stretch = 0.0;               // share, then
};
inline constexpr int checked_times = 16;

struct Machine {
    std::string cpu, compiler, flags, kernel_target, date;
    int threads = 1;

    static Machine here();
};

nlohmann::json to_json(const Machine& machine, const Peaks& peaks, const std::vector<Record>& records);

void print_head(const Machine& machine, const Peaks& peaks);
/// One line; with a heading where `previous` belongs to another group.
void print_row(const Record& record, const Record* previous);

}  // namespace drapeau::bench

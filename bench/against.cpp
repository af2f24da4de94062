#include "against.hpp"

#include "child.hpp"
#include "compare.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/median_interval.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace drapeau::bench {
namespace {

constexpr const char* default_filter = "^step/(45x30|64x64|128x128|256x256|512x512)/.*/threads:1/";

/// A child measures the machine's peaks first, so one of them measures some cases; the more, the farther the two
/// measurements of a pair are apart.
constexpr std::size_t max_cases_a_child = 8;

struct Program {
    std::string file, called;
};

/// One case, as each of the programs lists it: Google Benchmark's names have a tail that may differ.
struct Pair {
    std::string name, listed[2];
    std::vector<double> ns[2];  // a mass and step, one for each pair measured; 0: this program, 1: the other
};

struct Listed {
    std::string name, listed;
};

std::vector<Listed> cases_of(const Program& program, const std::string& filter) {
    const auto run =
        run_child(program.file, {"--benchmark_list_tests", "--benchmark_filter=" + filter}, Outlet::standard_output);
    if (!run.ending.empty())
        throw InputError(program.called + " " + run.ending + " when asked for the cases of " +
                         one_line(in_quotes(filter), 60));
    std::vector<Listed> cases;
    std::istringstream lines(run.output);
    for (std::string line; std::getline(lines, line);)
        cases.push_back({line.substr(0, line.find("/iterations:")), line});
    return cases;
}

std::vector<Pair> common_cases(const Program (&programs)[2], const std::string& filter) {
    const auto help = run_child(programs[1].file, {"--help"}, Outlet::standard_output);
    if (!help.ending.empty() || !help.output.starts_with("drapeau-bench:"))
        throw InputError(programs[1].called + " is not a drapeau-bench");
    const auto here = cases_of(programs[0], filter), there = cases_of(programs[1], filter);
    std::vector<Pair> pairs;
    for (const Listed& one : here) {
        const auto same = std::find_if(there.begin(), there.end(), [&](const Listed& l) { return l.name == one.name; });
        if (same != there.end()) pairs.push_back({.name = one.name, .listed = {one.listed, same->listed}, .ns = {}});
    }
    if (pairs.empty())
        throw InputError("this program and " + programs[1].called + " have no case in common among " +
                         one_line(in_quotes(filter), 60));
    return pairs;
}

/// step/64x64/...: cases are kept together by their grid, whose start state a child then computes once.
std::string_view grid_of(const Pair& pair) {
    const auto slash = pair.name.find('/') + 1;
    return std::string_view(pair.name).substr(slash, pair.name.find('/', slash) - slash);
}

using Group = std::vector<Pair*>;

std::vector<Group> grouped(std::vector<Pair>& pairs) {
    std::vector<Group> groups;
    for (Pair& pair : pairs) {
        if (groups.empty() || groups.back().size() == max_cases_a_child ||
            grid_of(*groups.back().front()) != grid_of(pair))
            groups.emplace_back();
        groups.back().push_back(&pair);
    }
    return groups;
}

std::string exactly(const Group& group, int which) {
    std::string expression;
    for (const Pair* pair : group) {
        expression += expression.empty() ? "^(" : "|";
        for (const char letter : pair->listed[which]) {
            if (std::string_view(".[]{}()\\*+?^$|").find(letter) != std::string_view::npos) expression += '\\';
            expression += letter;
        }
    }
    return expression + ")$";
}

/// Has one of the programs measure the cases of a group.
void measure(const Program& program, int which, const Group& group, double budget) {
    const auto run = run_child(
        program.file,
        {"--benchmark_filter=" + exactly(group, which), "--json", child_results, "--budget", shortest(budget)},
        Outlet::results);
    if (!run.ending.empty())
        throw InputError(program.called + " " + run.ending + " when it measured " + group.front()->name);
    std::istringstream results(run.output);
    const auto minima = minima_in(results, "what " + program.called + " wrote");
    for (Pair* pair : group) {
        const auto found =
            std::find_if(minima.begin(), minima.end(), [&](const Minimum& m) { return m.name == pair->name; });
        if (found == minima.end())
            throw InputError(program.called + " listed " + pair->name + " but did not measure it");
        pair->ns[which].push_back(found->ns);
    }
}

std::string duration_text(double seconds) {
    const bool in_minutes = seconds >= 90.0;
    return std::to_string(std::lround(std::ceil(in_minutes ? seconds / 60.0 : seconds))) + (in_minutes ? " min" : " s");
}

double median(std::vector<double> values) {
    return median_interval(std::move(values)).median;
}

void print_table(const std::vector<Pair>& pairs) {
    std::printf("%-64s %8s %8s %7s  %-15s\n", "case (medians of minima, ns a mass and step)", "this", "other", "ratio",
                "95 % interval");
    int faster = 0, slower = 0;
    double logarithms = 0.0, coverage = 1.0;
    for (const Pair& pair : pairs) {
        std::vector<double> ratios;
        for (std::size_t n = 0; n < pair.ns[0].size(); ++n) ratios.push_back(pair.ns[0][n] / pair.ns[1][n]);
        const auto ratio = median_interval(ratios);
        const char* verdict = ratio.low > 1.0 ? "  slower" : ratio.high < 1.0 ? "  faster" : "";
        slower += ratio.low > 1.0, faster += ratio.high < 1.0;
        logarithms += std::log(ratio.median);
        coverage = ratio.coverage;
        std::printf("%-64s %8.3f %8.3f %7.3f  %.3f .. %.3f%s\n", pair.name.c_str(), median(pair.ns[0]),
                    median(pair.ns[1]), ratio.median, ratio.low, ratio.high, verdict);
    }
    const double count = static_cast<double>(pairs.size());
    std::printf("%-64s %8s %8s %7.3f\n", "geometric mean of the ratios", "", "", std::exp(logarithms / count));
    std::printf("%zu cases, %zu pairs each: %d slower, %d faster than the other.\n", pairs.size(),
                pairs.front().ns[0].size(), slower, faster);
    std::printf(
        "An interval misses the true median with a probability of %.1f %%: of as many cases without any difference, "
        "%.1f would be named on average.\n",
        100.0 * (1.0 - coverage), count * (1.0 - coverage));
}

}  // namespace

void run_against(const AgainstOptions& options) {
    // Of itself a program can rely on the file it runs from, even if that has been replaced by a newer build.
    const Program programs[2] = {{"/proc/self/exe", "this program"}, {options.other, one_line(options.other, 200)}};
    auto pairs = common_cases(programs, options.filter.empty() ? default_filter : options.filter);
    const auto groups = grouped(pairs);
    const auto measure_pair = [&](const Group& group, int first) {
        for (const int which : {first, 1 - first}) measure(programs[which], which, group, options.budget);
    };

    // A pair of each group that does not count: it reads both programs from the disk, shows whether they run and how
    // long that takes.
    using clock = std::chrono::steady_clock;
    std::printf("%zu cases, this program and %s in turns; one pair of each to warm up ...\n", pairs.size(),
                programs[1].called.c_str());
    std::fflush(stdout);
    const auto begin = clock::now();
    for (const Group& group : groups) measure_pair(group, 0);
    for (Pair& pair : pairs)
        for (auto& ns : pair.ns) ns.clear();
    const double seconds = std::chrono::duration<double>(clock::now() - begin).count();
    std::printf("... took %s, so %d pairs take about %s.\n", duration_text(seconds).c_str(), options.pairs,
                duration_text(seconds * options.pairs).c_str());
    std::fflush(stdout);

    const bool watched = isatty(STDERR_FILENO) != 0;
    for (int n = 0; n < options.pairs; ++n) {
        if (watched) std::fprintf(stderr, "\rpair %d of %d", n + 1, options.pairs);
        for (const Group& group : groups) measure_pair(group, n % 2);
    }
    if (watched) std::fprintf(stderr, "\r%40s\r", "");
    print_table(pairs);
}

}  // namespace drapeau::bench

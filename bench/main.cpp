// The benchmark's command line. Google Benchmark keeps the list of cases, filters it and runs it; what a case measures
// is this project's own (timing.hpp), because a noisy machine asks for the state restored and rivals taken in turns.
#include "against.hpp"
#include "compare.hpp"
#include "measure.hpp"
#include "peers.hpp"

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/text.hpp"
#include "measure/median_interval.hpp"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <new>

namespace {

using namespace drapeau;
using namespace drapeau::bench;

struct Options {
    std::string json;
    double budget = 0.4;  // s a case, and as much for each of its rivals
    bool smoke = false, peers = false;
    std::vector<std::string> compare;
    AgainstOptions against;
};

/// What a run gathers: the cases register a job that fills it.
struct Run {
    Options options;
    Peaks peaks;
    std::vector<Record> records;
    int checked = 0;
    std::vector<std::string> failures;

    void measure(const Case& c) {
        Record record = measure_case(c, peaks, options.budget);
        print_row(record, records.empty() ? nullptr : &records.back());
        records.push_back(std::move(record));
    }
    void smoke(const Case& c) {
        ++checked;
        const std::string wrong = smoke_case(c);
        if (!wrong.empty()) failures.push_back(c.name() + ": " + wrong);
    }
};

/// The table is printed as cases end, in this project's own columns; Google Benchmark has nothing to add to it.
class Quiet final : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>&) override {}
};

/// Beyond this the smoke pass would need time and memory that a test should not take.
constexpr long long max_masses_to_smoke = 512 * 512;

void register_cases(Run& run) {
    for (const Case& c : all_cases()) {
        if (run.options.smoke && (c.masses() > max_masses_to_smoke || c.threads > 1)) continue;
        benchmark::RegisterBenchmark(c.name().c_str(),
                                     [&run, c](benchmark::State& state) {
                                         for (auto _ : state) {
                                             run.options.smoke ? run.smoke(c) : run.measure(c);
                                             const double ns = run.options.smoke ? 1.0 : run.records.back().ns_min;
                                             state.SetIterationTime(ns * 1e-9);
                                         }
                                     })
            ->Iterations(1)
            ->UseManualTime();
    }
}

InputError of_no_use(const std::string& extra) {
    return InputError("there is no use for " + one_line(in_quotes(extra), 60) + " here (--help says more)");
}

int run_cases(const Options& options, std::vector<std::string> extras) {
    // What is left of the command line is Google Benchmark's.
    std::string program = "drapeau-bench";
    std::vector<char*> arguments{program.data()};
    for (auto& extra : extras) arguments.push_back(extra.data());
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data());
    if (count > 1) throw InputError(std::string("there is no option ") + arguments[1] + " (--help lists them)");

    Run run{.options = options, .peaks = {}, .records = {}, .failures = {}};
    register_cases(run);
    Quiet quiet;
    const bool only_list = std::any_of(extras.begin(), extras.end(),
                                       [](const auto& e) { return e.starts_with("--benchmark_list_tests"); });
    if (!options.json.empty()) check_writable(options.json);  // before hours of measuring, not after
    if (!options.smoke && !only_list) {
        run.peaks = measure_peaks();
        print_head(Machine::here(), run.peaks);
    }
    const auto matched = benchmark::RunSpecifiedBenchmarks(&quiet);
    if (only_list) return 0;
    if (matched == 0) return 2;  // Google Benchmark has said why
    if (options.smoke) {
        for (const auto& failure : run.failures) std::fprintf(stderr, "drapeau-bench: %s\n", failure.c_str());
        std::printf("%d cases, %zu failed\n", run.checked, run.failures.size());
        return run.failures.empty() ? 0 : 1;
    }
    if (!options.json.empty()) {
        const std::string text = to_json(Machine::here(), run.peaks, run.records).dump(1) + "\n";
        write_file(options.json, [&](const Append& append) { append(text); });
    }
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app(
        "drapeau-bench: what a step costs, how far that is from the machine's limit and from the report's arrangement",
        "drapeau-bench");
    app.footer(
        "Options that begin with --benchmark_ go to Google Benchmark: --benchmark_filter=REGEX, "
        "--benchmark_list_tests.\nTimes are the minimum and the median of many short repeats, each from the same "
        "state.\nExit status: 0 good, 1 a check failed, 2 bad input.");
    app.allow_extras();
    Options options;
    auto* json = app.add_option("--json", options.json, "Write the numbers")->type_name("FILE");
    auto* budget = app.add_option("--budget", options.budget, "Time for each case and each of its rivals, s")
                       ->check(CLI::Range(0.001, 3600.0));
    auto* smoke = app.add_flag("--smoke", options.smoke,
                               "Check that results are finite and the same for any number of "
                               "threads; time nothing, leave out the largest grids");
    auto* peers = app.add_flag("--peers", options.peers, "Compare with other programs' cloth, where compiled in");
    auto* compare = app.add_option("--compare", options.compare, "Compare two files of results")
                        ->expected(2)
                        ->type_name("A.json B.json");
    auto* against =
        app.add_option("--against", options.against.other,
                       "Compare with another build of this program, run in turns with it: the ratio of "
                       "their times per case and its 95 % interval. --budget is then 0.05 s, where not given")
            ->type_name("PROGRAM")
            ->check(CLI::ExistingFile);
    app.add_option("--pairs", options.against.pairs,
                   "Runs of each program with --against (11); 20 give narrower intervals where the machine is busy")
        ->check(CLI::Range(min_draws, 10000))
        ->needs(against);
    smoke->excludes(json)->excludes(budget)->excludes(peers)->excludes(compare);
    compare->excludes(json)->excludes(budget)->excludes(peers);
    peers->excludes(json)->excludes(budget);
    against->excludes(json)->excludes(smoke)->excludes(peers)->excludes(compare);

    const auto complain = [](const std::string& message) {
        std::fprintf(stderr, "drapeau-bench: %s\n", message.c_str());
        return 2;
    };
    try {
        app.parse(count, arguments);
        const auto extras = app.remaining();
        for (const auto& extra : extras)
            if (!extra.starts_with("--benchmark_") || options.peers || !options.compare.empty()) throw of_no_use(extra);
        if (against->count() > 0) {
            constexpr std::string_view filter = "--benchmark_filter=";
            for (const auto& extra : extras) {
                if (!extra.starts_with(filter)) throw of_no_use(extra);
                options.against.filter = extra.substr(filter.size());
            }
            if (budget->count() > 0) options.against.budget = options.budget;
            run_against(options.against);
            return 0;
        }
        if (!options.compare.empty()) {
            compare_files(options.compare[0], options.compare[1]);
            return 0;
        }
        if (options.peers) {
            run_peers();
            return 0;
        }
        return run_cases(options, extras);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return complain(one_line(error.what(), 300) + " (drapeau-bench --help says more)");
    } catch (const InputError& error) {
        return complain(error.what());
    } catch (const std::bad_alloc&) {
        return complain("not enough memory for this case");
    }
}

// Extremes: runs cases of a seed, each in a process of its own, so that one that crashes or hangs is named too.
#include "extremes/case.hpp"
#include "extremes/judge.hpp"
#include "io/command_line.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <map>
#include <random>
#include <thread>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace drapeau;
using namespace drapeau::extremes;
using Time = std::chrono::steady_clock;

struct Options {
    long long cases = 1000, first = 0;
    double minutes = 0.0;
    std::uint64_t seed = 1;
    std::string one;
    int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    double work = 2e7;       // mass-steps
    double patience = 60.0;  // s of processor time, for one case; ten times that of any time
    bool all = false;
};

double seconds_since(Time::time_point then) {
    return std::chrono::duration<double>(Time::now() - then).count();
}

/// A case under way in a child.
struct Child {
    long long number = 0;
    int answer = -1;  // the pipe's end
    Time::time_point began = Time::now();
};

/// Begins a case; the child answers with a verdict's number and what there is to say.
std::pair<pid_t, Child> begin(const Cases& cases, long long number, const Options& options) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    const pid_t id = fork();
    if (id < 0) throw std::runtime_error("no further process");
    if (id > 0) {
        close(ends[1]);
        return {id, {.number = number, .answer = ends[0], .began = Time::now()}};
    }
    close(ends[0]);
    const auto limit = static_cast<rlim_t>(std::ceil(options.patience));
    const rlimit processor{limit, limit};
    setrlimit(RLIMIT_CPU, &processor);
    const Judgement judgement = judge(cases.at(number), options.work);
    const std::string text = std::to_string(static_cast<int>(judgement.verdict)) + " " + judgement.text;
    const bool written = write(ends[1], text.data(), std::min<std::size_t>(text.size(), 4000)) > 0;
    std::_Exit(written ? 0 : 1);
}

/// The judgement of a child that has ended with this status.
Judgement judgement_of(const Child& child, int status, bool in_time) {
    std::array<char, 4096> block{};
    const auto count = read(child.answer, block.data(), block.size());
    close(child.answer);
    const std::string text(block.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    if (!in_time || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)))
        return {Verdict::failed, fmt::format("hangs: no end after {:.0f} s", seconds_since(child.began))};
    if (WIFSIGNALED(status)) return {Verdict::failed, fmt::format("crashes: signal {}", WTERMSIG(status))};
    if (WEXITSTATUS(status) != 0 || text.size() < 2)
        return {Verdict::failed, fmt::format("ends with status {}", WEXITSTATUS(status))};
    return {static_cast<Verdict>(text[0] - '0'), text.substr(2)};
}

class Tally {
public:
    Tally(const Options& options) : options_(options) {}

    /// `seconds`: of processor time.
    void add(const Child& child, const Judgement& judgement, double seconds) {
        ++counts_[judgement.verdict];
        all_seconds_ += seconds;
        if (seconds > longest_) longest_ = seconds, longest_case_ = child.number;
        if (judgement.verdict < Verdict::failed && !options_.all) return;
        fmt::print("{}:{} {} ({:.2f} s) {}\n", options_.seed, child.number,
                   verdict_names[static_cast<int>(judgement.verdict)], seconds, judgement.text);
        std::fflush(stdout);
    }
    /// True if none failed and few were misjudged: of 5,000 cases that were looked at 5 were.
    bool print(double seconds) const {
        long long all = 0;
        std::string text;
        for (const auto& [verdict, count] : counts_) {
            all += count;
            text += fmt::format(", {} {}", count, verdict_names[static_cast<int>(verdict)]);
        }
        fmt::print("{} cases of seed {} in {:.0f} s ({:.0f} s of processors){}; the longest took {:.1f} s ({}:{})\n",
                   all, options_.seed, seconds, all_seconds_, text, longest_, options_.seed, longest_case_);
        constexpr double rare = 0.003;
        const auto count_of = [&](Verdict verdict) {
            const auto found = counts_.find(verdict);
            return found == counts_.end() ? 0 : found->second;
        };
        const bool good = count_of(Verdict::failed) == 0 && static_cast<double>(count_of(Verdict::misjudged)) <=
                                                                std::ceil(rare * static_cast<double>(all));
        if (!good) fmt::print("To repeat one: drapeau-extremes --work {:g} --case SEED:NUMBER\n", options_.work);
        return good;
    }

private:
    const Options& options_;
    std::map<Verdict, long long> counts_;
    double all_seconds_ = 0.0, longest_ = 0.0;
    long long longest_case_ = 0;
};

int run(const Options& options) {
    const Cases cases(options.seed);
    const auto began = Time::now();
    fmt::print("seed {}: the first {} cases have every pair of extremes\n", options.seed, cases.covering_count());
    Tally tally(options);
    std::map<pid_t, Child> running;
    long long next = options.first;
    const auto goes_on = [&] {
        return options.minutes > 0.0 ? seconds_since(began) < 60.0 * options.minutes
                                     : next < options.first + options.cases;
    };
    while (goes_on() || !running.empty()) {
        while (goes_on() && static_cast<int>(running.size()) < options.jobs)
            running.insert(begin(cases, next++, options));
        std::vector<pollfd> ends;
        for (const auto& [id, child] : running) ends.push_back({child.answer, POLLIN, 0});
        poll(ends.data(), ends.size(), 100);
        for (auto it = running.begin(); it != running.end();) {
            auto& [id, child] = *it;
            const bool in_time = seconds_since(child.began) < 10.0 * options.patience;
            int status = 0;
            rusage used{};
            if (!in_time) kill(id, SIGKILL);
            if (wait4(id, &status, in_time ? WNOHANG : 0, &used) != id) {
                ++it;
                continue;
            }
            const auto seconds = [](const timeval& t) {
                return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
            };
            tally.add(child, judgement_of(child, status, in_time), seconds(used.ru_utime) + seconds(used.ru_stime));
            it = running.erase(it);
        }
    }
    return tally.print(seconds_since(began)) ? 0 : 1;
}

int repeat(const Options& options) {
    const auto colon = options.one.find(':');
    if (colon == std::string::npos) throw CLI::ValidationError("--case", "SEED:NUMBER is wanted");
    const Case of = Cases(std::stoull(options.one.substr(0, colon))).at(std::stoll(options.one.substr(colon + 1)));
    const char* beginnings[] = {"as the scene says", "all masses in one point", "folded exactly on itself",
                                "100 km from the origin"};
    fmt::print("{}\n# begins {}, {} thread{}, step {}\n", write_scene(of.scene), beginnings[static_cast<int>(of.begin)],
               of.threads, of.threads > 1 ? "s" : "", of.exact_dt ? "as given" : "made to fill 1/60 s");
    std::fflush(stdout);
    const auto began = Time::now();
    const Judgement judgement = judge(of, options.work);
    fmt::print("{} ({:.2f} s) {}\n", verdict_names[static_cast<int>(judgement.verdict)], seconds_since(began),
               judgement.text);
    return judgement.verdict >= Verdict::failed ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    bool random_seed = false;
    CLI::App app("drapeau-extremes: scenes at the edges of what a scene can say, and what becomes of them",
                 "drapeau-extremes");
    app.add_option("--cases", options.cases, "How many")->capture_default_str();
    app.add_option("--first", options.first, "Number of the first")->capture_default_str();
    app.add_option("--minutes", options.minutes, "Or for how long");
    app.add_option("--seed", options.seed, "Which ones")->capture_default_str();
    app.add_flag("--random", random_seed, "A seed of its own");
    app.add_option("--case", options.one, "Repeat one, with its scene")->type_name("SEED:NUMBER");
    app.add_option("--jobs", options.jobs, "How many at once")->capture_default_str();
    app.add_option("--work", options.work, "Mass-steps for each, about")->capture_default_str();
    app.add_option("--patience", options.patience, "Seconds until one is said to hang")->capture_default_str();
    app.add_flag("--all", options.all, "A line for each, not only for what fails");
    try {
        drapeau::parse(app, count, arguments);
        if (random_seed) options.seed = std::random_device()() % 1'000'000'000;
        return options.one.empty() ? run(options) : repeat(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    }
}

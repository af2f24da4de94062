#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace drapeau::bench {
namespace {

constexpr double shortest_repeat = 150e-6;  // s: long beside the clock's own cost, short beside the noise
constexpr int min_repeats = 5;

double seconds_for(Subject& subject, int times) {
    subject.restore();
    const auto begin = std::chrono::steady_clock::now();
    subject.run(times);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// How many times the work is done in one repeat; the runs that find out also warm up.
int times_in_a_repeat(const Contender& contender) {
    seconds_for(*contender.subject, contender.at_least);
    const double once = seconds_for(*contender.subject, contender.at_least) / contender.at_least;
    const int enough = static_cast<int>(std::min(1e5, std::ceil(shortest_repeat / std::max(once, 1e-9))));
    return (std::max(enough, contender.at_least) + contender.at_least - 1) / contender.at_least * contender.at_least;
}

}  // namespace

std::vector<Timing> time_in_turns(std::span<const Contender> contenders, double budget) {
    std::vector<int> times;
    std::vector<std::vector<double>> seconds(contenders.size());
    for (const auto& contender : contenders) times.push_back(times_in_a_repeat(contender));

    const auto begin = std::chrono::steady_clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
    for (int n = 0; n < min_repeats || spent() < budget * static_cast<double>(contenders.size()); ++n)
        for (std::size_t c = 0; c < contenders.size(); ++c)
            seconds[c].push_back(seconds_for(*contenders[c].subject, times[c]) / times[c]);

    std::vector<Timing> timings;
    for (auto& turns : seconds) {
        auto all = turns;
        std::sort(all.begin(), all.end());
        timings.push_back({all.front(), all[all.size() / 2], std::move(turns)});
    }
    return timings;
}

}  // namespace drapeau::bench

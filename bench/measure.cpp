#include "measure.hpp"

#include "subjects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace drapeau::bench {
namespace {

bool has_plain_rival(const Case& c) {
    return c.work == Work::watched || c.work == Work::accounted || c.work == Work::measure || c.work == Work::mode;
}

bool has_report_rival(const Case& c) {
    return c.work == Work::step || c.work == Work::terms;
}

/// Steps that a repeat takes at least: some of a batch, as the programs ask for them, so that threads are woken as
/// often as they would be; of batches, a whole number of the spans between readings (3) and of those between entries in
/// the ledger (8).
int times_at_least(const Case& c) {
    switch (c.work) {
        case Work::step:
            return c.masses() < 512 * 512 ? 32 : 16;
        case Work::watched:
            return 24;
        case Work::accounted:
        case Work::terms:
            return 8;
        default:
            return 1;
    }
}

/// The median of the ratios within each turn.
double ratio_of_turns(const Timing& a, const Timing& b) {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < std::min(a.turns.size(), b.turns.size()); ++n)
        ratios.push_back(a.turns[n] / b.turns[n]);
    std::sort(ratios.begin(), ratios.end());
    return (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]) / 2.0;
}

}  // namespace

Record measure_case(const Case& c, const Peaks& peaks, double budget) {
    const State<double>& start = flying_state(c.columns, c.rows);
    const auto subject = make_subject(c, start);
    std::vector<Contender> contenders{{subject.get(), times_at_least(c)}};
    std::vector<std::unique_ptr<Subject>> rivals;
    const auto add = [&](std::unique_ptr<Subject> rival, long long at_least) {
        contenders.push_back({rival.get(), static_cast<int>(at_least)});
        rivals.push_back(std::move(rival));
        return contenders.size() - 1;
    };

    std::optional<std::size_t> report, copy, plain, one_thread;
    Case other{.columns = c.columns, .rows = c.rows, .precision = c.precision};
    if (has_report_rival(c)) {
        // The report's arrangement has one option of its own, the diagonals; whatever else is left out, it computes
        // all.
        other.work = Work::report;
        other.listing.diagonal = c.listing.diagonal;
        report = add(make_subject(other, start), 1);
    }
    if (has_report_rival(c) && c.masses() >= 1024 * 1024) {
        other.work = Work::copy;
        copy = add(make_subject(other, start), 1);
    }
    if (has_plain_rival(c)) plain = add(make_plain_rival(c, start), times_at_least(c) * subject->steps_a_time);
    if (c.threads > 1) {
        Case alone = c;
        alone.threads = 1;
        one_thread = add(make_subject(alone, start), times_at_least(alone));
    }

    const auto timings = time_in_turns(contenders, budget);
    const Timing& time = timings[0];
    const auto steps = static_cast<double>(subject->steps_a_time), mass_steps = steps * static_cast<double>(c.masses());
    Record record{.c = c,
                  .ns_min = time.min * 1e9 / mass_steps,
                  .ns_median = time.median * 1e9 / mass_steps,
                  .repeats = static_cast<int>(time.turns.size()),
                  .counts = count_operations(c)};
    if (report) record.ratio_to_report = timings[*report].min / time.min;
    if (c.work == Work::report) record.ratio_to_report = 1.0;
    if (one_thread) record.ratio_to_one_thread = timings[*one_thread].min / time.min;
    if (copy) record.ratio_to_copy = time.min / timings[*copy].min;
    if (plain) record.ratio_to_plain = ratio_of_turns(time, timings[*plain]) / steps;
    if (takes_steps(c.work)) record.realtime_factor = steps * subject->dt / time.min;
    record.floor = floor_of(c, record.counts, peaks);

    subject->restore();
    subject->run(c.work == Work::watched ? 1 : checked_times);
    record.state_hash = subject->hash();
    record.greatest_stretch = subject->greatest_stretch();
    return record;
}

std::string smoke_case(const Case& c) {
    const bool solves = with_method(c.method, [](const auto& m) { return std::decay_t<decltype(m)>::solves; });
    const int times = solves ? 3 : c.work == Work::watched ? 9 : 24;
    const State<double>& start = flying_state(c.columns, c.rows);
    const auto subject = make_subject(c, start);
    subject->run(times);
    if (!std::isfinite(subject->greatest_stretch()))
        return "a value is not finite after " + std::to_string(times) + " times";
    const std::uint64_t hash = subject->hash();

    subject->restore();
    subject->run(times);
    if (subject->hash() != hash) return "the same run again gave another result";
    if (!takes_steps(c.work)) return {};

    subject->restore();
    for (int n = 0; n < times; ++n) subject->run(1);
    if (subject->hash() != hash) return "one at a time gives another result than " + std::to_string(times) + " at once";
    if (has_plain_rival(c)) {
        const auto plain = make_plain_rival(c, start);
        plain->run(static_cast<int>(subject->steps() - plain->steps()));
        // Steps that are accounted sum a force in two parts, so that their last bits differ.
        constexpr double about = 1e-3;  // share
        if (!(std::abs(plain->greatest_stretch() - subject->greatest_stretch()) < about))
            return "plain steps give another result";
    }
    if (c.work != Work::step) return {};
    for (const int threads : {1, 2, 3}) {
        Case other = c;
        other.threads = threads;
        const auto same = make_subject(other, start);
        same->run(times);
        if (same->hash() != hash)
            return std::to_string(threads) + " threads give another result than " + std::to_string(c.threads);
    }
    return {};
}

}  // namespace drapeau::bench

#include "measure.hpp"

#include <cmath>

namespace drapeau::bench {
namespace {

bool takes_steps(const Case& c) {
    return c.work == Work::step || c.work == Work::terms || c.work == Work::report;
}

/// Steps that a repeat takes at least: some of a batch, as the programs ask for them, so that threads are woken as
/// often as they would be.
int steps_at_least(const Case& c) {
    if (c.work != Work::step) return c.work == Work::terms ? 8 : 1;
    return c.masses() < 512 * 512 ? 32 : 16;
}

}  // namespace

Record measure_case(const Case& c, const Peaks& peaks, double budget) {
    const Masses& start = start_state(c.columns, c.rows);
    const auto subject = make_subject(c, start);
    std::vector<Contender> contenders{{subject.get(), steps_at_least(c)}};

    // The report's arrangement has one option of its own, the diagonals; whatever else is left out, it computes all.
    std::unique_ptr<Subject> report, copy;
    if (takes_steps(c) && c.work != Work::report) {
        Case rival{.work = Work::report, .columns = c.columns, .rows = c.rows, .precision = c.precision};
        rival.terms.diagonal = c.terms.diagonal;
        report = make_subject(rival, start);
        contenders.push_back({report.get(), 1});
    }
    const std::size_t copy_at = contenders.size();
    if (takes_steps(c) && c.masses() >= 1024 * 1024) {
        copy =
            make_subject({.work = Work::copy, .columns = c.columns, .rows = c.rows, .precision = c.precision}, start);
        contenders.push_back({copy.get(), 1});
    }

    std::unique_ptr<Subject> one_thread;
    const std::size_t one_thread_at = contenders.size();
    if (c.threads > 1) {
        Case alone = c;
        alone.threads = 1;
        one_thread = make_subject(alone, start);
        contenders.push_back({one_thread.get(), steps_at_least(alone)});
    }

    const auto timings = time_in_turns(contenders, budget);
    const double masses = static_cast<double>(c.masses());
    Record record{.c = c,
                  .ns_min = timings[0].min * 1e9 / masses,
                  .ns_median = timings[0].median * 1e9 / masses,
                  .repeats = timings[0].repeats,
                  .counts = count_operations(c)};
    if (report) record.ratio_to_report = timings[1].min / timings[0].min;
    if (c.work == Work::report) record.ratio_to_report = 1.0;
    if (one_thread) record.ratio_to_one_thread = timings[one_thread_at].min / timings[0].min;
    if (copy) record.ratio_to_copy = timings[0].min / timings[copy_at].min;
    if (takes_steps(c)) record.realtime_factor = subject->dt / timings[0].min;
    record.floor = floor_of(c, record.counts, peaks);

    subject->restore();
    subject->run(checked_times);
    record.state_hash = subject->hash();
    record.greatest_stretch = subject->greatest_stretch();
    return record;
}

std::string smoke_case(const Case& c) {
    constexpr int steps = 24;
    const Masses& start = start_state(c.columns, c.rows);
    const auto subject = make_subject(c, start);
    subject->run(steps);
    if (!std::isfinite(subject->greatest_stretch()))
        return "a value is not finite after " + std::to_string(steps) + " steps";
    const std::uint64_t hash = subject->hash();

    subject->restore();
    subject->run(steps);
    if (subject->hash() != hash) return "the same run again gave another result";
    if (!takes_steps(c)) return {};

    // The wind of the benchmark's flag is steady, so that steps need not know their time.
    subject->restore();
    for (int n = 0; n < steps; ++n) subject->run(1);
    if (subject->hash() != hash)
        return "one step at a time gives another result than " + std::to_string(steps) + " at once";
    if (c.work != Work::step) return {};
    for (const int threads : {1, 2, 3}) {
        Case other = c;
        other.threads = threads;
        const auto same = make_subject(other, start);
        same->run(steps);
        if (same->hash() != hash)
            return std::to_string(threads) + " threads give another result than " + std::to_string(c.threads);
    }
    return {};
}

}  // namespace drapeau::bench

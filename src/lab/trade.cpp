#include "trade.hpp"

#include "exit_status.hpp"
#include "basis_records.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "merge.hpp"
#include "outputs.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "scene/file.hpp"
#include "trade_options.hpp"
#include "trade_outcome.hpp"
#include "trade_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace drapeau::lab {

namespace {

/// Nothing, once the references are flown; or the exit status.
std::optional<int> prepared(TradeSweep& sweep, const TradeOptions& options, const Tick& tick) {
    if (const auto diverged = sweep.prepare(tick)) {
        complain(program, "the scene diverges while it swings in, at rk4's automatic step: " + *diverged);
        return exit_diverged;
    }
    check_tolerance(options, sweep.grounds().front().stretch.seconds(), sweep.horizon());
    return {};
}

/// A sweep at once, as far as the budget goes.
int at_once(const TradeOptions& options, const TradeRequest& request, const SweepOutputs& outputs) {
    TradeSweep sweep(request);
    complain(program, fmt::format("{}, about {}, at most {}", counted(sweep.count(), "setting"),
                                  duration(sweep.estimate()), duration(request.budget)));
    TradeFindings findings;
    {
        Progress progress;
        const Tick tick = [&](double share) { progress.show(share); };
        if (const auto status = prepared(sweep, options, tick)) return *status;
        findings = findings_of(sweep, sweep.measure(tick), tick);
    }
    return report(sweep, findings, outputs);
}

/// The point as the file keeps it.
Measured kept(const TradeSweep& sweep, const PartFile& file, std::size_t n) {
    Measured measured;
    use_point(file.part(), sweep.point(n).key,
              [&](const PointRecord& record) { measured = measured_in(record, sweep.point(n)); });
    return measured;
}

/// Times every point as often as it should be, in turns.
void time_shard(const TradeSweep& sweep, const std::vector<std::size_t>& places, PartFile& file, const Tick& tick) {
    std::vector<Measured> points;
    std::vector<int> missing;  // rounds of each
    double left = 0.0;
    for (const std::size_t n : places) {
        points.push_back(kept(sweep, file, n));
        const auto times = static_cast<int>(file.part().points.at(sweep.point(n).key).costs.size());
        missing.push_back(std::max(0, TradeSweep::rounds_of(points.back()) + 1 - times));
        left += missing.back();
    }
    for (const double all = left; left > 0.0;)
        for (std::size_t n = 0; n < points.size(); ++n) {
            if (missing[n] == 0) continue;
            points[n].ms_per_second = sweep.time_again(points[n]);
            file.add_cost(points[n].point.key, cost_json(points[n]));
            --missing[n];
            tick(1.0 - --left / all);
        }
}

/// Measures those points of the shard that the file lacks, then times all of them.
void measure_shard(const TradeSweep& sweep, const std::vector<std::size_t>& places, PartFile& file, const Tick& tick) {
    constexpr double for_errors = 0.5;  // of the time, about
    const double all = std::max(sweep.seconds_of_points(places), 1e-9);
    std::vector<std::size_t> done;
    for (const std::size_t n : places) {
        const double share = for_errors * sweep.seconds_of_points(done) / all;
        tick(share);
        if (!file.has(sweep.point(n).key)) {
            const Measured measured = sweep.measure_one(n, [&](double) { tick(share); });
            file.add(measured.point.key, cost_json(measured), result_json(measured));
        }
        done.push_back(n);
    }
    time_shard(sweep, places, file, [&](double share) { tick(for_errors + (1.0 - for_errors) * share); });
}

/// A sweep, or a shard of one, whose points are kept as they are done. The whole ends as one at once does.
int in_parts(const TradeOptions& options, const TradeRequest& request, const SweepOutputs& outputs,
             const Shard& shard) {
    TradeSweep sweep(request);
    PartFile file(options.part, identity_of(options, request), shard);
    std::vector<std::size_t> places, missing;
    const std::vector<std::size_t> order = sweep.cheapest_first();
    for (const std::size_t n : shard.places(order.size())) places.push_back(order[n]);
    for (const std::size_t n : places)
        if (!file.has(sweep.point(n).key)) missing.push_back(n);
    const double before = sweep.seconds_before(), after = sweep.seconds_of_points(missing);
    complain(program,
             fmt::format("shard {}: {} of {}, {} of them done, about {}", shard.text(), places.size(),
                         counted(sweep.count(), "setting"), places.size() - missing.size(), duration(before + after)));
    TradeFindings findings;
    {
        Progress progress;
        const double share_before = before / (before + after);
        if (const auto status = prepared(sweep, options, [&](double share) { progress.show(share * share_before); }))
            return *status;
        file.set_basis(basis_json(sweep.basis()));
        measure_shard(sweep, places, file,
                      [&](double share) { progress.show(share_before + (1.0 - share_before) * share); });
        if (shard.is_whole())
            findings = findings_of(sweep, points_in(file.part(), sweep), [&](double) { progress.show(1.0); });
    }
    return shard.is_whole() ? report(sweep, findings, outputs) : say_shard_is_done(file.part());
}

}  // namespace

int trade(const TradeOptions& options) {
    const TradeRequest request = request_in(options);
    const SweepOutputs outputs{options.json, options.write, options.plot, find_scene(options.scene)};
    const Shard shard = checked_shard(options.part, outputs);
    return request.counts_work ? in_parts(options, request, outputs, shard) : at_once(options, request, outputs);
}

int merge_trade(const Joined& joined, const MergeOptions& merging) {
    const TradeOptions options = options_in(joined.all.sweep);
    TradeRequest request = request_in(options, parse_scene(joined.all.sweep.scene, joined.all.file + ", its scene"));
    request.counts_work = true;
    const SweepOutputs outputs{merging.json, merging.write, merging.plot, {}};
    if (!merging.write.empty() && !request.tolerance)
        throw InputError("--write: it saves the setting for a tolerance, and the sweep was made without --tolerance");
    TradeSweep sweep(request);
    if (const auto missing = joined.missing(keys_of(sweep))) {
        complain(program, *missing);
        return exit_not_met;
    }
    const std::vector<Measured> points = points_in(joined.all, sweep);
    TradeFindings findings;
    {
        Progress progress;
        const Tick tick = [&](double share) { progress.show(share); };
        if (!request.tolerance) {
            use_basis(joined.all, [&](const Json& basis) { sweep.restore(basis_in(basis)); });
        } else if (const auto status = prepared(sweep, options, tick)) {  // its check needs more than parts keep
            return *status;
        }
        findings = findings_of(sweep, points, tick);
    }
    return report(sweep, findings, outputs);
}

}  // namespace drapeau::lab

#include "price.hpp"

#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "merge.hpp"
#include "outputs.hpp"
#include "price_plot.hpp"
#include "price_records.hpp"
#include "price_report.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "scene/file.hpp"
#include "shared_options.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace drapeau::lab {

namespace {

/// What a study says of how far it is, once a bar of progress is there.
struct Teller {
    std::optional<Progress> progress;
    Tick tick = [this](double share) {
        if (progress) progress->show(share);
    };
};

/// Nothing, once the reference is flown; or the exit status.
std::optional<int> prepared(PriceStudy& study, const PriceOptions& options, Teller& teller, std::size_t parts) {
    teller.progress.emplace();
    if (const auto how = study.prepare(parts)) {
        teller.progress.reset();
        complain(program, "the scene diverges " + *how);
        return exit_diverged;
    }
    check_tolerance(options, study.ground().stretch.seconds(), study.horizon());
    return {};
}

/// What follows from the parts: with a tolerance the scene that is left. Prints and writes all; the exit status.
int report(PriceStudy& study, const Prices& prices, const SweepOutputs& outputs, Teller& teller) {
    std::optional<Reduction> reduction;
    if (study.request().tolerance) reduction = study.reduce(prices);
    teller.progress.reset();

    std::FILE* table = place_of_table(outputs.files());
    std::fputs((compared_text(study) + "\n" + parts_table(study, prices)).c_str(), table);
    if (reduction) std::fputs(("\n" + reduction_text(study, *reduction)).c_str(), table);
    if (!outputs.json.empty())
        write_text_file(outputs.json,
                        [&](const Append& append) { append(as_json(study, prices, reduction).dump(2) + "\n"); });
    if (!outputs.plot.empty()) plot(outputs.plot, price_script(study, prices));
    if (!reduction) return exit_good;
    if (!holds(study, *reduction)) return exit_not_met;
    if (!outputs.write.empty())
        write_text_file(outputs.write,
                        [&](const Append& append) { append(reduced_text(study, *reduction, outputs.scene_file)); });
    return exit_good;
}

int at_once(const PriceOptions& options, const PriceRequest& request, const SweepOutputs& outputs) {
    Teller teller;
    PriceStudy study(request, teller.tick);
    complain(program, fmt::format("{}, about {}, at most {}", counted(study.parts().size(), "part"),
                                  duration(study.estimate()), duration(request.budget)));
    if (const auto status = prepared(study, options, teller, study.parts().size())) return *status;
    return report(study, study.measure(), outputs, teller);
}

/// Measures those parts of the scene that the file lacks, then times all that it has no time of.
void measure_shard(PriceStudy& study, const std::vector<std::size_t>& places, PartFile& file) {
    std::vector<std::size_t> untimed;
    for (const std::size_t n : places) {
        const std::string& key = study.parts()[n].key;
        if (!file.has(key)) file.add(key, nullptr, result_json(study.measure_one(n)));
        if (file.part().points.at(key).costs.empty()) untimed.push_back(n);
    }
    if (untimed.empty()) return;
    const std::vector<PartCost> costs = study.time(untimed);
    for (std::size_t n = 0; n < untimed.size(); ++n) file.add_cost(study.parts()[untimed[n]].key, cost_json(costs[n]));
}

/// A study, or a shard of one, whose parts are kept as they are done. The whole ends as one at once does.
int in_parts(const PriceOptions& options, const PriceRequest& request, const SweepOutputs& outputs,
             const Shard& shard) {
    Teller teller;
    PriceStudy study(request, teller.tick);
    PartFile file(options.part, identity_of(options, request), shard);
    const std::vector<std::size_t> places = shard.places(study.parts().size());
    std::size_t missing = 0;
    for (const std::size_t n : places) missing += !file.has(study.parts()[n].key);
    complain(program, fmt::format("shard {}: {} of {}, {} of them done, about {}", shard.text(), places.size(),
                                  counted(study.parts().size(), "part"), places.size() - missing,
                                  duration(study.seconds_for(missing))));
    if (const auto status = prepared(study, options, teller, missing)) return *status;
    file.set_basis(basis_json(study));
    measure_shard(study, places, file);
    if (shard.is_whole()) return report(study, prices_in(file.part(), study), outputs, teller);
    teller.progress.reset();
    return say_shard_is_done(file.part());
}

PriceRequest request_in(const PriceOptions& options, const Scene& scene) {
    PriceRequest request;
    read_comparison(options, request);
    request.scene = scene;
    return request;
}

}  // namespace

int price(const PriceOptions& options) {
    PriceRequest request = request_in(options, Scene{});
    if (!options.write.empty() && !request.tolerance)
        throw InputError("--write: it saves the scene that --tolerance leaves; give --tolerance too");
    request.scene = scene_in(options.scene, options.set);
    const SweepOutputs outputs{options.json, options.write, options.plot, find_scene(options.scene)};
    const Shard shard = checked_shard(options.part, outputs);
    return request.counts_work ? in_parts(options, request, outputs, shard) : at_once(options, request, outputs);
}

int merge_price(const Joined& joined, const MergeOptions& merging) {
    const PriceOptions options = options_of_price(joined.all.sweep);
    PriceRequest request = request_in(options, parse_scene(joined.all.sweep.scene, joined.all.file + ", its scene"));
    request.counts_work = true;
    if (!merging.write.empty() && !request.tolerance)
        throw InputError("--write: it saves the scene for a tolerance, and the sweep was made without --tolerance");
    Teller teller;
    PriceStudy study(request, teller.tick);
    if (const auto missing = joined.missing(keys_of(study))) {
        complain(program, *missing);
        return exit_not_met;
    }
    // What is left out is looked for beside the reference, of which parts keep too little.
    if (!request.tolerance)
        use_basis(joined.all, [&](const Json& basis) { restore(study, basis); });
    else if (const auto status = prepared(study, options, teller, 0))
        return *status;
    return report(study, prices_in(joined.all, study), {merging.json, merging.write, merging.plot, {}}, teller);
}

}  // namespace drapeau::lab

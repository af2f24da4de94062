#include "merge.hpp"

#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "outputs.hpp"
#include "program.hpp"

namespace drapeau::lab {

namespace {

/// The commands whose sweeps come in parts.
struct Merger {
    const char* command;
    int (*merge)(const Joined&, const MergeOptions&);
};
constexpr Merger mergers[] = {
    {"trade", merge_trade}, {"price", merge_price}, {"converge", merge_converge}, {"stability", merge_stability}};

void check_files(const MergeOptions& options) {
    std::vector<NamedFile> inputs;
    for (const std::string& part : options.parts) inputs.push_back({"a part", part});
    check_plot("--plot", options.plot);
    check_outputs(inputs, asked_for({{"--write", options.write}, {"--json", options.json}, {"--plot", options.plot}}));
}

}  // namespace

int merge(const MergeOptions& options) {
    const Joined joined = join(options.parts);
    const SweepIdentity& sweep = joined.all.sweep;
    check_files(options);
    if (sweep.version != DRAPEAU_VERSION)
        throw InputError(one_line(joined.all.file, 1000) + ": a part of version " + one_line(sweep.version, 60) +
                         "; this is " + DRAPEAU_VERSION + ", which may measure otherwise");
    if (!joined.remark.empty()) complain(program, joined.remark);
    for (const auto& [command, merge_its] : mergers)
        if (sweep.command == command) return merge_its(joined, options);
    throw InputError(one_line(joined.all.file, 1000) + ": a part of " + in_quotes(one_line(sweep.command, 60)) +
                     ", no command whose sweeps come in parts");
}

}  // namespace drapeau::lab

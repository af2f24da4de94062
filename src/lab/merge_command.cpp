#include "commands.hpp"
#include "merge.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* merge_notes =
    "Parts are what --part of a command wrote: all shards of one sweep, in any order, or a whole one. A mix of sweeps "
    "is "
    "refused,\n"
    "and what is missing is named. Then merge says what the command itself would have said of the whole.\n\n"
    "Example: drapeau-lab trade report --shard 1/2 --part 1.jsonl; drapeau-lab trade report --shard 2/2 --part "
    "2.jsonl;\n"
    "         drapeau-lab merge 1.jsonl 2.jsonl --json all.json\n"
    "Exit status: 0 good, 1 points are missing, or as of the command itself, 2 bad input.";

}  // namespace

Job add_merge(CLI::App& command) {
    const auto given = std::make_shared<MergeOptions>();
    MergeOptions& options = *given;
    command.footer(merge_notes);
    take_as_path(command.add_option("PART", options.parts, "Part files")->required());
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    take_as_path(
        command
            .add_option("--write", options.write, "Save the scene with the setting for --tolerance, if its check holds")
            ->type_name("FILE.toml"));
    add_plot_option(command, options.plot, "Draw what the command itself draws");
    return [given] { return merge(*given); };
}

}  // namespace drapeau::lab

#include "run.hpp"

#include "exit_status.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "measure/clocks.hpp"
#include "outputs.hpp"
#include "plan.hpp"
#include "progress.hpp"
#include "results.hpp"
#include "run/divergence.hpp"
#include "run/simulation.hpp"
#include "run/step_choice.hpp"
#include "run_results.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace drapeau::lab {

namespace {

/// Nothing to simulate is fine: it gives the start. Anything else takes at least the shortest step.
double seconds_option(const std::string& text) {
    constexpr double longest = 1e6;
    const double shortest_step = settings::dt_range.lowest;
    const auto number = number_in(text);
    if (number && (*number == 0.0 || (*number >= shortest_step && *number <= longest))) return *number;
    throw InputError("--seconds = " + one_line(text, 60) + ": 0 or a number of seconds from " +
                     shortest(shortest_step) + " to " + shortest(longest) + " is allowed");
}

/// The scene with what the command line says instead.
Scene scene_to_run(const RunOptions& options) {
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set) assignments.push_back(assignment_in(text));
    for (const Assignment& shorthand : {Assignment{"--method", "time.method", options.method},
                                        {"--dt", "time.dt", options.dt},
                                        {"--precision", "time.precision", options.precision}})
        if (!shorthand.value.empty()) assignments.push_back(shorthand);
    return read_scene(find_scene(options.scene), assignments);
}

/// `last` becomes where the last tenth of a second begins, or a shorter run.
std::optional<Divergence> carry_out(const Plan& plan, Simulation& simulation, Cost& cost,
                                    std::optional<ErrorWindow>& last, bool force) {
    const auto wall_start = std::chrono::steady_clock::now();
    const auto wall = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
    };
    const double processor_start = processor_seconds();
    const auto window_of = [](double step) { return std::max(1LL, std::llround(ErrorWindow::usual / step)); };
    Progress progress;
    std::optional<Divergence> divergence;
    for (long long batch = 0; batch < plan.batches && !divergence; ++batch) {
        if (batch == std::max(0LL, plan.batches - window_of(batch_seconds))) last = simulation.error_window();
        divergence = simulation.advance_batch();
        const double share = static_cast<double>(batch + 1) / static_cast<double>(plan.batches);
        progress.show(share);
        if (!force) check_pace(share, wall());
    }
    // A bit at a time, so that the bar moves.
    const double masses = static_cast<double>(simulation.model().grid.masses());
    const auto at_once =
        std::max(1LL, std::llround(std::min(std::max(1e7 / masses, 1.0), batch_seconds / simulation.dt())));
    const long long window_begins = std::max(0LL, plan.steps - window_of(simulation.dt()));
    for (long long done = 0; done < plan.steps && !divergence;) {
        if (done == window_begins) last = simulation.error_window();
        const long long steps = std::min(at_once, (done < window_begins ? window_begins : plan.steps) - done);
        divergence = simulation.advance_steps(steps);
        done += steps;
        const double share = static_cast<double>(done) / static_cast<double>(plan.steps);
        progress.show(share);
        if (!force) check_pace(share, wall());
    }
    if (!divergence) divergence = simulation.check();
    cost.processor = processor_seconds() - processor_start;
    cost.wall = wall();
    return divergence;
}

/// The simulation at its start, which may take a while to find.
Simulation settled(const Scene& scene) {
    constexpr double worth_a_word = 1.0;  // s
    const double start = processor_seconds();
    Simulation simulation(scene);
    const double passed = processor_seconds() - start;
    if (passed > worth_a_word)
        complain("drapeau-lab",
                 "flag.start = \"hanging\": it took " + rounded(passed, 2) + " s to let the flag settle");
    if (!simulation.start_remark().empty()) complain("drapeau-lab", simulation.start_remark());
    return simulation;
}

/// Digits that read back to the same bits in the precision of the run.
std::string state_number(double value, Precision precision) {
    const auto narrow = static_cast<float>(value);
    return precision == Precision::single_precision && static_cast<double>(narrow) == value ? shortest(narrow)
                                                                                            : shortest(value);
}

void write_state(const std::string& file, const Simulation& simulation) {
    const FlagSettings& flag = simulation.scene().flag;
    const Precision precision = simulation.precision();
    const State<double> state = simulation.state();
    write_text_file(file, [&](const Append& append) {
        append("column,row,x,y,z,vx,vy,vz\n");
        for (int row = 0; row < flag.rows; ++row) {
            for (int column = 0; column < flag.columns; ++column) {
                std::string line = std::to_string(column) + "," + std::to_string(row);
                for (const auto& value : {state.position.at(column, row), state.velocity.at(column, row)})
                    for (int axis = 0; axis < 3; ++axis)
                        line.append(1, ',').append(state_number(value[axis], precision));
                append(line + "\n");
            }
        }
    });
}

std::vector<NamedFile> outputs_of(const RunOptions& options) {
    return asked_for({{"--state", options.state}, {"--json", options.json}, {"--csv", options.csv}});
}

void write_results(const RunOptions& options, const std::vector<Result>& results) {
    if (!options.json.empty()) {
        write_text_file(options.json, [&](const Append& append) { append(as_json(results)); });
    }
    if (!options.csv.empty()) {
        write_text_file(options.csv, [&](const Append& append) { append(as_csv(results)); });
    }
}

}  // namespace

int run(const RunOptions& options) {
    const double seconds = seconds_option(options.seconds);
    const Scene scene = scene_to_run(options);
    check_outputs({{"the scene", find_scene(options.scene).string()}}, outputs_of(options));
    const Plan plan = plan_for(scene, seconds, options.seconds);
    Scene planned = scene;
    planned.time.dt = plan.dt;
    if (plan.precision) planned.time.precision = *plan.precision;
    Simulation simulation = settled(planned);
    if (plan.dt) simulation.use_exact_dt();
    if (!options.force) check_duration(scene, simulation, seconds);
    simulation.use_threads(options.threads);

    Cost cost;
    std::optional<ErrorWindow> last;
    const auto divergence = carry_out(plan, simulation, cost, last, options.force);
    const auto error = divergence ? ErrorEstimate{.verdict = ErrorEstimate::Verdict::not_finite}
                       : last     ? simulation.error_since(*last)
                                  : ErrorEstimate{};
    // Equal steps that fill a time are as long as the automatic ones let them be.
    const std::string reason = scene.time.dt || !plan.dt
                                   ? simulation.step_reason()
                                   : "limit: " + limit_of_step(scene.time.method, simulation.model());
    const auto results = results_of(simulation, options.threads, cost, divergence, error, reason);
    write_results(options, results);
    const std::string remark = plan.remark.empty() ? simulation.precision_remark() : plan.remark;
    if (!remark.empty()) complain("drapeau-lab", remark);
    if (!divergence && !simulation.limit_remark().empty()) complain("drapeau-lab", simulation.limit_remark());
    if (divergence) {
        complain("drapeau-lab", divergence->message);
        return exit_diverged;
    }
    if (!options.state.empty()) write_state(options.state, simulation);
    std::fputs(as_table(results).c_str(), place_of_table(outputs_of(options)));
    return exit_good;
}

}  // namespace drapeau::lab

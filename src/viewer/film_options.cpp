#include "film_options.hpp"

#include "film_flight.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/terminal.hpp"
#include "numbered_name.hpp"
#include "obj_file.hpp"
#include "scene/file.hpp"
#include "library.hpp"

#include <string>
#include <vector>

namespace drapeau {

namespace {

constexpr double usual_swing_in = 3.0;  // s, before a film that loops

FilmPlan plan_of(const Options& options, const std::string& file) {
    return {.file = file,
            .width = options.size_given ? options.width : FilmPlan{}.width,
            .height = options.size_given ? options.height : FilmPlan{}.height,
            .rate = options.fps.value_or(usual_film_rate(file)),
            .seconds = options.seconds.value_or(FilmPlan{}.seconds),
            .from = options.from.value_or(options.loop ? usual_swing_in : 0.0),
            .loop = options.loop,
            .transparent = options.transparent};
}

}  // namespace

FilmPlan film_plan(const Options& options) {
    const FilmPlan plan = plan_of(options, options.record);
    try {
        check_film(plan);
    } catch (const InputError& wrong) {
        throw InputError("--record: " + std::string(wrong.what()));
    }
    return plan;
}

FilmPlan shape_plan(const Options& options) {
    FilmPlan plan = plan_of(options, options.obj);
    try {
        check_obj_name(options.obj);
        if (!means_sequence(options.obj)) {
            if (options.seconds || options.fps || options.loop)
                throw InputError(
                    "one shape has no length; a sequence is named with a number's place, such as "
                    "frames-%04d.obj");
            plan.seconds = 1.0 / plan.rate;
        }
        check_times(plan);
    } catch (const InputError& wrong) {
        throw InputError("--obj: " + std::string(wrong.what()));
    }
    return plan;
}

int write_shapes(const Options& options) {
    const FilmPlan plan = shape_plan(options);
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set) assignments.push_back(assignment_in(text));
    const LoadedScene loaded = load_scene(options.scene, assignments);
    const bool sequence = means_sequence(plan.file);
    const auto file = [&](long long number) { return sequence ? numbered(plan.file, number) : plan.file; };
    check_outputs({{"the scene", loaded.file.string()}}, {{"--obj", file(0).string()}});
    FilmFlight flight(plan, loaded.scene, std::nullopt);
    for (long long k = 0; k < plan.frames();) {
        if (const auto frame = flight.take())
            write_obj(file(k++), frame->snapshot);
        else if (const std::string trouble = flight.trouble(); !trouble.empty()) {
            complain("drapeau", trouble);
            return flight.diverged() ? 3 : 1;
        } else
            flight.wait(1.0);
    }
    return 0;
}

}  // namespace drapeau

// Laws of drapeau-lab trade: on motions known exactly it reports the errors, orders and limits they have; what it
// recommends holds; bad input is refused before work.
#include "lab_bench.hpp"

#include "scene/file.hpp"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <map>
#include <string>
#include <vector>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

using Json = nlohmann::json;

Json trade(const Bench& bench, const std::string& arguments, int status = 0) {
    const Outcome outcome = bench.run("trade " + arguments + " --json t.json");
    INFO(arguments << ": " << outcome.messages << outcome.output);
    REQUIRE(outcome.status == status);
    return Json::parse(contents(bench.path / "t.json"));
}

constexpr double span = 0.5;        // s, as it is unless asked for otherwise
constexpr int samples = 30;         // in it
constexpr double known_to = 1e-10;  // m, what references of these motions must be known to

/// The motion of the scene "spring" from rest at its rest length: u is the spring's extension, downwards.
struct Spring {
    double m = 0.1, k = 5.0, c = 0.01, g = 9.8;

    double at(double t) const {
        const double gamma = 0.5 * c / m, w = std::sqrt(k / m - gamma * gamma), rest = m * g / k;
        return rest - rest * std::exp(-gamma * t) * (std::cos(w * t) + gamma / w * std::sin(w * t));
    }
};

/// The error (m) at the end and over the samples of the recurrence that `step` makes of (u, v).
template <class Step>
std::pair<double, double> errors_of(const Spring& spring, long long steps_a_batch, const Step& step) {
    double u = 0.0, v = 0.0, squares = 0.0, last = 0.0;
    const double dt = 1.0 / 60.0 / static_cast<double>(steps_a_batch);
    for (int sample = 1; sample <= samples; ++sample) {
        for (long long n = 0; n < steps_a_batch; ++n) step(u, v, dt);
        last = std::abs(u - spring.at(sample / 60.0));
        squares += last * last;
    }
    return {last, std::sqrt(squares / samples)};
}

}  // namespace

TEST_CASE("the errors of a spring are those of each method's own recurrence, and the orders the methods' own") {
    const Bench bench;
    const Json found = trade(bench, "spring --settle 0 --precisions double");
    CHECK(found["compared"] == "trajectories");
    CHECK(found["horizon_s"].is_null());
    CHECK(found["seconds"] == Approx(span));
    CHECK(found["reference"]["error_m"].get<double>() < known_to);

    const Spring s;
    int compared = 0;
    for (const Json& point : found["points"]) {
        const auto steps = std::llround(1.0 / 60.0 / point["dt"].get<double>());
        const auto check = [&](const std::pair<double, double>& errors) {
            INFO(point["key"]);
            // The reference, and 500 steps of rounding.
            CHECK(point["error_rms_m"].get<double>() == Approx(errors.first).margin(known_to));
            CHECK(point["error_over_time_m"].get<double>() == Approx(errors.second).margin(known_to));
            CHECK(point["error_max_m"].get<double>() >= point["error_rms_m"].get<double>());
            CHECK(point["ms_per_second"].get<double>() > 0.0);
            CHECK(point["diverged"] == false);
            CHECK(point["force_evaluations"] == samples * steps);
            ++compared;
        };
        const auto a = [&](double u, double v) { return s.g - (s.k * u + s.c * v) / s.m; };
        if (point["method"] == "semi-implicit-euler")
            check(errors_of(s, steps, [&](double& u, double& v, double dt) {
                v += dt * a(u, v);
                u += dt * v;
            }));
        if (point["method"] == "forward-euler")
            check(errors_of(s, steps, [&](double& u, double& v, double dt) {
                const double before = v;
                v += dt * a(u, v);
                u += dt * before;
            }));
    }
    CHECK(compared >= 8);

    const std::map<std::string, double> orders{{"forward-euler", 1}, {"semi-implicit-euler", 1}, {"leapfrog", 2},
                                               {"rk4", 4},           {"implicit-euler", 1},      {"xpbd", 1}};
    CHECK(found["orders"].size() == orders.size());
    for (const Json& fit : found["orders"]) {
        INFO(fit);
        CHECK(fit["order"].get<double>() == Approx(orders.at(fit["method"])).margin(0.1));
    }
}

TEST_CASE("the errors of masses carried by wind and weight are those of the closed form") {
    const Bench bench;
    // T03: every mass moves alike and no spring is ever stretched; started from rest.
    bench.write("fall.toml",
                "[flag]\ncolumns = 2\nrows = 2\nwidth = 0.1\nheight = 0.1\nattach = \"none\"\ndisturbance = 0\n"
                "[springs]\nmass = 0.01\nstiffness = 1\ndrag = 0.02\n"
                "[gravity]\nacceleration = [0, -9.81, 0]\n[wind]\nvelocity = [6, 0, 0]\ngusts = [0, 0, 0]\n");
    const Json found = trade(bench,
                             "fall.toml --settle 0 --precisions double --dt 0.0005,0.001 "
                             "--methods semi-implicit-euler,forward-euler");
    CHECK(found["points"].size() == 4);
    const double rate = 2.0;  // d/m
    const double terminal = glm::length(glm::dvec3(6.0, -9.81 / rate, 0.0));
    const double exact = terminal * (span - (1.0 - std::exp(-rate * span)) / rate);
    for (const Json& point : found["points"]) {
        INFO(point);
        const double dt = point["dt"], n = std::round(span / dt), r = 1.0 - rate * dt;
        const double factor = point["method"] == "semi-implicit-euler" ? r : 1.0;
        const double stepped = terminal * (n * dt - dt * factor * (1.0 - std::pow(r, n)) / (1.0 - r));
        CHECK(point["error_rms_m"].get<double>() == Approx(std::abs(stepped - exact)).margin(known_to));
    }
}

TEST_CASE("a step just past a chain's limit diverges, one just below does not") {
    const Bench bench;
    // T08: twelve masses on a chain that is held at one end, w = 2 sqrt(k/m) sin(23 pi/50), 0.2 % below the bound. The
    // limit 2/w lies between the tenth and the eleventh of 1/60 s. Let go stretched, it swings along itself.
    const double limit = 1.0 / 60.0 / 10.5, w = 2.0 / limit, m = 0.01;
    const double k = m * std::pow(0.5 * w / std::sin(23.0 * M_PI / 50.0), 2);
    bench.write("chain.toml",
                "[flag]\ncolumns = 13\nrows = 1\nwidth = 1.2\nattach = \"hoist\"\nprestretch = 0.1\n[springs]\n"
                "mass = 0.01\nstiffness = " +
                    std::to_string(k) + "\n");
    const Json found =
        trade(bench, "chain.toml --settle 0 --methods semi-implicit-euler,leapfrog --dt 0.001666667,0.00151516");
    CHECK(found["points"].size() == 8);
    for (const Json& point : found["points"]) {
        INFO(point);
        const bool is_past = point["dt"] > limit;
        CHECK(point["diverged"] == is_past);
        CHECK(point["ms_per_second"].is_null() == is_past);
        CHECK(point["error_rms_m"].is_null() == is_past);
        CHECK((point["outcome"] == "diverged") == is_past);
    }
}

TEST_CASE("the front holds the points that no other beats, and none that the reference cannot resolve") {
    const Bench bench;
    const Json found = trade(bench,
                             "spring --methods leapfrog,rk4,semi-implicit-euler --precisions double --dt "
                             "0.016666,0.002,0.0005,0.00002 --tolerance 1mm");
    const double resolved = 10.0 * found["reference"]["error_m"].get<double>();
    bool has_finer = false;
    const auto beats = [](const Json& a, const Json& b) {
        return a["ms_per_second"] <= b["ms_per_second"] && a["error_rms_m"] < b["error_rms_m"];
    };
    REQUIRE(found["front"].size() >= 2);
    for (const Json& point : found["points"]) {
        const bool is_fine = point["error_in_time_rms_m"].get<double>() < resolved;
        has_finer = has_finer || is_fine;
        bool on_front = false, beaten = false;
        for (const Json& other : found["front"]) on_front = on_front || other["key"] == point["key"];
        for (const Json& other : found["points"])
            beaten = beaten || (!other["below_resolution"] && beats(other, point));
        INFO(point);
        if (on_front) CHECK_FALSE(point["below_resolution"]);
        if (!point["below_resolution"]) CHECK(on_front == !beaten);
    }
    double last = 0.0;
    for (const Json& point : found["front"]) {
        CHECK(point["ms_per_second"] >= last);
        last = point["ms_per_second"];
    }
}

TEST_CASE(
    "the setting recommended is the cheapest within the tolerance, is checked, and is saved as a scene that runs") {
    const Bench bench;
    const double tolerance = 1e-4;
    const Json found = trade(bench, "spring --tolerance 0.1mm --write quick.toml");
    const Json& best = found["recommended"];
    // Each on another stretch.
    for (const Json* judged : {&best, &found["confirmed"], &found["verified"]}) {
        CHECK((*judged)["key"] == best["key"]);
        CHECK((*judged)["error_rms_m"] <= tolerance);
        CHECK((*judged)["error_over_time_m"] <= tolerance);
    }
    CHECK(found["confirmed"]["error_rms_m"] != best["error_rms_m"]);
    CHECK(found["verified"]["error_rms_m"] != found["confirmed"]["error_rms_m"]);
    for (const Json& point : found["points"])
        if (point["ms_per_second"] < best["ms_per_second"]) {
            bool was_rejected = false;
            for (const Json& other : found["rejected"]) was_rejected = was_rejected || other["key"] == point["key"];
            const bool meets = point["error_rms_m"] <= tolerance && point["error_over_time_m"] <= tolerance;
            CHECK(meets == was_rejected);
        }
    for (const Json& other : found["rejected"])
        CHECK((other["error_rms_m"] > tolerance || other["error_over_time_m"] > tolerance));

    const Scene saved = read_scene(bench.path / "quick.toml");
    CHECK(name_of(saved.time.method) == best["method"].get<std::string>());
    CHECK(name_of(saved.time.precision) == best["precision"].get<std::string>());
    CHECK(saved.time.dt == best["dt"].get<double>());
    Scene given = read_scene(find_scene("spring"));
    given.time = saved.time;
    CHECK(given == saved);
    CHECK(bench.run("run quick.toml --seconds 0.5").status == 0);
}

TEST_CASE("where no setting meets the tolerance that is said, the nearest is named and nothing is saved") {
    const Bench bench;
    const Outcome outcome =
        bench.run("trade spring --methods implicit-euler --dt 0.01 --tolerance 1um --write quick.toml");
    CHECK(outcome.status == 1);
    CHECK(has(outcome.output, "no setting measured is within 1 µm; the nearest is implicit-euler"));
    CHECK(bench.files().empty());
}

TEST_CASE("another model has a reference of its own and is judged at the masses of the scene") {
    const Bench bench;
    bench.write("chain.toml",
                "[flag]\ncolumns = 1\nrows = 7\nheight = 0.6\nattach = \"top\"\n[springs]\nmass = 0.01\n"
                "stiffness = 100\ndamping = 0.01\ndrag = 0.02\n[gravity]\n[wind]\nvelocity = [2, 0, 1]\n");
    const Json found = trade(
        bench, "chain.toml --grids 1x4 --limits 0.2 --methods leapfrog --precisions double --dt 0.001 --settle 0.5");
    CHECK(found["other_references"].size() == 3);
    REQUIRE(found["points"].size() == 4);
    const Json& same = found["points"][0];
    const Json& coarse = found["points"][1];
    CHECK(same["key"] == "leapfrog 17 double 1x7");
    CHECK(same["error_rms_m"] == same["error_in_time_rms_m"]);
    CHECK(coarse["key"] == "leapfrog 17 double 1x4");
    CHECK(coarse["rows"] == 4);
    // The grid is what is wrong with it, not the step.
    CHECK(coarse["error_rms_m"].get<double>() > 10.0 * coarse["error_in_time_rms_m"].get<double>());
    CHECK(found["points"][2]["limit"] == 0.2);
}

TEST_CASE("beyond the chaos horizon statistics are compared, and a tolerance is refused") {
    const Bench bench;
    // Stretched by a half, held at two corners, undamped: neighbouring motions part tenfold in 0.09 s.
    bench.write(
        "wild.toml",
        "[flag]\ncolumns = 5\nrows = 4\nwidth = 0.4\nheight = 0.3\nattach = \"grommets\"\nstart = \"crumpled\"\n"
        "prestretch = 0.5\n[springs]\nmass = 0.01\nstiffness = 100\ndiagonal_stiffness = 50\n[gravity]\n");
    const std::string arguments = "wild.toml --settle 0 --methods leapfrog --precisions double --dt 0.002 --budget 1 ";
    const Json far = trade(bench, arguments + "--seconds 3");
    CHECK(far["compared"] == "statistics");
    CHECK(far["horizon_s"] < 1.5);
    CHECK(far["growth_per_s"] > 10.0);
    CHECK(far["front"].empty());
    for (const Json& point : far["points"]) {
        CHECK(point["error_rms_m"].is_null());
        CHECK(point["statistics"]["variance_error_m2"] > 0.0);
    }
    const Outcome asked = bench.run("trade " + arguments + "--seconds 3 --tolerance 1mm");
    CHECK(asked.status == 2);
    CHECK(has(asked.messages, "--tolerance = 1mm: within 3 s the motion is chaotic"));
    // Nobody having asked for a time, as much is compared as can be.
    const Json near = trade(bench, arguments);
    CHECK(near["compared"] == "trajectories");
    CHECK(near["seconds"] < 0.5);
}

TEST_CASE("what trade cannot do is refused before work, in one line") {
    const Bench bench;
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        check_refused(bench.run("trade report " + arguments), part);
    };
    for (const std::string tolerance : {"0mm", "-1mm", "1", "'1 parsec'", "nanmm", "infm", "1e9m", "mm"})
        refused("--tolerance=" + tolerance, "with its unit");
    for (const std::string seconds : {"0", "-1", "nan", "1e9", "soon"})
        refused("--seconds=" + seconds, "--seconds = " + seconds + ": a number of seconds");
    refused("--seconds 0.33", "a whole number of sixtieths of a second, such as 0.333333");
    for (const std::string settle : {"-1", "nan", "1e9", "long"})
        refused("--settle=" + settle, "--settle = " + settle + ": a number of seconds from 0");
    for (const std::string budget : {"0", "-1", "nan", "1e9", "inf", "much"})
        refused("--budget=" + budget, "--budget = " + budget + ": a number of minutes");
    refused("--budget 0.01 --set flag.columns=400", "--budget: swinging in and the reference alone take about");
    refused("--methods rk5", "--methods = rk5: \"forward-euler\"");
    refused("--methods leapfrog,,rk4", "--methods = (nothing)");
    refused("--precisions half", "\"float\" or \"double\"");
    for (const std::string dt : {"0", "-1", "0.1", "nan", "auto"}) refused("--dt=" + dt, "--dt = " + dt);
    for (const std::string grid : {"10", "0x3", "x", "3x", "3x-1", "2x2x2"})
        refused("--grids=" + grid, "--grids = " + grid);
    refused("--grids 9999x9999", "of memory");
    for (const std::string limit : {"-1", "none", "nan", "11"}) refused("--limits=" + limit, "--limits = " + limit);
    refused("--set flag.attach=all", "every mass is held");
    refused("--write quick.toml", "--tolerance");
    refused("--json no/such/file", "no/such/file: cannot be written");
    refused("--tolerance 1mm --write .", "folder");
    refused("--tolerance 1mm --write x --json x", "--json = x: the same file as --write");
    check_refused(bench.run("trade"), "SCENE");
    check_refused(bench.run("trade no-such"), "no-such: no such file or shipped scene");
    CHECK(bench.files().empty());
}

TEST_CASE("an interrupted sweep leaves no file behind, and what is not written fails it") {
    const Bench bench;
    bench.write("old.json", "what was there before");
    const Outcome outcome = bench.run("trade report --budget 60 --json old.json --tolerance 1mm --write new.toml",
                                      "timeout --preserve-status --signal=INT 0.5 ");
    CHECK(outcome.status == 128 + SIGINT);
    CHECK(contents(bench.path / "old.json") == "what was there before");
    CHECK(bench.files() == std::vector<std::string>{"old.json"});
    const Outcome full = bench.run("trade spring --methods leapfrog --dt 0.01 --json /dev/full");
    CHECK(full.status == 2);
    CHECK(has(full.messages, "/dev/full: cannot be written: No space left"));
}

TEST_CASE("the help of trade says what its tolerance is, and its exit status") {
    const Bench bench;
    const Outcome help = bench.run("trade --help");
    CHECK(help.status == 0);
    CHECK(has(help.output, "It is not time.tolerance of scenes"));
    CHECK(has(help.output, "Exit status: 0 good, 1 no setting meets"));
    CHECK(has(bench.run("--help").output, "trade"));
}

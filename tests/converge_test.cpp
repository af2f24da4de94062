// Laws of drapeau-lab converge: on motions known exactly it reports the differences and orders they have; where grids
// or steps do not converge it names the cause; bad input is refused before work.
#include "lab_bench.hpp"
#include "sanitized.hpp"
#include "scene/file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

using Json = nlohmann::json;

Json converge(const Bench& bench, const std::string& arguments) {
    const Outcome outcome = bench.run("converge " + arguments + " --json c.json");
    INFO(arguments << ": " << outcome.messages << outcome.output);
    REQUIRE(outcome.status == 0);
    return Json::parse(contents(bench.path / "c.json"));
}

/// T01: one mass on a spring, let go 10 mm too long.
constexpr const char* oscillator =
    "[flag]\ncolumns = 1\nrows = 2\nheight = 1\nattach = \"top\"\nprestretch = 0.01\n"
    "[springs]\nmass = 0.01\nstiffness = 100\ndamping = 0.2\n";

/// A square cloth of 0.9 m, 200 N/m, 0.11 kg/m2, its edges held, on 4 x 4 cells.
std::string square_cloth(double prestretch, const std::string& more) {
    return "[flag]\ncolumns = 5\nrows = 5\nwidth = 0.9\nheight = 0.9\nattach = \"edges\"\nprestretch = " +
           std::to_string(prestretch) + "\n[springs]\nmass = 0.00556875\nstiffness = 150\ndiagonal_stiffness = 75\n" +
           more;
}
constexpr double rho = 0.11, side = 0.9, k = 150.0;  // kg/m2, m, N/m; diagonals k/2

/// m w^2 over s = 1 - 1/stretch of the mode (p, q) of N x N cells, across the cloth.
double lattice(int N, int p, int q) {
    const double P = std::cos(p * M_PI / N), Q = std::cos(q * M_PI / N);
    return 2.0 * k * (2.0 - P - Q) + 2.0 * k * (1.0 - P * Q);
}
double mass(int N) {
    return rho * side * side / (N * N);
}

/// How deep (m) the cloth stretched by a tenth hangs at coarse mass (i, j) of 4 x 4 cells, on N x N cells, after
/// time t (s; negative: at rest) under g (m/s2) across it: the sum over its modes, which a uniform load meets with
/// (2/N)^2 cot cot / g each.
double depth(int N, int i, int j, double t, double g) {
    const double s = 1.0 - 1.0 / 1.1;
    double sum = 0.0;
    for (int p = 1; p < N; p += 2)
        for (int q = 1; q < N; q += 2) {
            const double ww = s * lattice(N, p, q) / mass(N);
            const double load =
                g * std::pow(2.0 / N, 2) / (std::tan(0.5 * p * M_PI / N) * std::tan(0.5 * q * M_PI / N));
            const double shape = std::sin(p * M_PI * i / 4.0) * std::sin(q * M_PI * j / 4.0);
            sum += shape * load / ww * (t < 0.0 ? 1.0 : 1.0 - std::cos(std::sqrt(ww) * t));
        }
    return sum;
}

/// Root mean square (m) over the free masses of 4 x 4 cells and the times (s) of how far N and 2N cells are apart.
double apart(int N, const std::vector<double>& times, double g) {
    double squares = 0.0;
    int count = 0;
    for (const double t : times)
        for (int j = 1; j < 4; ++j)
            for (int i = 1; i < 4; ++i, ++count)
                squares += std::pow(depth(2 * N, i, j, t, g) - depth(N, i, j, t, g), 2);
    return std::sqrt(squares / count);
}

}  // namespace

TEST_CASE("every method shows its own order on one spring, and the errors of its own recurrence") {
    const Bench bench;
    bench.write("t01.toml", oscillator);
    const Json found = converge(bench, "t01.toml --seconds 0.05");
    const std::map<std::string, double> orders{{"forward-euler", 1}, {"semi-implicit-euler", 1}, {"leapfrog", 2},
                                               {"rk4", 4},           {"implicit-euler", 1},      {"xpbd", 1}};
    CHECK(found["methods"].size() == orders.size());
    for (const Json& method : found["methods"]) {
        INFO(method);
        CHECK(method["order"].get<double>() == Approx(orders.at(method["method"])).margin(0.1));
        CHECK(method["declared_order"] == orders.at(method["method"]));
        CHECK(method["flag"] == "asymptotic");
    }

    constexpr double m = 0.01, stiffness = 100.0, c = 0.2, x0 = 0.01, gamma = 0.5 * c / m;
    const double w = std::sqrt(stiffness / m - gamma * gamma);
    CHECK(x0 * std::exp(-gamma * 0.05) * (std::cos(w * 0.05) + gamma / w * std::sin(w * 0.05)) ==
          Approx(9.855066761858644e-4));
    std::vector<double> before;
    int compared = 0;
    for (const Json& step : found["steps"]) {
        if (step["method"] != "semi-implicit-euler") continue;
        const double dt = step["dt"];
        const auto a_batch = std::llround(1.0 / 60.0 / dt);
        std::vector<double> now;
        double x = x0, v = 0.0, errors = 0.0, differences = 0.0;
        for (int sample = 1; sample <= 3; ++sample) {
            for (long long n = 0; n < a_batch; ++n) {
                v += dt * -(stiffness * x + c * v) / m;
                x += dt * v;
            }
            const double t = sample / 60.0;
            errors += std::pow(x - x0 * std::exp(-gamma * t) * (std::cos(w * t) + gamma / w * std::sin(w * t)), 2);
            if (!before.empty()) differences += std::pow(x - before[now.size()], 2);
            now.push_back(x);
        }
        INFO(step);
        // What the reference is known to, and rounding.
        CHECK(step["error_m"].get<double>() == Approx(std::sqrt(errors / 3.0)).margin(1e-11));
        if (!before.empty())
            CHECK(step["difference_m"].get<double>() == Approx(std::sqrt(differences / 3.0)).margin(1e-13));
        before = now;
        ++compared;
    }
    CHECK(compared >= 4);
}

TEST_CASE("grids of a taut membrane at rest under its weight differ as their lattices do, at order 2") {
    const Bench bench;
    // Drag of twice the slowest mode's rate: after half a second 1e-15 of the motion is left.
    bench.write("membrane.toml", square_cloth(0.1, "drag = 0.86\n[gravity]\nacceleration = [0, 0, -0.01]\n"));
    const Json found = converge(bench, "membrane.toml --settle 0.5 --seconds 0.05 --methods leapfrog");
    REQUIRE(found["grids"].size() == 4);
    for (std::size_t n = 1; n < 4; ++n) {
        const Json& grid = found["grids"][n];
        INFO(grid);
        CHECK(grid["columns"] == (4 << n) + 1);
        // Slopes of 1e-5 change the tension by their square only; positions of 1 m are known to 1e-16 m, 1e-7 of the
        // least difference.
        CHECK(grid["difference_m"].get<double>() == Approx(apart(4 << (n - 1), {-1.0}, 0.01)).epsilon(1e-5));
        CHECK(grid["compressed_share"] == 0.0);
        if (n > 1) CHECK(grid["flag"] == "converging");
    }
    CHECK(found["grids"][3]["order"].get<double>() == Approx(2.0).margin(0.1));
    CHECK(found["grids_verdict"] == "converges");
    CHECK(has(found["conclusion"], "Finer grids converge, at order 2.0"));
}

TEST_CASE("grids of a taut membrane that swings differ as the sums over their modes do") {
    const Bench bench;
    bench.write("membrane.toml", square_cloth(0.1, "[gravity]\nacceleration = [0, 0, -0.01]\n"));
    const Json found = converge(bench, "membrane.toml --seconds 0.1 --methods leapfrog");
    std::vector<double> times;
    for (int sample = 1; sample <= 6; ++sample) times.push_back(sample / 60.0);
    REQUIRE(found["grids"].size() == 4);
    for (std::size_t n = 1; n < 4; ++n) {
        INFO(found["grids"][n]);
        // At half its limit rk4 shifts and damps the fastest modes, which hold little.
        CHECK(found["grids"][n]["difference_m"].get<double>() ==
              Approx(apart(4 << (n - 1), times, 0.01)).epsilon(1e-2));
    }
    CHECK(found["grids"][3]["flag"] == "converging");
}

TEST_CASE("grids of a chain that hangs converge at order 1, and its heavy end is named as the cause") {
    const Bench bench;
    // M = 0.1 kg without its ends, K = EA/L = 10 N/m. N springs are longer at s of the way by
    // (M g/K) [s - s^2/2 + s/(2N)], so that N and 2N are apart by (M g/K) s/(4N).
    bench.write("chain.toml",
                "[flag]\ncolumns = 1\nrows = 5\nheight = 0.5\nattach = \"top\"\n[springs]\nmass = 0.025\n"
                "stiffness = 40\ndrag = 0.75\n[gravity]\n");
    const Json found = converge(bench, "chain.toml --settle 3 --seconds 0.05 --methods leapfrog");
    const double mean_square = (1.0 + 4.0 + 9.0 + 16.0) / 16.0 / 4.0;  // of s at the coarsest grid's four masses
    REQUIRE(found["grids"].size() == 4);
    for (std::size_t n = 1; n < 4; ++n) {
        const Json& grid = found["grids"][n];
        INFO(grid);
        const int N = 4 << (n - 1);
        CHECK(grid["difference_m"].get<double>() ==
              Approx(0.1 * 9.8 / 10.0 / (4.0 * N) * std::sqrt(mean_square)).epsilon(1e-6));
        if (n > 1) CHECK(grid["order"].get<double>() == Approx(1.0).margin(1e-6));
        CHECK(grid["fold_cells"].is_null());
    }
    // With half a mass at its end it is as long on any grid.
    CHECK(found["light_borders"]["difference_m"].get<double>() < 1e-9);
    CHECK(found["grids_verdict"] == "converges, borders lower the order");
}

TEST_CASE("a compressed sheet without bending does not converge, and grows as its grid lets it") {
    const Bench bench;
    bench.write("short.toml", square_cloth(-0.01, ""));
    const Json found = converge(bench, "short.toml --seconds 0.5 --methods leapfrog");
    CHECK(found["grids_verdict"] == "compression");
    CHECK(has(found["conclusion"], "Finer grids do not converge here"));
    const auto& grids = found["grids"];
    REQUIRE(grids.size() == 4);
    for (std::size_t n = 0; n < 4; ++n) {
        INFO(grids[n]);
        CHECK(grids[n]["compressed_share"] > 0.5);
        CHECK(grids[n]["fold_cells"] < 4.0);
        CHECK(grids[n]["flag"] != "converging");
        // The fastest mode is the one of the shortest waves. Finer grids leave too few moments of free growth.
        const int N = 4 << n;
        const double fastest = std::sqrt((1.0 / 0.99 - 1.0) * lattice(N, N - 1, N - 1) / mass(N));  // 1/s
        if (n < 2) CHECK(grids[n]["growth_per_s"].get<double>() == Approx(fastest).epsilon(0.05));
    }
    CHECK(grids[1]["growth_per_s"].get<double>() > 1.8 * grids[0]["growth_per_s"].get<double>());
    // In metres folds shrink with the cells.
    CHECK(grids[3]["fold_wavelength_m"].get<double>() < 0.2 * grids[0]["fold_wavelength_m"].get<double>());
}

TEST_CASE("a stretch limit that holds masses back lowers every order, which is said") {
    const Bench bench;
    bench.write("limited.toml",
                "[flag]\ncolumns = 1\nrows = 5\nheight = 0.5\nattach = \"top\"\n[springs]\nmass = 0.025\n"
                "stiffness = 40\n[gravity]\n[limit]\nstretch = 0.05\n");
    const Json found = converge(bench, "limited.toml --methods leapfrog,rk4 --levels 3");
    CHECK(found["methods"].size() == 2);
    for (const Json& method : found["methods"]) {
        INFO(method);
        CHECK(method["flag"] == "limit");
        // Until what the limit may leave, 10^-4 of 0.125 m, is all there is to see.
        std::vector<double> errors;
        for (const Json& step : found["steps"])
            if (step["method"] == method["method"]) errors.push_back(step["error_m"].get<double>());
        REQUIRE(errors.size() > 4);
        const double order = std::log2(errors[0] / errors[4]) / 4.0;
        INFO(order);
        CHECK(order > 0.5);
        CHECK(order < 1.7);  // of 2 and 4
    }
    CHECK(has(found["conclusion"], "leapfrog and rk4: a lower order, for the stretch limit"));
}

TEST_CASE("a stretch limit is named where grids converge at a low order, or not, because of it") {
    const Bench bench;
    // The chain of the test above whose end is heavy, but hung by both ends: no border moves.
    const std::string chain =
        "[flag]\ncolumns = 1\nrows = 5\nheight = 0.5\nattach = \"top\"\n[springs]\nmass = 0.025\nstiffness = 40\n"
        "drag = 0.75\n[gravity]\n";
    bench.write("free.toml", chain);
    bench.write("limited.toml", chain + "[limit]\nstretch = 0.01\n");
    const std::string arguments = " --settle 1 --seconds 0.05 --methods leapfrog --levels 4";
    CHECK_FALSE(has(converge(bench, "free.toml" + arguments)["conclusion"], "stretch limit"));
    const Json found = converge(bench, "limited.toml" + arguments);
    CHECK(has(found["conclusion"], "the stretch limit moves masses after each step"));
}

TEST_CASE(
    "where the grids' ratios show different orders that is said, and one good ratio is not taken for convergence") {
    const Bench bench;
    // So coarse a drum in so short a time: the first difference is the smallest.
    const fs::path scene = assets_directory() / "scenes" / "linear-drag" / "drum.toml";
    const std::string drum =
        "'" + scene.string() + "' --set flag.rows=5 --methods leapfrog --seconds 0.1 --levels 4 --set flag.columns=";
    const Json found = converge(bench, drum + "7");
    const double first = found["grids"][2]["order"], last = found["grids"][3]["order"];
    REQUIRE(std::abs(first - last) > 0.5);
    REQUIRE(first < 0.5);
    REQUIRE(last > 0.5);
    CHECK(found["orders_disagree"] == true);
    CHECK(has(found["conclusion"], "The grids' ratios disagree (orders -0."));
    CHECK(found["grids_verdict"] == "too coarse");

    bench.write("membrane.toml", square_cloth(0.1, "drag = 0.86\n[gravity]\nacceleration = [0, 0, -0.01]\n"));
    const Json steady = converge(bench, "membrane.toml --settle 0.5 --seconds 0.05 --methods leapfrog");
    CHECK(steady["orders_disagree"] == false);
    CHECK_FALSE(has(steady["conclusion"], "disagree"));
}

TEST_CASE("what the budget does not suffice for is left out, the finest first, and that is said") {
    const Bench bench;
    const std::string budget = sanitized ? "2" : "0.1";
    const Json found = converge(bench, "report --set flag.columns=9 --set flag.rows=7 --levels 9 --budget " + budget +
                                           " --methods leapfrog,forward-euler");
    const auto& left_out = found["left_out_grids"];
    REQUIRE(!left_out.empty());
    CHECK(left_out.back()["columns"] == 8 * 256 + 1);
    CHECK(found["grids"].size() + left_out.size() == 9);
    CHECK(found["grids"][0]["columns"] == 9);
    CHECK(has(found["methods"][1]["left_out"], "more than --budget leaves"));
    CHECK(found["methods"][1]["flag"] == "left out");
}

TEST_CASE("what converge cannot do is refused before work, in one line") {
    const Bench bench;
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        check_refused(bench.run("converge report " + arguments), part);
    };
    refused("--methods rk5", "--methods = rk5: \"forward-euler\"");
    for (const std::string levels : {"2", "11", "3.5", "many", "nan"})
        refused("--levels=" + levels, "--levels = " + levels);
    refused("--levels 9", "--levels = 9: flag.columns = ");
    refused("--grids 23x15", "--grids = 23x15: three grids or more");
    refused("--grids 23x15,45x30,89x59", "--grids = 45x30: half the cells of 23x15 before it, which is 45x29,");
    refused("--grids 23x15,x,89x57", "--grids = x");
    refused("--grids 3x3,5x5,9x9 --levels 3", "--levels");
    for (const std::string seconds : {"0", "-1", "nan", "1e9", "soon"})
        refused("--seconds=" + seconds, "--seconds = " + seconds + ": a number of seconds");
    refused("--settle=-1", "--settle = -1: a number of seconds from 0");
    for (const std::string budget : {"0", "nan", "inf", "much"})
        refused("--budget=" + budget, "--budget = " + budget + ": a number of minutes");
    refused("--budget 0.01 --set flag.columns=400", "--budget: swinging in and the reference alone take about");
    refused("--set flag.attach=all", "every mass is held");
    refused("--json no/such/file", "no/such/file: cannot be written");
    refused("--json .", "folder");
    check_refused(bench.run("converge"), "SCENE");
    check_refused(bench.run("converge no-such"), "no-such: no such file or shipped scene");
    CHECK(bench.files().empty());
    CHECK(has(bench.run("converge --help").output, "Example: drapeau-lab converge"));
}

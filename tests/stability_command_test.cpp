// Laws of drapeau-lab stability: measured limits are those of the formulas, over stiffness and damping.
#include "lab_bench.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>

using namespace drapeau::testing;

namespace {

using Json = nlohmann::json;

Json limits_of(const Bench& bench, const std::string& arguments) {
    const Outcome outcome = bench.run("stability " + arguments + " --json s.json");
    INFO(arguments << ": " << outcome.messages << outcome.output);
    REQUIRE(outcome.status == 0);
    CHECK_FALSE(has(outcome.messages, "\r"));  // no bar in a pipe
    return Json::parse(contents(bench.path / "s.json"))["limits"];
}

/// The limits are asked for to 1 %; by_halving measures them to 0.1 %, of methods whose growth is linear past it.
constexpr double one_per_cent = 0.01;

}  // namespace

TEST_CASE("measured limits of a spring are those of the formulas, over stiffness and damping") {
    const Bench bench;
    const Json limits = limits_of(bench, "spring --stiffness 0.5,500 --damping 0,0.1");
    CHECK(limits.size() == 6 * 4);
    for (const Json& limit : limits) {
        INFO(limit["method"] << ", " << limit["stiffness"] << " N/m, " << limit["damping"]
                             << " N s/m: " << limit["measured_dt"] << " s, theory " << limit["theory_dt"] << " s");
        const double m = 0.1, k = limit["stiffness"], c = limit["damping"];
        const double lambda = k / m, beta = c / m;
        // lambda dt^2 + weight beta dt = 4
        const auto where = [&](double weight) {
            const double b = weight * beta;
            return 8.0 / (b + std::sqrt(b * b + 16.0 * lambda));
        };
        const std::string method = limit["method"];
        const std::map<std::string, double> formulas{
            {"forward-euler", beta / lambda}, {"semi-implicit-euler", where(2.0)}, {"leapfrog", where(4.0)}};
        if (const auto formula = formulas.find(method); formula != formulas.end() && formula->second > 0.0)
            CHECK(limit["measured_dt"].get<double>() == Approx(formula->second).epsilon(one_per_cent));
        if (method == "rk4" && c == 0.0)
            CHECK(limit["measured_dt"].get<double>() == Approx(std::sqrt(8.0 / lambda)).epsilon(one_per_cent));
        if (method == "forward-euler" && c == 0.0) CHECK(limit["measured_dt"] == 0.0);
        const bool unlimited = method == "implicit-euler" || method == "xpbd";
        CHECK(limit["unlimited"] == unlimited);
        CHECK(limit["measured_dt"].is_null() == unlimited);
        if (!unlimited)
            CHECK(limit["measured_dt"].get<double>() ==
                  Approx(limit["theory_dt"].get<double>()).epsilon(one_per_cent).margin(1e-12));
        CHECK_FALSE(limit["map"].empty());
    }
}

TEST_CASE("measured limits of a sheet are those found by an independent program, and of theory") {
    const Bench bench;
    bench.write("sheet.toml",
                "[flag]\ncolumns = 8\nrows = 8\nwidth = 0.7\nheight = 0.7\n[springs]\nmass = 0.01\nstiffness = 100\n"
                "diagonal_stiffness = 100\n");
    // By bisection on runs of another implementation in double, s.
    const std::map<double, double> semi_implicit{{0.0, 7.28020e-3}, {0.02, 7.0833e-3}, {0.2, 5.5549e-3}};
    const Json limits = limits_of(
        bench, "sheet.toml --methods semi-implicit-euler,rk4,forward-euler --stiffness 100 --damping 0,0.02,0.2");
    for (const Json& limit : limits) {
        INFO(limit["method"] << ", " << limit["damping"] << " N s/m: " << limit["measured_dt"] << " s, theory "
                             << limit["theory_dt"] << " s");
        const double damping = limit["damping"], measured = limit["measured_dt"];
        if (limit["method"] == "semi-implicit-euler")
            CHECK(measured == Approx(semi_implicit.at(damping)).epsilon(2e-3));
        if (limit["method"] == "rk4" && damping == 0.0) CHECK(measured == Approx(1.0306e-2).epsilon(2e-3));
        CHECK(measured == Approx(limit["theory_dt"].get<double>()).epsilon(one_per_cent));
    }
}

TEST_CASE("methods without a limit have none either where dampers are not in proportion to springs") {
    const Bench bench;
    bench.write("sheet.toml",
                "[flag]\ncolumns = 6\nrows = 5\nwidth = 0.5\nheight = 0.4\n[springs]\nmass = 0.01\nstiffness = 100\n"
                "diagonal_stiffness = 50\ndamping = 0.02\n");
    const Json limits =
        limits_of(bench, "sheet.toml --methods implicit-euler,xpbd,forward-euler --stiffness 100 --damping 0.02");
    for (const Json& limit : limits) {
        INFO(limit["method"]);
        const bool has_none = limit["method"] != "forward-euler";
        CHECK(limit["unlimited"] == has_none);
        CHECK(limit["map"].empty() != has_none);  // of forward Euler nothing is measured there
    }
}

TEST_CASE("noise grows past a limit and not below it, and a limit scales with the root of the stiffness") {
    const Bench bench;
    bench.write(
        "chain.toml",
        "[flag]\ncolumns = 9\nrows = 1\nwidth = 0.8\nattach = \"sides\"\n[springs]\nmass = 0.01\nstiffness = 1\n");
    // T08: w = 2 sqrt(k/m) sin(7 pi/16) of eight springs between fixed ends.
    const Json limits =
        limits_of(bench, "chain.toml --methods semi-implicit-euler,leapfrog --stiffness 1,1e6 --damping 0");
    for (const Json& limit : limits) {
        INFO(limit["method"] << ", " << limit["stiffness"]);
        const double expected = std::sqrt(0.01 / limit["stiffness"].get<double>()) / std::sin(7.0 * M_PI / 16.0);
        CHECK(limit["measured_dt"].get<double>() == Approx(expected).epsilon(1e-3));
        for (const Json& at : limit["map"]) {
            const double share = at["dt"].get<double>() / expected, growth = at["growth_per_step"];
            if (share < 0.999) CHECK(std::abs(growth) < 2e-3);
            // 2 sqrt(2 (share - 1)), or more.
            if (share > 1.009) CHECK(growth > 0.2);
        }
    }
}

TEST_CASE("what stability cannot do is refused before work, in one line") {
    const Bench bench;
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        check_refused(bench.run("stability spring " + arguments), part);
    };
    refused("--methods rk5", "--methods = rk5");
    for (const std::string value : {"0", "-1", "nan", "stiff", "1e99", "1,,2"})
        refused("--stiffness=" + value, "--stiffness = ");
    for (const std::string value : {"-1", "nan", "much", "1e99"}) refused("--damping=" + value, "--damping = " + value);
    refused("--json no/such/file", "no/such/file: cannot be written");
    refused("--set flag.attach=all", "every mass is held");
    check_refused(bench.run("stability"), "SCENE");
    CHECK(has(bench.run("stability --help").output, "Example: drapeau-lab stability"));
}

TEST_CASE("of a fabric the springs along the fly are varied, beyond what a scene may say of it too") {
    const Bench bench;
    // Cells of 0.1 m x 0.08 m: k = Y (1 + s)/(1 + 2s) = 275 N/m, k_x = k [(1 + s) b/a - s a/b].
    bench.write("cloth.toml",
                "[flag]\ncolumns = 5\nrows = 4\nwidth = 0.4\nheight = 0.24\n"
                "[fabric]\nstretch_modulus = 300\ndiagonal_share = 0.1\ndamping_time = 0.001\n");
    const double k = 275.0 * (1.1 * 0.8 - 0.1 / 0.8);
    int at_its_own = 0;
    for (const Json& limit : limits_of(bench, "cloth.toml --methods leapfrog --stiffness 0.0001,207.625 --damping 0")) {
        INFO(limit);
        const double stiffness = limit["stiffness"], damping = limit["damping"];
        CHECK((stiffness == Approx(1e-4) || stiffness == Approx(k)));  // a damping time of 35 minutes at the first
        CHECK((damping == Approx(0.001 * k) || damping == 0.0));
        CHECK(limit["measured_dt"].get<double>() == Approx(limit["theory_dt"].get<double>()).epsilon(one_per_cent));
        at_its_own += stiffness == Approx(k) && damping == Approx(0.001 * k);
    }
    CHECK(at_its_own == 1);
}

TEST_CASE("bending limits every method, those that solve for springs too, as its fastest mode says") {
    // Nine masses in a line between held ends: 16 sin^4(pi/2 (1 - 1/8)) B b/a3 over m, beside which the springs, of
    // 0.01 N/m, are nothing.
    const Bench bench;
    bench.write("beam.toml",
                "[flag]\ncolumns = 9\nrows = 1\nwidth = 0.8\nheight = 0.1\nattach = \"sides\"\n"
                "[springs]\nmass = 0.01\nstiffness = 0.01\n[bending]\nstiffness = 100\n");
    const double lambda = 16.0 * std::pow(std::cos(M_PI / 16.0), 4) * 100.0 * 0.1 / std::pow(0.1, 3) / 0.01;
    int counted = 0;
    for (const Json& limit : limits_of(bench, "beam.toml --stiffness 0.01 --damping 0")) {
        INFO(limit);
        const std::string method = limit["method"];
        if (method == "forward-euler") continue;
        const double expected = (method == "rk4" ? std::sqrt(8.0) : 2.0) / std::sqrt(lambda);
        CHECK(limit["measured_dt"].get<double>() == Approx(expected).epsilon(one_per_cent));
        CHECK(limit["theory_dt"].get<double>() == Approx(expected).epsilon(one_per_cent));
        ++counted;
    }
    CHECK(counted == 2 * 5);  // in both tables
    // Strong drag: seen at the step's beginning by semi-implicit Euler, at its end by methods that solve.
    for (const Json& limit : limits_of(bench, "beam.toml --set springs.drag=4 --stiffness 0.01 --damping 0")) {
        INFO(limit);
        if (limit["method"] == "forward-euler") continue;
        CHECK(limit["measured_dt"].get<double>() == Approx(limit["theory_dt"].get<double>()).epsilon(one_per_cent));
        const double r = 4.0 / 0.01;  // 1/s
        if (limit["method"] == "implicit-euler" || limit["method"] == "xpbd")
            CHECK(limit["theory_dt"].get<double>() ==
                  Approx((r + std::sqrt(r * r + 4.0 * lambda)) / lambda).epsilon(one_per_cent));
    }
}

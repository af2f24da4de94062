// Laws of the laboratory's command line, seen as a user sees them: arguments, outputs, exit status.
#include "lab_bench.hpp"

#include "scene/file.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <map>
#include <string>
#include <vector>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

struct StateLine {
    int column, row;
    glm::dvec3 x, v;
};

std::vector<StateLine> state_in(const fs::path& file) {
    std::istringstream lines(contents(file));
    std::string line;
    std::getline(lines, line);
    REQUIRE(line == "column,row,x,y,z,vx,vy,vz");
    std::vector<StateLine> state;
    while (std::getline(lines, line)) {
        StateLine mass{};
        char more = 0;
        const int read = std::sscanf(line.c_str(), "%d,%d,%lf,%lf,%lf,%lf,%lf,%lf%c", &mass.column, &mass.row,
                                     &mass.x.x, &mass.x.y, &mass.x.z, &mass.v.x, &mass.v.y, &mass.v.z, &more);
        REQUIRE(read == 8);
        state.push_back(mass);
    }
    return state;
}

const std::string two_masses = R"(
[flag]
columns = 1
rows = 2
height = 0.5
attach = "top"
[springs]
mass = 0.02
stiffness = 40
damping = 0.01
drag = 0.03
friction = 0.005
[gravity]
[wind]
velocity = [3, 0.5, -2]
)";

const std::string sheet = R"(
[flag]
columns = 4
rows = 3
width = 0.6
height = 0.4
[springs]
mass = 0.01
stiffness = 100
diagonal_stiffness = 50
[gravity]
)";

}  // namespace

TEST_CASE("the state file of two masses follows the recurrence of the method") {
    const Bench bench;
    bench.write("two.toml", two_masses);
    for (const std::string method : {"semi-implicit-euler", "forward-euler"}) {
        const auto outcome =
            bench.run("run two.toml --seconds 0.3 --dt 0.0005 --precision double --state s.csv --method " + method);
        INFO(outcome.messages);
        REQUIRE(outcome.status == 0);

        // One mass below a fixed one: m a = m g + d (w - v) - c_f v - [k (l - L) + c v.e] e.
        const double m = 0.02, k = 40.0, c = 0.01, d = 0.03, c_f = 0.005, L = 0.5, dt = 0.0005;
        const glm::dvec3 g(0.0, -9.8, 0.0), w(3.0, 0.5, -2.0);
        glm::dvec3 x(0.0, -L, 0.0), v(0.0);
        for (int step = 0; step < 600; ++step) {
            const double l = glm::length(x);
            const glm::dvec3 e = x / l;
            const glm::dvec3 a = g + (d * (w - v) - c_f * v - (k * (l - L) + c * glm::dot(v, e)) * e) / m;
            if (method == "forward-euler") {
                x += dt * v;
                v += dt * a;
            } else {
                v += dt * a;
                x += dt * v;
            }
        }

        const auto state = state_in(bench.path / "s.csv");
        REQUIRE(state.size() == 2);
        CHECK(state[0].row == 0);
        CHECK(state[0].x == glm::dvec3(0.0));
        CHECK(state[0].v == glm::dvec3(0.0));
        CHECK(state[1].column == 0);
        CHECK(state[1].row == 1);
        // 600 steps of rounding in double, of values of order one.
        CHECK(glm::length(state[1].x - x) < 1e-12);
        CHECK(glm::length(state[1].v - v) < 1e-11);
    }
}

TEST_CASE("the state file lists every mass row by row, and of a run of no time where it begins") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    REQUIRE(bench.run("run sheet.toml --seconds 0 --state s.csv").status == 0);
    const auto state = state_in(bench.path / "s.csv");
    REQUIRE(state.size() == 12);
    for (std::size_t n = 0; n < state.size(); ++n) {
        CHECK(state[n].column == static_cast<int>(n) % 4);
        CHECK(state[n].row == static_cast<int>(n) / 4);
        // Columns 0.2 m apart, rows 0.2 m apart, in float.
        CHECK(state[n].x.x == Approx(0.2 * static_cast<double>(n % 4)).epsilon(1e-6).margin(1e-9));
        CHECK(state[n].x.y == Approx(-0.2 * static_cast<double>(n / 4)).epsilon(1e-6).margin(1e-9));
        CHECK(state[n].v == glm::dvec3(0.0));
    }
}

TEST_CASE("digits of a state file are the fewest that read back to the same float") {
    const Bench bench;
    std::string flat = sheet;
    flat.replace(flat.find("width"), 0, "disturbance = 0\n");
    bench.write("sheet.toml", flat);
    REQUIRE(bench.run("run sheet.toml --seconds 0 --state s.csv").status == 0);
    CHECK(has(contents(bench.path / "s.csv"), "\n1,0,0.2,0,0,0,0,0\n"));
}

TEST_CASE("the same run gives the same state file and hash") {
    const Bench bench;
    REQUIRE(bench.run("run storm --seconds 0.1 --state a.csv --json a.json").status == 0);
    REQUIRE(bench.run("run storm --seconds 0.1 --state b.csv --json b.json").status == 0);
    CHECK(contents(bench.path / "a.csv") == contents(bench.path / "b.csv"));
    const auto hash = [&](const std::string& file) {
        const std::string json = contents(bench.path / file);
        return json.substr(json.find("state_hash"), 34);
    };
    CHECK(hash("a.json") == hash("b.json"));
}

TEST_CASE("the state is the same for any number of threads") {
    const Bench bench;
    for (const std::string threads : {"1", "2", "3"}) {
        REQUIRE(bench.run("run storm --seconds 0.05 --state " + threads + ".csv --threads " + threads).status == 0);
        CHECK(contents(bench.path / (threads + ".csv")) == contents(bench.path / "1.csv"));
    }
}

TEST_CASE("results are a table for a person, a JSON object and a CSV row for programs") {
    const Bench bench;
    const auto outcome = bench.run("run storm --seconds 0.1 --dt 0.0001 --json r.json --csv r.csv");
    REQUIRE(outcome.status == 0);
    CHECK(outcome.messages.empty());  // no progress bar in a pipe
    for (const std::string part : {"Storm", "50 x 30", "semi-implicit-euler", "float", "0.1000 s", "1000",
                                   "% of the bound", "ms", "real-time factor", " J", " %", " N", "state hash"}) {
        INFO(part << " in " << outcome.output);
        CHECK(has(outcome.output, part));
    }

    const std::string json = contents(bench.path / "r.json");
    CHECK(json.starts_with("{\n  \"scene\": \"Storm\",\n"));
    CHECK(json.ends_with("\"diverged\": false\n}\n"));
    CHECK(has(json, "\"steps\": 1000,"));
    CHECK(has(json, "\"dt_s\": 0.0001,"));
    CHECK(has(json, "\"time_s\": 0.1,"));

    std::istringstream csv(contents(bench.path / "r.csv"));
    std::string header, row, more;
    std::getline(csv, header);
    std::getline(csv, row);
    CHECK(header.starts_with("scene,columns,rows,modelled,method,precision,threads,time_s,steps,dt_s,"));
    CHECK(row.starts_with(
        "Storm,50,30,springs + diagonal springs + spring damping + gravity + bending + air on faces + wind,"
        "semi-implicit-euler,float,1,0.1,1000,0.0001,"));
    CHECK(std::count(header.begin(), header.end(), ',') == std::count(row.begin(), row.end(), ','));
    CHECK_FALSE(std::getline(csv, more));
}

TEST_CASE("a run tells its error, or why it has none, what its step was chosen by and the best step in float") {
    const Bench bench;
    const auto json_of = [&](const std::string& arguments) {
        const auto outcome = bench.run("run " + arguments + " --json r.json");
        INFO(outcome.messages);
        CHECK(outcome.status == 0);
        return std::pair(outcome.output, contents(bench.path / "r.json"));
    };
    const auto number = [](const std::string& json, const std::string& key) {
        const auto at = json.find("\"" + key + "\": ");
        REQUIRE(at != std::string::npos);
        return std::atof(json.c_str() + at + key.size() + 4);
    };
    const auto [table, json] = json_of("report --seconds 1 --set flag.columns=20 --set flag.rows=14");
    CHECK(has(table, "limit: stiffness of the springs)"));
    CHECK(has(table, "mm per simulated second, over the last 0.1000 s"));
    CHECK(has(table, "best step in float"));
    CHECK(has(json, "\"dt_reason\": \"limit: stiffness of the springs\""));
    CHECK(has(json, "\"error_reason\": \"\""));
    CHECK(number(json, "error_m_per_s") > 1e-5);
    CHECK(number(json, "error_m_per_s") < 1e-2);
    CHECK(number(json, "best_float_step_s") > 1e-7);

    // A tolerance of a third of it takes about three times the steps.
    const double asked = number(json, "error_m_per_s") / 3.0;
    const auto [fine_table, fine] = json_of(
        "report --seconds 1 --set flag.columns=20 --set flag.rows=14 --set "
        "time.precision=double --set time.tolerance=" +
        std::to_string(asked));
    CHECK(has(fine_table, " mm/s asked)"));
    CHECK_FALSE(has(fine_table, "best step in float"));
    CHECK(has(fine, "\"best_float_step_s\": null"));
    CHECK(number(fine, "dt_s") < 0.75 * number(json, "dt_s"));
    CHECK(number(fine, "error_m_per_s") < 2.0 * asked);  // one window of a flag that is not the same at any time

    const auto [given_table, given] = json_of("spring --seconds 0.05 --dt 0.001");
    CHECK(has(given, "\"dt_reason\": \"given\""));
    CHECK(has(given_table, "over the last 0.05000 s"));
    const auto [none_table, none] = json_of("spring --seconds 0 --dt 0.001");
    CHECK(has(none_table, "not resolvable: the run is shorter"));
    CHECK(has(none, "\"error_m_per_s\": null"));
    CHECK(has(none, "\"error_reason\": \"the run is shorter"));

    check_refused(bench.run("run report --seconds 0.51 --set time.tolerance=0.001"),
                  "a whole number of sixtieths of a second is allowed, such as 0.516666666667");
    check_refused(bench.run("run report --seconds 1 --dt 0.0001 --set time.tolerance=0.001"),
                  "goes with time.dt = \"auto\" only");
}

TEST_CASE("results hold whatever a scene is called") {
    const Bench bench;
    const std::string name = "A \"flag\", of 2 m; \\ \xc3\xa9";
    bench.write("named.toml", sheet);
    REQUIRE(bench.run("run named.toml --seconds 0 --json r.json --csv r.csv --set 'name=" + name + "'").status == 0);
    const std::string json = contents(bench.path / "r.json");
    CHECK(has(json, "\"scene\": \"A \\\"flag\\\", of 2 m; \\\\ \xc3\xa9\""));
    CHECK(has(json, "\"real_time_factor\": null"));
    const std::string csv = contents(bench.path / "r.csv");
    const std::string row = csv.substr(csv.find('\n') + 1);
    CHECK(row.starts_with("\"A \"\"flag\"\", of 2 m; \\ \xc3\xa9\",4,"));
    CHECK(has(csv, ",real_time_factor,"));
}

TEST_CASE("a numeric step is used as given, and the time is a whole number of such steps") {
    const Bench bench;
    // Decimal input: 0.3/0.0001 is not 3000 in binary.
    const auto good = bench.run("run spring --seconds 0.3 --dt 0.0001 --json r.json");
    CHECK(good.status == 0);
    CHECK(has(contents(bench.path / "r.json"), "\"steps\": 3000,"));
    check_refused(bench.run("run spring --seconds 1 --dt 0.0003"),
                  "--seconds = 1: a whole number of steps of 0.0003 s is allowed, such as 0.9999");
    check_refused(bench.run("run spring --seconds 1 --dt 0.0003"), "1.0002");
}

TEST_CASE("with dt auto any time is filled with equal steps within the stability limit") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    for (const std::string seconds : {"0.5", "0.123", "0.0001"}) {
        const auto outcome = bench.run("run sheet.toml --dt auto --state s.csv --csv r.csv --seconds " + seconds);
        REQUIRE(outcome.status == 0);
        std::istringstream csv(contents(bench.path / "r.csv"));
        std::string header, line, key, cell;
        std::getline(csv, header);
        std::getline(csv, line);
        std::istringstream keys(header), row(line);
        std::map<std::string, double> cells;
        while (std::getline(keys, key, ',') && std::getline(row, cell, ',')) cells[key] = std::atof(cell.c_str());
        const double time = cells.at("time_s"), steps = cells.at("steps"), dt = cells.at("dt_s"),
                     limit = cells.at("stability_limit_s");
        CHECK(time == Approx(std::atof(seconds.c_str())).epsilon(1e-12));
        CHECK(steps * dt == Approx(time).epsilon(1e-12));
        CHECK(dt <= 0.9 * limit * (1.0 + 1e-12));
    }
}

TEST_CASE("however short a good run is, it is not called diverged") {
    const Bench bench;
    for (const std::string scene : {"spring", "report", "drop"})
        for (const std::string seconds : {"0.001", "0.01", "0.033", "0.05", "0.1", "0.15"}) {
            INFO(scene << " for " << seconds << " s");
            CHECK(bench.run("run " + scene + " --seconds " + seconds).status == 0);
        }
}

TEST_CASE("a run that diverges says which limit it broke, which step is safe, and writes no state") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    const auto outcome = bench.run("run sheet.toml --seconds 100 --dt 0.02 --state s.csv --json r.json");
    INFO(outcome.messages);
    CHECK(outcome.status == 3);
    CHECK(has(outcome.messages, "up to which semi-implicit-euler is stable"));
    CHECK(has(outcome.messages, "holds"));
    CHECK(std::count(outcome.messages.begin(), outcome.messages.end(), '\n') == 1);
    CHECK(bench.files() == std::vector<std::string>{"r.json", "sheet.toml"});
    CHECK(has(contents(bench.path / "r.json"), "\"diverged\": true"));
    // A step a million times too large.
    CHECK(bench.run("run storm --seconds 1000 --dt 100").status == 3);
}

TEST_CASE("a bad command line is refused in one line") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    bench.write("broken.toml", "[flag]\ncolumns = 0\n[springs]\nmass = 1\nstiffness = 1\n");
    check_refused(bench.run(""), "a command is missing");
    check_refused(bench.run("fly"), "fly is no command");
    check_refused(bench.run("--fly"), "--fly is no command");
    check_refused(bench.run("run"), "SCENE");
    check_refused(bench.run("run storm"), "--seconds");
    check_refused(bench.run("run storm --seconds"), "--seconds");
    check_refused(bench.run("run storm --seconds 1 --speed 3"), "--speed");
    check_refused(bench.run("run storm calm --seconds 1"), "calm");
    check_refused(bench.run("run storm --seconds 1 --seconds 2"), "--seconds is given more than once");
    check_refused(bench.run("run no-such --seconds 1"), "no-such: no such file or shipped scene");
    check_refused(bench.run("run \"$(printf 'a\\nb')\" --seconds 1"), "a\\nb: no such file");
    check_refused(bench.run("run . --seconds 1"), "folder");
    check_refused(bench.run("run /dev/zero --seconds 1"), "1.0 MiB");
    check_refused(bench.run("run broken.toml --seconds 1"),
                  "broken.toml:2: flag.columns = 0: a whole number from 1 to 4096 is allowed");
    for (const std::string seconds : {"-1", "nan", "inf", "1e300", "abc", "1s", "1e-30"}) {
        check_refused(bench.run("run storm --seconds " + seconds), "--seconds = ");
    }
    for (const std::string dt : {"-1", "0", "nan", "inf", "1e+300"}) {
        check_refused(bench.run("run storm --seconds 1 --dt " + dt), "--dt = " + dt);
    }
    check_refused(bench.run("run storm --seconds 1 --dt fast"), "--dt = \"fast\": \"auto\" or a number");
    for (const std::string threads : {"0", "-2", "1.5", "many", "1e9"}) {
        check_refused(bench.run("run storm --seconds 1 --threads " + threads),
                      "--threads: " + threads + ": a whole number from 1 to 256 is allowed");
    }
    check_refused(bench.run("run storm --seconds 1 --method rk5"), "--method = \"rk5\": \"forward-euler\"");
    // An automatic step of 10^-15 s, or 10^12 steps, are more than anybody waits for: said before they begin, with the
    // estimate.
    std::string light = sheet;
    light.replace(light.find("mass = 0.01"), 11, "mass = 1e-9\ndrag = 1e6");
    bench.write("light.toml", light);
    check_refused(bench.run("run light.toml --seconds 1"), "1 ns is the least");
    const std::string long_run = "run light.toml --seconds 1000 --dt 1e-9 --method leapfrog --precision double";
    check_refused(bench.run(long_run), "--seconds = 1000: about");
    check_refused(bench.run(long_run), "--force");
    // What a stretch limit needs is known only on the way: the run ends after a few seconds.
    bench.write("limited.toml",
                "[flag]\ncolumns = 120\nrows = 80\nwidth = 1.5\nheight = 1\n[springs]\nmass = 0.001\nstiffness = 2\n"
                "damping = 0.001\n[gravity]\n[limit]\nstretch = 0.001\n");
    check_refused(bench.run("run limited.toml --seconds 1e5"), "--force");
    check_refused(bench.run("run storm --seconds 1 --precision half"), "\"float\" or \"double\"");
    // No drag: explicit Euler has no stable step.
    check_refused(bench.run("run sheet.toml --seconds 1 --method forward-euler"), "auto");
}

TEST_CASE("an output that cannot be written is found before anything is computed") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    // These would take days.
    const std::string long_run = "run storm --seconds 100000 --dt 0.0001 ";
    for (const std::string option : {"--state", "--json", "--csv"}) {
        check_refused(bench.run(long_run + option + " no/such/folder/file"), "no/such/folder/file: cannot be written");
        check_refused(bench.run(long_run + option + " ."), "folder");
    }
    check_refused(bench.run(long_run + "--state /proc/none"), "/proc/none");
    check_refused(bench.run(long_run + "--state a --json a"), "--json = a: the same file as --state");
    check_refused(bench.run("run sheet.toml --seconds 100000 --dt 0.0001 --state ./sheet.toml"),
                  "the same file as the scene");
    CHECK(contents(bench.path / "sheet.toml") == sheet);
    CHECK(bench.files() == std::vector<std::string>{"sheet.toml"});
}

TEST_CASE("a full disk is an error") {
    const Bench bench;
    check_refused(bench.run("run spring --seconds 0.1 --state /dev/full"),
                  "/dev/full: cannot be written: No space left");
    check_refused(bench.run("run spring --seconds 0.1 --json /dev/full"), "/dev/full");
    check_refused(bench.run("run spring --seconds 0.1 >/dev/full"), "No space left");
}

TEST_CASE("a file asked for on standard output is alone there") {
    const Bench bench;
    const auto outcome = bench.run("run spring --seconds 0.1 --state /dev/stdout");
    CHECK(outcome.status == 0);
    CHECK(outcome.output.starts_with("column,row,x,y,z,vx,vy,vz\n0,0,"));
    CHECK_FALSE(has(outcome.output, "state hash"));
    CHECK(has(outcome.messages, "state hash"));
}

TEST_CASE("what standard output already holds stays when a file is asked for there") {
    const Bench bench;
    for (int time = 0; time < 2; ++time) {
        REQUIRE(bench.run("run spring --seconds 0.1 --state /dev/stdout >>out.csv").status == 0);
    }
    const std::string once = bench.run("run spring --seconds 0.1 --state /dev/stdout").output;
    CHECK(contents(bench.path / "out.csv") == once + once);
}

TEST_CASE("a file is replaced whole, through its links, or left as it was") {
    const Bench bench;
    bench.write("old.csv", "what was there before");
    fs::create_symlink("old.csv", bench.path / "link.csv");
    check_refused(bench.run("run spring --seconds 1 --dt 0.3 --state link.csv"), "--seconds");
    CHECK(contents(bench.path / "old.csv") == "what was there before");
    REQUIRE(bench.run("run spring --seconds 0.1 --state link.csv").status == 0);
    CHECK(fs::is_symlink(bench.path / "link.csv"));
    CHECK(state_in(bench.path / "old.csv").size() == 2);
    CHECK(bench.files() == std::vector<std::string>{"link.csv", "old.csv"});
}

TEST_CASE("an interrupted run leaves no file behind") {
    const Bench bench;
    bench.write("old.csv", "what was there before");
    // Ctrl-C after half a second, of a run that would take hours.
    const auto outcome = bench.run("run storm --seconds 100000 --dt 0.0001 --state old.csv --json new.json",
                                   "timeout --preserve-status --signal=INT 0.5 ");
    CHECK(outcome.status == 128 + SIGINT);
    CHECK(contents(bench.path / "old.csv") == "what was there before");
    CHECK(bench.files() == std::vector<std::string>{"old.csv"});
}

TEST_CASE("help, version and the list of scenes are for standard output and succeed") {
    const Bench bench;
    for (const std::string arguments : {"--help", "run --help", "--version", "scenes", "settings"}) {
        const auto outcome = bench.run(arguments);
        INFO(arguments << outcome.messages);
        CHECK(outcome.status == 0);
        CHECK(outcome.messages.empty());
        CHECK_FALSE(outcome.output.empty());
    }
    CHECK(has(bench.run("run --help").output, "whole number of such steps"));
    for (const std::string arguments : {"--help", "run --help"}) {
        const std::string help = bench.run(arguments).output;
        CHECK(has(help, "Exit status: 0 good, "));
        CHECK(has(help, "2 bad input, 3 diverged."));
        CHECK(has(help, "Example: drapeau-lab run storm --seconds 10"));
    }
    CHECK(bench.run("scenes").output.starts_with("report\nbanner\nbreeze\ncalm\n"));
}

TEST_CASE("an option given an empty value is refused, not taken for absent") {
    const Bench bench;
    for (const std::string option : {"--method", "--dt", "--precision", "--threads", "--state", "--json", "--csv"}) {
        INFO(option);
        check_refused(bench.run("run spring --seconds 0.1 " + option + " ''"), option + ": an empty value");
        check_refused(bench.run("run spring --seconds 0.1 " + option + "="), option + ": an empty value");
        check_refused(bench.run("run spring " + option + "= --seconds 0.1"), option + ": an empty value");
    }
    check_refused(bench.run("run spring --seconds ''"), "--seconds: an empty value");
    check_refused(bench.run("run '' --seconds 0.1"), "SCENE: an empty value");
    CHECK(bench.files().empty());
}

TEST_CASE("a message is one visible line, whatever the names in it hold") {
    const Bench bench;
    for (const std::string name : {"a\\033[2Jb", "a\\nb", "a\\tb", "a\\377b", "a\\302\\233b"}) {
        for (const std::string arguments :
             {"run \"$(printf 'NAME')\" --seconds 1", "\"$(printf 'NAME')\"",
              "run spring --seconds \"$(printf 'NAME')\"", "run spring --seconds 1 --method \"$(printf 'NAME')\"",
              "run spring --seconds 1 --\"$(printf 'NAME')\"",
              "run spring --seconds 1 --state \"none/$(printf 'NAME')\""}) {
            std::string line = arguments;
            line.replace(line.find("NAME"), 4, name);
            const auto outcome = bench.run(line);
            check_refused(outcome, "");
            CHECK(has(outcome.messages, "\\"));
            CHECK(std::all_of(outcome.messages.begin(), outcome.messages.end() - 1,
                              [](char c) { return c >= ' ' && c <= '~'; }));
        }
    }
}

TEST_CASE("whatever is for standard output fails where it cannot be written") {
    const Bench bench;
    for (const std::string arguments : {"--help", "run --help", "--version", "scenes", "run spring --seconds 0.1"}) {
        check_refused(bench.run(arguments + " >/dev/full"), "standard output cannot be written: No space left");
        check_refused(bench.run(arguments + " >&-"), "standard output cannot be written: Bad file descriptor");
    }
}

TEST_CASE("a file whose name begins with a dash can be given, and the message says how") {
    const Bench bench;
    bench.write("-dash.toml", sheet);
    bench.write("--long.toml", sheet);
    for (const std::string name : {"-dash.toml", "--long.toml"}) {
        INFO(name);
        CHECK(bench.run("run ./" + name + " --seconds 0.1").status == 0);
        CHECK(bench.run("run --seconds 0.1 -- " + name).status == 0);
        check_refused(bench.run("run " + name + " --seconds 0.1"),
                      name + " begins with a dash: a file of that name is given as ./" + name + " or after --");
    }
    CHECK(bench.run("run spring --seconds 0.1 --state -s.csv").status == 0);
    check_refused(bench.run("run spring --seconds 0.1 -- --speed"), "--speed");
    check_refused(bench.run("run spring --seconds 0.1 --speed"), "--speed");
}

TEST_CASE("a scene that cannot be read is refused with the reason") {
    const Bench bench;
    fs::create_symlink("loop.toml", bench.path / "loop.toml");
    check_refused(bench.run("run loop.toml --seconds 1"), "loop.toml: Too many levels of symbolic links");
    bench.write("latin1.toml",
                "# a scene\nname = \"Drapeau fran\xE7"
                "ais\"\n" +
                    sheet);
    check_refused(bench.run("run latin1.toml --seconds 1"),
                  "latin1.toml: not UTF-8, line 2: byte 0xE7, probably Latin-1; save it as UTF-8");
    std::string wide = "\xFF\xFE";
    for (const char c : sheet) wide.append({c, '\0'});
    bench.write("wide.toml", wide);
    check_refused(bench.run("run wide.toml --seconds 1"), "wide.toml: UTF-16, not UTF-8");
    bench.write("wide.toml", wide.substr(2));
    check_refused(bench.run("run wide.toml --seconds 1"), "wide.toml: UTF-16, not UTF-8");
}

TEST_CASE("outputs of one name are found through links, made or not") {
    const Bench bench;
    bench.write("sheet.toml", sheet);
    fs::create_symlink("sheet.toml", bench.path / "link.toml");
    fs::create_symlink("new.csv", bench.path / "link.csv");
    check_refused(bench.run("run sheet.toml --seconds 0.1 --state link.toml"), "the same file as the scene");
    check_refused(bench.run("run sheet.toml --seconds 0.1 --state link.csv --csv new.csv"),
                  "--csv = new.csv: the same file as --state");
    check_refused(bench.run("run sheet.toml --seconds 0.1 --state new.csv --csv ./link.csv"),
                  "the same file as --state");
    CHECK(bench.run("run sheet.toml --seconds 0.1 --state /dev/null --csv /dev/null").status == 0);
}

TEST_CASE("paths mean what they seem to mean, for scenes and for outputs") {
    const Bench bench;
    bench.write("t1.toml", sheet);
    const std::string at_home = "env HOME='" + bench.path.string() + "' ";
    for (const std::string scene :
         {"t1", "'~/t1.toml'", "'~/t1'", "\"'t1.toml'\"", "'t1.toml '", "file://\"$PWD\"/t1%2etoml"}) {
        const auto outcome = bench.run("run " + scene + " --seconds 0.1 --json '~/r.json' --state ' s.csv '", at_home);
        INFO(scene << outcome.messages);
        CHECK(outcome.status == 0);
        CHECK(bench.files() == std::vector<std::string>{"r.json", "s.csv", "t1.toml"});
    }
    fs::create_directory(bench.path / "storm");
    CHECK(bench.run("run storm --seconds 0.01").status == 0);
}

TEST_CASE("what float cannot honour is computed in double or refused, and that is said") {
    const Bench bench;
    // With "auto" the program chooses, whether the time is a whole number of batches or not.
    for (const std::string seconds : {"0.002", "0.0166666666666666667"}) {
        const auto forward = bench.run(
            "run report --method forward-euler --json r.json --set flag.columns=4 --set flag.rows=3 --seconds " +
            seconds);
        REQUIRE(forward.status == 0);
        CHECK(has(forward.messages, "computed in double: float cannot honour steps of"));
        CHECK(has(contents(bench.path / "r.json"), "\"precision\": \"double\""));
    }
    CHECK(bench.run("run report --seconds 0.1").messages.empty());
    const auto warned = bench.run("run report --seconds 0.0002 --dt 1e-7");
    CHECK(warned.status == 0);
    CHECK(has(warned.messages, "choose double"));
    check_refused(bench.run("run report --seconds 0.00002 --dt 1e-8"), "time.precision = \"double\"");
    CHECK(bench.run("run report --seconds 0.00002 --dt 1e-8 --precision double").status == 0);
    // A step that nobody wrote is not what a message blames.
    bench.write("stiff.toml",
                "[flag]\n[springs]\nmass = 1e-4\nstiffness = 1e7\ndrag = 6e-4\n[time]\n"
                "method = \"forward-euler\"\n");
    const auto stiff = bench.run("run stiff.toml --seconds 0.01");
    CHECK(stiff.status == 2);
    CHECK(has(stiff.messages, "time.dt = \"auto\": forward-euler needs steps of"));
}

TEST_CASE("how long a hanging start took is said where it took long, and how far from rest it is") {
    const Bench bench;
    const std::string slow =
        "[flag]\ncolumns = 200\nrows = 200\nattach = \"grommets\"\nstart = \"hanging\"\n"
        "[springs]\nmass = 1e-5\nstiffness = 1000.0\ndiagonal_stiffness = 500.0\n[gravity]\n";
    bench.write("slow.toml", slow);
    const Outcome outcome = bench.run("run slow.toml --seconds 0");
    CHECK(outcome.status == 0);
    CHECK(has(outcome.messages, "flag.start = \"hanging\": it took "));
    CHECK(has(outcome.messages, "the flag had not come to rest when it started"));
    const std::string small = " --set flag.columns=8 --set flag.rows=6 --set gravity=off";
    CHECK(bench.run("run slow.toml --seconds 0" + small).messages.empty());
}

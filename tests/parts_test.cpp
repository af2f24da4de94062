// Laws of sweeps in parts: whatever ends a sweep, it goes on to the same result; shards together are the whole; what
// does not belong together is refused, and what is missing is named.
#include "lab_bench.hpp"
#include "sanitized.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

using namespace drapeau::testing;

namespace {

using Json = nlohmann::ordered_json;

const std::string trade = "trade spring --settle 0 --precisions double --methods leapfrog,rk4,semi-implicit-euler ";
const std::string stability = "stability spring --methods leapfrog,rk4,xpbd --stiffness 0.5,500 --damping 0,0.1 ";

const std::string price = "price spring --settle 0 --budget 0.05 ";  // most of it would go into times
const std::string converge =
    "converge drum --set flag.columns=4 --set flag.rows=4 --methods leapfrog,rk4 --levels 3 --seconds 0.05 ";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t from = 0, end; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
        lines.push_back(text.substr(from, end - from));
    return lines;
}

/// What a part holds of results, without what they cost, in any order: a line for each.
std::vector<std::string> results(const Bench& bench, const std::vector<std::string>& parts) {
    std::vector<std::string> all;
    for (const std::string& part : parts) {
        const auto lines = lines_of(contents(bench.path / part));
        REQUIRE_FALSE(lines.empty());
        for (std::size_t n = 1; n < lines.size(); ++n) {
            Json record = Json::parse(lines[n]);
            record.erase("cost");
            if (record.contains("basis") || record.contains("result")) all.push_back(record.dump());
        }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void check_done(const Outcome& outcome) {
    INFO(outcome.messages << outcome.output);
    REQUIRE(outcome.status == 0);
}

/// The JSON of a command without what follows from times.
Json without_times(const Bench& bench, const std::string& file) {
    Json json = Json::parse(contents(bench.path / file));
    if (json.contains("points"))
        for (Json& point : json["points"]) point.erase("ms_per_second");
    json.erase("front");
    json.erase("ms_per_second");
    if (json.contains("terms"))
        for (Json& part : json["terms"])
            for (const char* cost :
                 {"cost_percent", "cost_known_to_percent", "cost_same_step_percent", "cost_same_step_known_to_percent"})
                REQUIRE(part.erase(cost) == 1);
    return json;
}

}  // namespace

TEST_CASE("shards together are the whole sweep, bit for bit in everything but times") {
    const Bench bench;
    check_done(bench.run(trade + "--part whole.jsonl --json whole.json"));
    std::string parts;
    for (const std::string n : {"1", "2", "3"}) {
        const Outcome shard = bench.run(trade + "--shard " + n + "/3 --part " + n + ".jsonl");
        check_done(shard);
        CHECK(has(shard.output, "shard " + n + "/3 is done: "));
        parts += n + ".jsonl ";
    }
    CHECK(results(bench, {"1.jsonl", "2.jsonl", "3.jsonl"}) == results(bench, {"whole.jsonl"}));
    // Dealt evenly, none twice.
    const std::size_t all = results(bench, {"whole.jsonl"}).size() - 1;
    for (const std::string n : {"1", "2", "3"}) CHECK(results(bench, {n + ".jsonl"}).size() - 1 <= (all + 2) / 3);
    const Outcome merged = bench.run("merge " + parts + "--json merged.json");
    check_done(merged);
    CHECK(has(merged.output, "the efficient front"));
    CHECK(without_times(bench, "merged.json") == without_times(bench, "whole.json"));
    CHECK(bench.run("merge whole.jsonl --json again.json").status == 0);
    CHECK(contents(bench.path / "again.json") == contents(bench.path / "whole.json"));
}

TEST_CASE("the parts of a scene priced in shards are the whole, bit for bit in everything but times") {
    const Bench bench;
    bench.write(
        "sheet.toml",
        "[flag]\ncolumns = 7\nrows = 5\nwidth = 0.6\nheight = 0.4\nattach = \"hoist\"\n[springs]\nmass = 0.001\n"
        "stiffness = 50\ndiagonal_stiffness = 25\ndamping = 0.002\ndrag = 0.002\n[gravity]\n[time]\n"
        "precision = \"double\"\ntolerance = 0.01\n");
    const std::string sheet = "price sheet.toml --settle 0.1 --seconds 0.1 --budget 0.3 ";
    check_done(bench.run(sheet + "--part whole --json whole.json"));
    for (const std::string n : {"1", "2", "3"}) {
        const Outcome shard = bench.run(sheet + "--shard " + n + "/3 --part " + n);
        check_done(shard);
        CHECK(has(shard.output, "shard " + n + "/3 is done: "));
    }
    CHECK(results(bench, {"1", "2", "3"}) == results(bench, {"whole"}));
    check_done(bench.run("merge 3 1 2 --json merged.json"));
    const Json whole = without_times(bench, "whole.json");
    CHECK(whole["terms"].size() == 7);
    CHECK(without_times(bench, "merged.json") == whole);
    // Every shard times the scene as given beside its parts.
    for (const std::string n : {"1", "2", "3"})
        for (const std::string& line : lines_of(contents(bench.path / n)))
            if (const Json record = Json::parse(line); record.contains("cost"))
                CHECK(record["cost"]["scene_ms_per_second"] > 0.0);
    check_done(bench.run("merge whole --json again.json"));
    CHECK(contents(bench.path / "again.json") == contents(bench.path / "whole.json"));
    // At once the same effects are found, for the budget suffices.
    check_done(bench.run(sheet + "--json once.json"));
    CHECK(without_times(bench, "once.json")["terms"] == whole["terms"]);
}

TEST_CASE("of a scene priced in shards merge leaves out what the whole tolerance allows") {
    const Bench bench;
    bench.write("fall.toml",
                "[flag]\ncolumns = 9\nrows = 9\nwidth = 0.8\nheight = 0.8\nattach = \"none\"\ndisturbance = 0\n"
                "[springs]\nmass = 0.001\nstiffness = 50\ndiagonal_stiffness = 25\n[gravity]\n");
    const std::string fall = "price fall.toml --settle 0.1 --seconds 0.1 --budget 0.3 --tolerance 1um ";
    for (const std::string n : {"1", "2"}) check_done(bench.run(fall + "--shard " + n + "/2 --part " + n));
    check_done(bench.run("merge 1 2 --json merged.json --write less.toml"));
    const Json reduced = Json::parse(contents(bench.path / "merged.json"))["reduced"];
    CHECK(reduced["holds"] == true);
    CHECK(reduced["check"]["effect_rms_m"] <= 1e-6);
    CHECK(has(contents(bench.path / "less.toml"), "left out: "));
}

TEST_CASE("methods and grids measured in shards are the whole, bit for bit") {
    const Bench bench;
    check_done(bench.run(converge + "--part whole --json whole.json"));
    for (const std::string n : {"1", "2", "3"}) check_done(bench.run(converge + "--shard " + n + "/3 --part " + n));
    CHECK(results(bench, {"1", "2", "3"}) == results(bench, {"whole"}));
    check_done(bench.run("merge 2 3 1 --json merged.json"));
    CHECK(contents(bench.path / "merged.json") == contents(bench.path / "whole.json"));
    // Where the budget suffices, all at once finds the same.
    check_done(bench.run(converge + "--json once.json"));
    CHECK(contents(bench.path / "once.json") == contents(bench.path / "whole.json"));
}

TEST_CASE("light borders are flown in shards where they may tell why an order is low") {
    const Bench bench;
    bench.write("chain.toml",
                "[flag]\ncolumns = 1\nrows = 5\nheight = 0.5\nattach = \"top\"\n[springs]\nmass = 0.025\n"
                "stiffness = 40\ndrag = 0.75\n[gravity]\n");
    const std::string chain = "converge chain.toml --settle 1 --seconds 0.05 --methods leapfrog ";
    check_done(bench.run(chain + "--json once.json"));
    for (const std::string n : {"1", "2"}) check_done(bench.run(chain + "--shard " + n + "/2 --part " + n));
    check_done(bench.run("merge 1 2 --json merged.json"));
    const Json merged = Json::parse(contents(bench.path / "merged.json"));
    CHECK(merged["grids_verdict"] == "converges, borders lower the order");
    CHECK(merged["light_borders"] == Json::parse(contents(bench.path / "once.json"))["light_borders"]);
}

TEST_CASE("what is measured in parts does not depend on how busy the machine is") {
    // The budget ends the search for a reference, and leaves points out.
    const std::string report = " report --set flag.columns=6 --set flag.rows=5 --settle 0 --seconds 0.2 --part part ";
    for (const std::string& hard : {"trade" + report + "--budget 0.02 --precisions double",
                                    "price" + report + "--budget 0.05 --tolerance 0.1nm --shard 1/2",
                                    "converge" + report + "--budget 0.04 --methods leapfrog,rk4,xpbd"}) {
        INFO(hard);
        const Bench alone;
        check_done(alone.run(hard));
        const auto measured = results(alone, {"part"});
        const auto is_left_out = [](const std::string& line) {
            return has(line, "\"left out\"") || has(line, "\"held\":false");
        };
        CHECK((hard.starts_with("price") || std::any_of(measured.begin(), measured.end(), is_left_out)));

        const std::vector<Bench> crowd(sanitized ? 2 : std::thread::hardware_concurrency() + 1);
        std::vector<Outcome> outcomes(crowd.size());
        std::vector<std::thread> threads;
        for (std::size_t n = 0; n < crowd.size(); ++n)
            threads.emplace_back([&, n] { outcomes[n] = crowd[n].run(hard); });
        for (std::thread& thread : threads) thread.join();
        for (std::size_t n = 0; n < crowd.size(); ++n) {
            check_done(outcomes[n]);
            CHECK(results(crowd[n], {"part"}) == measured);
        }
    }
}

TEST_CASE("a stability map in shards is the whole one") {
    const Bench bench;
    check_done(bench.run(stability + "--json whole.json"));
    for (const std::string n : {"1", "2"}) check_done(bench.run(stability + "--part " + n + " --shard " + n + "/2"));
    check_done(bench.run("merge 2 1 --json merged.json"));
    CHECK(contents(bench.path / "merged.json") == contents(bench.path / "whole.json"));
}

TEST_CASE("a sweep killed at any moment goes on to the same result") {
    const Bench bench;
    for (const std::string& sweep : {trade, price, converge}) {
        fs::remove(bench.path / "whole");
        check_done(bench.run(sweep + "--part whole"));
        const auto whole = results(bench, {"whole"});
        int killed = 0;
        for (const std::string seconds : {"0.01", "0.05", "0.1", "0.15", "0.2", "0.3", "0.4"}) {
            INFO(sweep << " killed after " << seconds << " s");
            fs::remove(bench.path / "part");
            const Outcome outcome = bench.run(sweep + "--part part", "timeout -s KILL " + seconds + " ");
            killed += outcome.status != 0;
            const std::string kept = fs::exists(bench.path / "part") ? contents(bench.path / "part") : "";
            check_done(bench.run(sweep + "--part part --resume"));
            CHECK(contents(bench.path / "part").starts_with(kept.substr(0, kept.rfind('\n') + 1)));
            CHECK(results(bench, {"part"}) == whole);
            check_done(bench.run("merge part"));
        }
        CHECK(killed > 0);
    }
}

TEST_CASE("a part cut off behind any of its lines goes on to the same result") {
    const Bench bench;
    for (const std::string& sweep : {price, converge}) {
        fs::remove(bench.path / "whole");
        check_done(bench.run(sweep + "--part whole"));
        const std::string text = contents(bench.path / "whole");
        for (std::size_t end = text.find('\n') + 1; end < text.size(); end = text.find('\n', end) + 1) {
            INFO(sweep << " cut off after " << end << " bytes");
            bench.write("part", text.substr(0, end));
            check_done(bench.run(sweep + "--part part --resume"));
            CHECK(results(bench, {"part"}) == results(bench, {"whole"}));
            check_done(bench.run("merge part"));
        }
    }
}

TEST_CASE("a part cut off after any byte goes on to the same result, and merge does not count a torn line") {
    const Bench bench;
    check_done(bench.run(trade + "--part whole"));
    const std::string text = contents(bench.path / "whole");
    const auto whole = results(bench, {"whole"});
    const std::size_t header = text.find('\n') + 1, basis = text.find('\n', header) + 1;
    const std::size_t point = text.find('\n', basis) + 1;
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, header - 1, header, header + 10, basis, basis + 1,
                                    point - 1, point, text.size() - 1}) {
        INFO("cut off after " << bytes << " bytes");
        bench.write("part", text.substr(0, bytes));
        if (bytes >= header && bytes <= point) {
            const Outcome merged = bench.run("merge part");
            CHECK(merged.status == 1);
            CHECK(has(merged.messages, bytes < point ? "13 of 13 points are missing" : "12 of 13 points are missing"));
        }
        check_done(bench.run(trade + "--part part --resume"));
        CHECK(results(bench, {"part"}) == whole);
    }
}

TEST_CASE("an interrupted sweep says how to go on, and ends by the signal") {
    const Bench bench;
    for (const auto& [name, number] : {std::pair<std::string, int>{"INT", SIGINT}, {"TERM", SIGTERM}}) {
        const Outcome outcome = bench.run("trade report --budget 60 --part part" + name,
                                          "timeout --preserve-status --signal=" + name + " 1 ");
        CHECK(outcome.status == 128 + number);
        CHECK(has(outcome.messages, "drapeau-lab: interrupted; what is done is in part" + name +
                                        ", and the same command with --resume goes on\n"));
    }
}

TEST_CASE("merge names what is missing, and how to make it") {
    const Bench bench;
    for (const std::string n : {"1", "3"}) check_done(bench.run(trade + "--part " + n + " --shard " + n + "/3"));
    const Outcome outcome = bench.run("merge 1 3 --json j");
    CHECK(outcome.status == 1);
    CHECK(outcome.output.empty());
    CHECK(has(outcome.messages, "4 of 13 points are missing"));
    CHECK(has(outcome.messages, "shard 2/3 is not among the parts"));
    CHECK(std::count(outcome.messages.begin(), outcome.messages.end(), '\n') == 1);
    std::string text = contents(bench.path / "3");
    bench.write("3", text.substr(0, text.find("{\"point\"")));
    CHECK(has(bench.run("merge 1 3").messages, "shard 3/3 lacks 4, its command with --resume goes on with 3"));
    CHECK(has(bench.run("merge 3").messages, "13 of 13 points are missing"));
    CHECK(has(bench.run("merge 3").messages, "; shards 1/3 and 2/3 are not among the parts; shard 3/3 lacks 4"));
    CHECK(bench.files() == std::vector<std::string>{"1", "3"});
}

TEST_CASE("parts of different sweeps are refused, and what differs is named") {
    const Bench bench;
    check_done(bench.run(trade + "--part 1 --shard 1/2"));
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        bench.write("2", "");
        check_done(bench.run(arguments + " --part 2 --shard 2/2"));
        check_refused(bench.run("merge 1 2"), "2: of another sweep than 1: " + part);
    };
    refused(trade + "--set springs.stiffness=6", "the scene's setting is stiffness = 5 there and stiffness = 6 here");
    refused(trade + "--seconds 0.25", "--seconds is not given there and 0.25 here");
    refused(trade + "--diagonals", "--diagonals is false there and true here");
    refused(stability, "the command is trade there and stability here");
    refused(price, "the command is trade there and price here");
    refused(converge, "the command is trade there and converge here");
    bench.write("2", "");
    check_done(bench.run(trade + "--part 2 --shard 2/3"));
    check_refused(bench.run("merge 1 2"), "it is shard 2/3, and shard 1/2 there");

    const std::string text = contents(bench.path / "1");
    std::string older = text;
    older.replace(older.find("\"version\":\"") + 11, 1, "9");
    bench.write("old", older);
    check_refused(bench.run("merge 1 old"), "the version of drapeau-lab is");
    check_refused(bench.run("merge old"), "old: a part of version");
    std::string otherwise = text;
    const std::size_t error = otherwise.find("\"at_end_m\":") + 11;
    otherwise[error] = otherwise[error] == '1' ? '2' : '1';
    bench.write("otherwise", otherwise);
    check_refused(bench.run("merge 1 otherwise"), "another result for");
    check_refused(bench.run("merge 1 1 --json 1"), "--json = 1: the same file as a part");
}

TEST_CASE("what no sweep wrote is refused as a part, in one line") {
    const Bench bench;
    check_done(bench.run(trade + "--part good"));
    const std::string good = contents(bench.path / "good");
    const std::size_t header = good.find('\n') + 1;
    const auto refused = [&](const std::string& text, const std::string& part) {
        bench.write("bad", text);
        INFO(text.substr(0, 100));
        check_refused(bench.run("merge bad"), part);
    };
    refused("", "bad: empty");
    refused("garbage\n", "bad: no part of a sweep");
    refused(std::string(5000, '\0'), "bad: no part of a sweep");
    refused("[1, 2]\n", "bad: no part of a sweep");
    refused("{\"drapeau-lab part\":2}\n", "bad: a part in another form");
    refused("{\"drapeau-lab part\":1}\n", "bad: line 1: it does not say which sweep");
    refused(good.substr(0, header) + "garbage\n", "bad: line 2: no record of a sweep");
    refused(good.substr(0, header) + "{\"point\":3}\n", "bad: line 2: no record of a sweep");
    refused(good.substr(0, header) + "{\"point\":\"x\",\"cost\":{}}\n", "bad: line 2: a cost of a point that is not");
    std::string wrong = good;
    wrong.replace(wrong.find("\"outcome\":\"measured\""), 20, "\"outcome\":\"what ever\"");
    refused(wrong, "no result of this sweep");
    wrong = good;
    wrong.replace(wrong.find("\"batches\":30"), 12, "\"batches\":-3");
    refused(wrong, "what it says points are judged by is nothing of this sweep");
    wrong = good;
    wrong.replace(wrong.find("columns = 1"), 11, "columns = x");
    refused(wrong, "bad, its scene:5: ");
    check_refused(bench.run("merge ."), ".: ");
    check_refused(bench.run("merge no-such"), "no-such: No such file");
    check_refused(bench.run("merge"), "PART is required");
}

TEST_CASE("a cost or an error that no sweep can have written is refused, with its file and line") {
    const Bench bench;
    /// The n-th value (from 0) of that name made another, and the line it stands in.
    const auto changed = [&](const std::string& name, const std::string& value, int n) {
        std::string text = contents(bench.path / "good");
        std::size_t at = text.find("\"" + name + "\":");
        for (; n > 0; --n) at = text.find("\"" + name + "\":", at + 1);
        REQUIRE(at != std::string::npos);
        at += name.size() + 3;
        const std::size_t end = text.find_first_of(",}]", at);
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
        bench.write("bad", text.replace(at, end - at, value));
        return "bad: line " + std::to_string(line) + ": ";
    };
    const auto refused = [&](const std::string& name, const std::string& value, int n = 0) {
        INFO(name << " = " << value);
        const std::string line = changed(name, value, n);
        check_refused(bench.run("merge bad"), line);
    };
    const auto make = [&](const std::string& sweep) {
        fs::remove(bench.path / "good");
        check_done(bench.run(sweep + "--part good"));
        check_done(bench.run("merge good"));
    };
    make(trade);
    for (const std::string value : {"-1.0", "null", "1e999", "\"1\""}) {
        refused("at_end_m", value);
        refused("ms_per_second", value);
        refused("ms_per_second", value, 15);  // one that was timed again
        refused("took_s", value);
    }
    refused("rk4_error_m", "-1.0");
    refused("known_to_m", "-1.0");
    make(price);
    for (const std::string value : {"-1.0", "null", "1e999"}) {
        refused("at_end_m", value);
        refused("scene_ms_per_second", value);
        refused("known_to", value, 1);
    }
    refused("share", "null");
    refused("dt_s", "-1.0");
    make(converge);
    for (const std::string value : {"-1.0", "1e999"}) {
        refused("difference_m", value, 1);
        refused("error_m", value);
    }
    refused("flag", "\"good\"");
    make(stability);
    refused("measured_s", "-1.0");
}

TEST_CASE("what options of parts cannot do is refused before work") {
    const Bench bench;
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        check_refused(bench.run("trade report " + arguments), part);
    };
    refused("--shard 1/2", "--shard: give --part too");
    refused("--resume", "--resume: give --part too");
    for (const std::string shard : {"0/2", "3/2", "x", "1", "1/", "/2", "1/0", "-1/2", "1/99999999"})
        refused("--part p --shard=" + shard, "--shard = " + shard + ": I/N");
    refused("--part p --shard 1/2 --json j", "--json: a shard has not all points");
    refused("--part no/such", "no/such: cannot be written");
    refused("--part .", "folder");
    refused("--part /dev/null", "/dev/null: no file, which a part must be");
    refused("--part p --json p", "--part = p: the same file as --json");
    refused("--plot p.pdf", "--plot = p.pdf: .svg or .png is allowed");
    check_refused(bench.run("stability report --plot p"), "--plot = p: .svg or .png is allowed");
    check_refused(bench.run("trade spring --plot p.svg", "PATH=/nowhere "), "--plot needs gnuplot");
    CHECK(bench.files().empty());

    check_done(bench.run(trade + "--part p --shard 1/2"));
    const std::string kept = contents(bench.path / "p");
    check_refused(bench.run(trade + "--part p --shard 1/2"), "p: there already; --resume goes on with it");
    check_refused(bench.run(trade + "--part p --shard 2/2 --resume"), "p: shard 1/2 of this sweep, not 2/2");
    check_refused(bench.run(trade + "--part p --shard 1/2 --resume --seconds 0.25"), "p: of another sweep: --seconds");
    CHECK(contents(bench.path / "p") == kept);
}

TEST_CASE("pictures are drawn of a sweep and of a map, whatever the scene is called") {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0) return;  // ./dev test installs it
    const Bench bench;
    bench.write("odd.toml",
                "name = \"it's `odd` \\\\ $x {a_b}\"\n[flag]\ncolumns = 1\nrows = 2\nattach = \"top\"\n[springs]\n"
                "mass = 0.1\nstiffness = 5\n[gravity]\n");
    check_done(bench.run("trade odd.toml --settle 0 --methods leapfrog,forward-euler --plot t.svg"));
    const std::string svg = contents(bench.path / "t.svg");
    CHECK(has(svg, "<svg"));
    CHECK(has(svg, "it's `odd` \\ $x {a_b}: cost over error"));
    CHECK(has(svg, "leapfrog"));
    check_done(bench.run("stability odd.toml --methods leapfrog,xpbd --plot s.svg"));
    CHECK(has(contents(bench.path / "s.svg"), "xpbd: every step is stable"));
    check_done(bench.run("stability odd.toml --methods xpbd --plot s.png"));
    CHECK(contents(bench.path / "s.png").starts_with("\x89PNG"));
    CHECK(bench.files() == std::vector<std::string>{"odd.toml", "s.png", "s.svg", "t.svg"});
}

// The laboratory's report: one page that needs nothing else, whatever the scene is called, with what could not be
// measured said on it.
#include "catch.hpp"
#include "lab_bench.hpp"

#include <cstdlib>
#include <string>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr const char* on_a_spring =
    "name = \"A <b>&\\\"soft\\\" flag\"\n[flag]\ncolumns = 1\nrows = 2\nheight = 1\nattach = \"corner\"\n"
    "[springs]\nmass = 0.1\nstiffness = 5\n";

}  // namespace

TEST_CASE("a report is one page with four chapters that needs no other file") {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0) return;  // ./dev test installs it
    const Bench bench;
    bench.write("odd.toml", std::string(on_a_spring) + "damping = 0.01\n[gravity]\n");
    const auto outcome = bench.run("report odd.toml -o page.html --budget 0.5");
    INFO(outcome.messages);
    REQUIRE(outcome.status == 0);
    const std::string page = contents(bench.path / "page.html");
    CHECK(has(page, "<h1>A &lt;b&gt;&amp;&quot;soft&quot; flag: what accuracy costs</h1>"));
    CHECK_FALSE(has(page, "<b>"));
    for (const std::string part : {"Speed against accuracy", "The limit of stability", "What each part costs",
                                   "Smaller steps and finer grids", "The scene", "The machine", "stiffness = 5"})
        CHECK(has(page, part));
    // The limit of semi-implicit Euler is 2/omega less what the damper takes (numerics: a + 2b < 4).
    CHECK(has(page, "281 ms for semi-implicit-euler"));
    std::size_t pictures = 0;
    for (auto at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) ++pictures;
    CHECK(pictures == 4);
    for (const std::string outside : {"<script", "<img", "<link", "src=", "@import"}) CHECK_FALSE(has(page, outside));
    CHECK(bench.files() == std::vector<std::string>{"odd.toml", "page.html"});
}

TEST_CASE("what a report cannot measure is said on its page, and nothing at all is no report") {
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0) return;
    const Bench bench;
    bench.write("bare.toml", on_a_spring);  // nothing of it can be left out
    REQUIRE(bench.run("report bare.toml -o page.html --budget 0.5").status == 0);
    CHECK(has(contents(bench.path / "page.html"), "<p class=\"trouble\">"));

    const auto refused = [&](const std::string& arguments, const std::string& why) {
        const auto outcome = bench.run("report " + arguments);
        INFO(arguments << ": " << outcome.messages);
        CHECK(outcome.status == 2);
        CHECK(has(outcome.messages, why));
    };
    refused("bare.toml", "--output: give the page a name");
    refused("bare.toml -o page.pdf", "--output = page.pdf: .html is allowed");
    refused("bare.toml -o none/page.html", "none/page.html: cannot be written");
    refused("bare.toml -o x.html --tolerance 1", "--tolerance = 1: a distance");
    refused("bare.toml -o x.html --budget 0", "--budget = 0");
    refused("missing -o x.html", "missing");
    refused("bare.toml -o bare.html --set flag.attach=all", "every mass is held");
    CHECK(bench.files() == std::vector<std::string>{"bare.toml", "page.html"});
}

// Laws of scene files: what is written is read back, what is wrong is named in one line.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"
#include "scene/material.hpp"
#include "scene/reference.hpp"
#include "scene/settings.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

const std::string springs = "[springs]\nmass = 0.1\nstiffness = 20\n";

/// The message of the InputError that the work causes, "" if it causes none.
std::string message_from(const auto& work) {
    try {
        work();
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}
std::string message_of(const std::string& text) {
    return message_from([&] { parse_scene(text, "storm.toml"); });
}
std::string message_of_file(const fs::path& file) {
    return message_from([&] { read_scene(file); });
}
std::string message_of_scene(const Scene& scene) {
    return message_from([&] { check_scene(scene); });
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find_first_of("\n\r") == std::string::npos;
}

struct Folder : TemporaryFolder {
    fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
};

/// Any valid scene, its numbers of every magnitude allowed.
class AnyScene {
public:
    explicit AnyScene(unsigned seed) : random_(seed) {}

    Scene operator()() {
        Scene scene;
        scene.name = text();
        scene.flag = {.columns = whole(1, 400),
                      .rows = whole(2, 400),
                      .width = positive(1e-3, 1e3),
                      .height = positive(1e-3, 1e3),
                      .attach = static_cast<Attach>(whole(0, 7)),
                      .start = static_cast<Start>(whole(0, 2)),
                      .prestretch = number(-0.9, 10.0),
                      .disturbance = coin() ? std::optional(positive(1e-9, 1.0)) : std::nullopt,
                      .texture = text(),
                      .halyard = coin() ? std::optional(number(0.0, 1.0)) : std::nullopt};
        scene.springs = {.mass = positive(1e-9, 1e3),
                         .stiffness = positive(1e-9, 1e9),
                         .diagonal_stiffness = {},
                         .damping = {},
                         .drag = positive(1e-9, 1e6),
                         .friction = {}};
        if (coin()) scene.springs->diagonal_stiffness = positive(1e-9, 1e9);
        if (scene.flag.columns > 1 && coin()) {
            scene.springs.reset();
            scene.fabric = fabric_of(static_cast<FabricName>(whole(0, 4)));
            if (coin()) scene.fabric->density = positive(1e-6, 1e6);
            if (coin()) scene.fabric->stretch_modulus = positive(1e-9, 1e9);
            if (coin()) scene.fabric->damping_time = coin() ? 0.0 : positive(1e-6, 1e3);
            scene.fabric->drag_per_area = positive(1e-6, 1e6);
            scene.fabric->diagonal_share.reset();  // cells may be of any length
        }
        if (scene.springs && coin()) scene.springs->damping = coin() ? 0.0 : positive(1e-9, 1e6);
        if (scene.springs && coin()) scene.springs->friction = positive(1e-9, 1e6);
        if (coin()) scene.gravity() = Gravity{three(-1e4, 1e4)};
        if (coin())
            scene.terms.add(Air{positive(1e-3, 1e3), coin() ? std::optional(number(0.0, 100.0)) : std::nullopt,
                                coin() ? std::optional(number(0.0, 100.0)) : std::nullopt, coin(),
                                positive(1e-3, 1e3)});
        if (coin()) scene.limits.add(StretchLimit{positive(1e-6, 10.0)});
        if (scene.flag.attach == Attach::none)  // else it must be below the flag
            scene.limits.add(Ground{number(-1e3, 1e3), positive(1e-6, 100.0)});
        if (coin()) scene.limits.add(Pole{positive(1e-3, 10.0), positive(1e-6, 100.0)});
        if (coin()) {
            scene.wind() = Wind{three(-1e6, 1e6), three(0.0, 1e6), positive(1e-3, 1e6), coin(), random_() >> 1};
        } else if (coin()) {
            scene.drag().reset();
        }
        scene.time.method = static_cast<Method>(whole(0, static_cast<int>(method_count) - 1));
        scene.time.precision = static_cast<Precision>(whole(0, 1));
        if (coin())
            scene.time.dt = positive(1e-9, 1e3);
        else if (coin())
            scene.time.tolerance = positive(1e-9, 1e3);
        scene.view = {coin(), coin(), coin(), coin(), coin(), coin()};
        return scene;
    }

private:
    std::mt19937_64 random_;

    bool coin() { return random_() % 2 == 0; }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    double number(double low, double high) {
        const double value = std::uniform_real_distribution<double>(low, high)(random_);
        return coin() ? value : std::max(low, std::round(value));
    }
    double positive(double low, double high) { return std::exp(number_between(std::log(low), std::log(high))); }
    double number_between(double low, double high) {
        // A hair inside, so that exp(log()) stays in the range.
        return std::uniform_real_distribution<double>(low + 1e-9, high - 1e-9)(random_);
    }
    glm::dvec3 three(double low, double high) { return {number(low, high), number(low, high), number(low, high)}; }
    std::string text() {
        const std::vector<std::string> pieces{"a", " ", "\"", "\\", "#", "é", "旗", "=", "[", "'", ".png", "/", "0"};
        std::string result;
        for (int n = whole(0, 12); n > 0; --n) result += pieces[static_cast<std::size_t>(whole(0, 12))];
        return result;
    }
};

struct CommaForDecimals : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST_CASE("a scene that is written is read back the same") {
    AnyScene any(1);
    for (int n = 0; n < 2000; ++n) {
        const Scene scene = any();
        const std::string text = write_scene(scene);
        INFO(text);
        REQUIRE(parse_scene(text, "written") == scene);
    }
}

TEST_CASE("scene files do not depend on the locale") {
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaForDecimals));
    AnyScene any(2);
    for (int n = 0; n < 100; ++n) {
        const Scene scene = any();
        REQUIRE(parse_scene(write_scene(scene), "written") == scene);
    }
    CHECK(message_of("[flag]\ncolumns = 5000\n" + springs) ==
          "storm.toml:2: flag.columns = 5000: a whole number from 1 to 4096 is allowed");
    std::locale::global(before);
}

TEST_CASE("a written scene comments every key") {
    Scene scene;
    scene.gravity().emplace();
    scene.wind().emplace();
    scene.springs->drag = 0.001;
    std::istringstream lines(write_scene(scene));
    for (std::string line; std::getline(lines, line);) {
        if (has(line, " = ")) CHECK(has(line, "# "));
    }
}

TEST_CASE("what a scene does not list is not modelled, and the rest has its documented value") {
    const Scene scene = parse_scene(springs, "some/where/little.toml");
    CHECK(scene.name == "little");
    CHECK(scene.flag == FlagSettings{});
    CHECK(scene.springs->mass == 0.1);
    CHECK_FALSE(scene.springs->diagonal_stiffness);
    CHECK_FALSE(scene.springs->damping);
    CHECK_FALSE(scene.springs->drag);
    CHECK_FALSE(scene.gravity());
    CHECK_FALSE(scene.wind());
    CHECK_FALSE(scene.limits.get<StretchLimit>());
    CHECK_FALSE(scene.time.dt);
    CHECK(parse_scene(springs + "[gravity]\n", "x").gravity()->acceleration == glm::dvec3(0.0, -9.8, 0.0));
    CHECK(parse_scene(springs + "damping = 0\n", "x").springs->damping == 0.0);
}

TEST_CASE("every key of the format is read") {
    const Scene scene = parse_scene(R"(
        name = "All"
        [flag]
        columns = 3
        rows = 4
        width = 2
        height = 0.5
        attach = "grommets"
        start = "crumpled"
        disturbance = 0.02
        prestretch = 0.1
        texture = "a.png"
        [springs]
        mass = 1e-3
        stiffness = 30
        diagonal_stiffness = 15
        damping = 0.1
        drag = 0.2
        friction = 0.3
        [gravity]
        acceleration = [1, -2.5, 3]
        [air]
        density = 1.1
        pressure = 1.25
        skin = "off"
        [wind]
        velocity = [4, 5, 6]
        gusts = [0.1, 0.2, 0.3]
        period = 7
        travelling = true
        seed = 8
        [limit]
        stretch = 0.05
        [time]
        method = "forward-euler"
        dt = 0.001
        precision = "double"
        [view]
        texture = false
        cut_out = false
        cloth = false
        springs = true
        forces = true
        masses = true
        wind = true
        reference = true
        texture_proportions = true
        background = "studio"
        bare_grid = true
        person = true
        stretch = true
        velocities = true
        colours = "viridis"
        force_range = 2.5
        stretch_range = 0.04
        velocity_range = 8)",
                                    "all.toml");
    Scene expected;
    expected.name = "All";
    expected.flag = {3, 4, 2.0, 0.5, Attach::grommets, Start::crumpled, 0.1, 0.02, "a.png"};
    expected.springs = {1e-3, 30.0, 15.0, 0.1, 0.2, 0.3};
    expected.gravity() = Gravity{{1.0, -2.5, 3.0}};
    expected.terms.add(Air{1.1, 1.25, {}});
    expected.wind() = Wind{{4.0, 5.0, 6.0}, {0.1, 0.2, 0.3}, 7.0, true, 8};
    expected.limits.add(StretchLimit{0.05});
    expected.time = {method_id<ForwardEuler>, 0.001, Precision::double_precision};
    expected.view = {
        false, false, false, true, true, true, true, true, true, Background::studio, true, true, true, Colours::viridis,
        2.5,   0.04,  true,  8.0};
    CHECK(scene == expected);
}

TEST_CASE("an impossible value is named with its file, line, key and what is allowed") {
    CHECK(message_of("[flag]\ncolumns = 0\n" + springs) ==
          "storm.toml:2: flag.columns = 0: a whole number from 1 to 4096 is allowed");
    CHECK(message_of("\n\n\n\n\n[springs]\nmass = -1\nstiffness = 2\n") ==
          "storm.toml:7: springs.mass = -1: a number from 1e-09 to 1000000 is allowed");

    struct Case {
        std::string line, named, allowed;
    };
    const std::vector<Case> cases{
        {"flag.columns = 2.5", "flag.columns = 2.5", "whole number"},
        {"flag.columns = 3.0", "flag.columns = 3.0", "whole number"},
        {"flag.rows = \"30\"", "flag.rows = \"30\"", "whole number"},
        {"flag.rows = 99999999999999", "flag.rows = 99999999999999", "from 1 to 4096"},
        {"flag.width = 0", "flag.width = 0", "from 0.001 to 1000"},
        {"flag.width = nan", "flag.width = nan", "from 0.001 to 1000"},
        {"flag.height = inf", "flag.height = inf", "from 0.001 to 1000"},
        {"flag.attach = \"roof\"", "flag.attach = \"roof\"",
         "\"hoist\", \"grommets\", \"top\", \"corner\", \"sides\", \"edges\""},
        {"flag.start = true", "flag.start = true", "\"flat\", \"hanging\" or \"crumpled\""},
        {"flag.prestretch = -1", "flag.prestretch = -1", "from -0.9 to 10"},
        {"flag.texture = 3", "flag.texture = 3", "text"},
        {"flag.texture = \"a\\nb\"", "flag.texture = \"a", "text"},
        {"gravity.acceleration = -9.8", "gravity.acceleration = -9.8", "three numbers"},
        {"gravity.acceleration = [0, 1]", "gravity.acceleration = [0, 1]", "three numbers"},
        {"gravity.acceleration = [0, nan, 0]", "gravity.acceleration = [0, nan, 0]", "three numbers"},
        {"gravity.acceleration = [0, 1e5, 0]", "gravity.acceleration", "from -10000 to 10000"},
        {"wind.gusts = [-1, 0, 0]", "wind.gusts = [-1, 0, 0]", "from 0 to 1000000"},
        {"wind.period = 0", "wind.period = 0", "from 0.001 to 1000000"},
        {"wind.seed = -1", "wind.seed = ", "whole number from 0"},
        {"time.dt = 0", "time.dt = 0", "\"auto\" or a number from 1e-09 to 1000"},
        {"time.dt = \"slow\"", "time.dt = \"slow\"", "\"auto\" or a number"},
        {"time.method = \"euler\"", "time.method = \"euler\"", "\"forward-euler\", \"semi-implicit-euler\""},
        {"time.precision = \"half\"", "time.precision = \"half\"", "\"float\" or \"double\""},
        {"view.cloth = 1", "view.cloth = 1", "true or false"},
        {"flag = 3", "flag = 3", "a table is expected"},
        {"name = 1979-05-27", "name = a date", "text"},
    };
    for (const Case& bad : cases) {
        const std::string message = message_of("# first line\n" + bad.line + "\n" + springs);
        INFO(bad.line << " gives: " << message);
        CHECK(is_one_line(message));
        CHECK(message.starts_with("storm.toml:2: "));
        CHECK(has(message, bad.named));
        CHECK(has(message, bad.allowed));
    }
    for (const std::string key : {"mass", "stiffness", "diagonal_stiffness", "damping", "drag", "friction"}) {
        for (const std::string value : {"-1", "nan", "inf", "1e300", "\"1\"", "true", "[1]"}) {
            const std::string rest =
                (key == "mass" ? "" : "mass = 1\n") + std::string(key == "stiffness" ? "" : "stiffness = 1\n");
            const std::string message = message_of("[springs]\n" + key + " = " + value + "\n" + rest);
            INFO(key << " = " << value << " gives: " << message);
            CHECK(is_one_line(message));
            CHECK(message.starts_with("storm.toml:2: springs." + key + " = "));
            CHECK(has(message, "is allowed"));
        }
    }
}

TEST_CASE("an unknown key or table is named, with what may have been meant") {
    CHECK(message_of("[flag]\ncolums = 3\n" + springs) ==
          "storm.toml:2: flag.colums = 3: unknown key; did you mean columns?");
    CHECK(message_of("[flag]\nstiffness = 3\n" + springs) ==
          "storm.toml:2: flag.stiffness = 3: unknown key; it belongs under [springs]");
    CHECK(message_of("columns = 3\n" + springs) == "storm.toml:1: columns = 3: unknown key; it belongs under [flag]");
    CHECK(message_of("[sprngs]\nmass = 3\n") == "storm.toml:1: [sprngs]: unknown table; did you mean springs?");
    CHECK(has(message_of(springs + "[physics]\n"), "[physics]: unknown table; known here: name, flag, springs"));
    CHECK(is_one_line(message_of("\"a\\nb\" = 3\n" + springs)));
}

TEST_CASE("ground is below all that is held") {
    const auto of = [](const std::string& flag, const std::string& height) {
        return message_of("[flag]\nheight = 0.9\n" + flag + "\n" + springs + "[ground]\nheight = " + height + "\n");
    };
    CHECK(has(of("", "-0.5"), "ground.height = -0.5: at most -0.9000 m, the lowest that is held"));
    CHECK(of("", "-0.9").empty());
    CHECK(of("attach = \"corner\"", "-0.5").empty());
    CHECK(has(of("attach = \"corner\"", "0.5"), "ground.height = 0.5: at most 0"));
    CHECK(of("attach = \"none\"", "0.5").empty());
    CHECK(of("halyard = 0", "-3").empty());  // its foot stands on the ground
}

TEST_CASE("an image that is text is no scene, and the message says where it goes") {
    CHECK(has(message_of("<svg xmlns=\"http://www.w3.org/2000/svg\"/>"), "--texture"));
    CHECK(has(message_of("\n <?xml version=\"1.0\"?><svg/>"), "--texture"));
}

TEST_CASE("a scene has exactly one material") {
    CHECK(message_of("[flag]\ncolumns = 3\n") == "storm.toml:1: the material is missing: [springs] or [fabric]");
    CHECK(has(message_of("[springs]\nstiffness = 1\n"), "storm.toml:1: springs.mass is missing"));
    CHECK(has(message_of("[springs]\nmass = 1\n"), "storm.toml:1: springs.stiffness is missing"));
    CHECK(has(message_of(springs + "[fabric]\ndensity = 1\n"),
              "storm.toml:4: the material is given by [springs] and [fabric]"));
    CHECK_NOTHROW(parse_scene("[fabric]\n", "storm.toml"));
}

TEST_CASE("a fabric has the values of its name but where others are given") {
    const auto fabric_in = [](const std::string& keys) {
        return *parse_scene("[fabric]\n" + keys, "storm.toml").fabric;
    };
    CHECK(fabric_in("") == fabric_of(FabricName::knitted_polyester));
    CHECK(Fabric{} == fabric_of(FabricName::knitted_polyester));
    Fabric silk = fabric_of(FabricName::silk);
    CHECK(fabric_in("name = \"silk\"\n") == silk);
    CHECK(silk.density != Fabric{}.density);
    silk.density = 0.05;
    silk.diagonal_share.reset();
    CHECK(fabric_in("density = 0.05\nname = \"silk\"\ndiagonal_share = \"off\"\n") == silk);

    // A file says only what the name does not, so that another name brings all its values.
    Scene scene = parse_scene("[fabric]\nname = \"silk\"\ndrag_per_area = 0.5\n", "storm.toml");
    const std::string text = write_scene(scene);
    CHECK_FALSE(has(text, "density"));
    CHECK(has(text, "drag_per_area = 0.5"));
    const auto canvas = parse_scene(text, "storm.toml", std::vector{assignment_in("fabric.name=canvas")});
    CHECK(canvas.fabric->density == fabric_of(FabricName::canvas).density);
    CHECK(canvas.fabric->drag_per_area == 0.5);
}

TEST_CASE("cells that springs of the fabric cannot have are refused, with the nearest grid that works") {
    // At a share of 1/2 cells are less than sqrt(3) times as long as wide. 2 m x 1 m: 21 columns and 11 rows are
    // square.
    const auto message = [](int columns, int rows, const std::string& share) {
        return message_of("[flag]\nwidth = 2\nheight = 1\ncolumns = " + std::to_string(columns) +
                          "\nrows = " + std::to_string(rows) + "\n[fabric]\ndiagonal_share = " + share + "\n");
    };
    CHECK(message(21, 11, "0.5").empty());
    CHECK(message(21, 7, "0.5").empty());  // 0.1 x 0.167
    CHECK(has(message(21, 6, "0.5"), "storm.toml:7: fabric.diagonal_share = 0.5: "));
    CHECK(has(message(21, 6, "0.5"), "1.73 times"));
    CHECK(has(message(21, 6, "0.5"), "18 x 6"));  // 17 cells for 20: less of a change than 6 rows of cells for 5
    CHECK(has(message(61, 11, "0.5"), "46 x 14"));
    CHECK(has(message(46, 30, "10"), "1.0488 times"));
    // Where no other number of one side alone does: 1.5 m x 1 m on 3 x 2 masses, 1.5 m x 0.9 m on 45 x 30.
    const auto fitting = [](int columns, int rows, double height, double share) {
        Scene scene;
        scene.springs.reset();
        scene.fabric = Fabric{.diagonal_share = share};
        scene.flag.columns = columns, scene.flag.rows = rows, scene.flag.height = height;
        CHECK_FALSE(do_cells_fit(scene));
        return fitting_grid(scene);
    };
    CHECK(fitting(3, 2, 1.0, 3.0) == std::pair{4, 3});
    CHECK(fitting(45, 30, 0.9, 10.0) == std::pair{46, 29});
    CHECK(message(400, 2, "\"off\"").empty());
    CHECK(has(message(2, 1, "0.1"), "flag.rows = 1: a fabric has two rows"));
    CHECK(has(message(1, 2, "0.1"), "flag.columns = 1: a fabric has two rows"));
}

TEST_CASE("wind that nothing feels is an error") {
    CHECK(has(message_of(springs + "[wind]\nvelocity = [1, 0, 0]\n"), "storm.toml:4: wind: nothing would feel it"));
    CHECK(message_of(springs + "drag = 0.1\n[wind]\nvelocity = [1, 0, 0]\n").empty());
    // The air on faces feels it as well as drag does, or any part of it.
    const auto in_air = [](const std::string& parts) { return message_of(springs + "[air]\n" + parts + "[wind]\n"); };
    CHECK(in_air("").empty());
    CHECK(in_air("pressure = \"off\"\n").empty());
    CHECK(in_air("skin = \"off\"\n").empty());
    CHECK(has(in_air("pressure = \"off\"\nskin = \"off\"\n"), "give springs.drag or [air] too"));
}

TEST_CASE("air on faces has the values of common air and cloth, and a part of it may be off") {
    const auto air_of = [](const std::string& keys) {
        return *parse_scene(springs + "[air]\n" + keys, "x").terms.get<Air>();
    };
    CHECK(air_of("") == Air{.density = 1.2, .pressure = 1.2, .skin = 0.05});
    CHECK(air_of("pressure = \"off\"\nskin = 0.02\n") == Air{.density = 1.2, .pressure = {}, .skin = 0.02});
    CHECK(has(message_of(springs + "[air]\nskin = -1\n"),
              "storm.toml:5: air.skin = -1: \"off\" or a number from 0 to 100 is allowed"));
    CHECK(has(message_of(springs + "[air]\npressure = \"none\"\n"), "air.pressure = \"none\": \"off\" or"));
    const Model model = model_of(parse_scene(springs + "[air]\n", "x"));
    CHECK(model.air() != nullptr);
    CHECK(model_of(parse_scene(springs, "x")).air() == nullptr);
}

TEST_CASE("bending has a stiffness and, if asked for, a damping") {
    const auto bending_of = [](const std::string& keys) {
        return *parse_scene(springs + "[bending]\n" + keys, "x").terms.get<Bending>();
    };
    CHECK(bending_of("") == Bending{.stiffness = 1e-4, .damping = {}});
    CHECK(bending_of("stiffness = 0.02\ndamping = 30\n") == Bending{.stiffness = 0.02, .damping = 30.0});
    CHECK(bending_of("damping = \"off\"\n") == Bending{});
    CHECK(has(message_of(springs + "[bending]\nstiffness = -1\n"), "storm.toml:5: bending.stiffness = -1: "));
    CHECK(model_of(parse_scene(springs + "[bending]\n", "x")).bending() != nullptr);
    CHECK(model_of(parse_scene(springs, "x")).bending() == nullptr);
}

TEST_CASE("a named fabric bends as its name says, where nothing else is said") {
    const auto stiffness_of = [](const std::string& text) {
        return parse_scene(text, "x").terms.get<Bending>()->stiffness;
    };
    for (const auto name : {FabricName::knitted_polyester, FabricName::woven_polyester, FabricName::nylon,
                            FabricName::silk, FabricName::canvas}) {
        const std::string named =
            "[fabric]\nname = \"" + std::string(settings::names_of(name)[std::size_t(name)]) + "\"\n";
        CHECK(stiffness_of("[bending]\n" + named) == bending_of(name));
        CHECK(stiffness_of(named + "[bending]\nstiffness = 0.02\n") == 0.02);
    }
    CHECK(stiffness_of("[fabric]\n[bending]\ndamping = 30\n") == bending_of(FabricName::knitted_polyester));
}

TEST_CASE("a tolerance goes with an automatic step, and one beside a given step is an error") {
    CHECK(parse_scene(springs + "[time]\ntolerance = 0.001\n", "x").time.tolerance == 0.001);
    CHECK(parse_scene(springs + "[time]\ndt = \"auto\"\ntolerance = 1\n", "x").time.tolerance == 1.0);
    CHECK(message_of(springs + "[time]\ndt = 0.01\ntolerance = 0.001\n") ==
          "storm.toml:6: time.tolerance = 0.001: goes with time.dt = \"auto\" only, and the step is given");
    CHECK(has(message_of(springs + "[time]\ntolerance = 0\n"),
              "time.tolerance = 0: \"off\" or a number from 1e-09 to 1000"));
}

TEST_CASE("one mass alone is an error, a chain is none") {
    CHECK(has(message_of("[flag]\ncolumns = 1\nrows = 1\n" + springs), "storm.toml:2: flag.columns = 1"));
    CHECK(message_of("[flag]\ncolumns = 1\nrows = 2\n" + springs).empty());
    CHECK(message_of("[flag]\ncolumns = 2\nrows = 1\n" + springs).empty());
}

TEST_CASE("a grid too large is refused with the memory it would take") {
    const std::string message = message_of("[flag]\ncolumns = 1000000000\n" + springs);
    INFO(message);
    CHECK(message.starts_with("storm.toml:2: flag.columns = 1000000000: "));
    CHECK(has(message, "TiB of memory"));
    CHECK(is_one_line(message));
}

TEST_CASE("a file that is no scene is refused in one line") {
    const Folder folder;
    std::string noise(5000, '\0');
    std::mt19937 random(3);
    for (char& c : noise) c = static_cast<char>(random());
    std::string deep = "a";
    for (int n = 0; n < 100000; ++n) deep += ".a";

    const std::vector<std::pair<fs::path, std::string>> cases{
        {folder.path / "missing.toml", "No such file"},
        {folder.path, "folder"},
        {folder.write("empty.toml", ""), "empty"},
        {folder.write("comment.toml", "# nothing\n"), "the material is missing"},
        {folder.write("noise.toml", noise), "not a text file"},
        {folder.write("zeros.toml", std::string(100, '\0')), "not a text file"},
        {folder.write("latin.toml", "name = \"\xE9t\xE9\"\n" + springs), "line 1: byte 0xE9, probably Latin-1"},
        {folder.write("long.toml", std::string(3 << 20, '#')), "1.0 MiB"},
        {folder.write("deep.toml", deep + " = 1\n"), "dots and brackets"},
        {folder.write("nested.toml", "a = " + std::string(3000, '[')), ":1: "},
        {folder.write("syntax.toml", "[flag]\ncolumns = = 3\n"), "syntax.toml:2: "},
        {folder.write("twice.toml", springs + "mass = 3\n"), "twice.toml:4: "},
        {folder.write("open.toml", "name = \"never closed\n"), "open.toml:1: "},
        {"/dev/zero", "1.0 MiB"},
        {"/dev/null", "empty"},
    };
    for (const auto& [file, part] : cases) {
        const std::string message = message_of_file(file);
        INFO(message);
        CHECK(is_one_line(message));
        CHECK(message.starts_with(file.string()));
        CHECK(has(message, part));
    }
}

TEST_CASE("no damage to a scene file does more than an error in one line") {
    const std::string good = write_scene(AnyScene(4)());
    std::mt19937 random(5);
    for (int n = 0; n < 3000; ++n) {
        std::string bad = good;
        for (auto changes = 1 + random() % 4; changes > 0; --changes) {
            const std::size_t at = random() % bad.size();
            switch (random() % 3) {
                case 0:
                    bad[at] = static_cast<char>(random());
                    break;
                case 1:
                    bad.erase(at, random() % 20);
                    break;
                default:
                    bad.insert(at, bad.substr(random() % bad.size(), random() % 20));
            }
            if (bad.empty()) bad = " ";
        }
        const std::string message = message_of(bad);
        if (!message.empty()) REQUIRE(is_one_line(message));
    }
}

TEST_CASE("values that controls make are checked as those of files are") {
    Scene scene;
    CHECK(message_of_scene(scene).empty());
    scene.flag.columns = 0;
    CHECK(message_of_scene(scene) == "flag.columns = 0: a whole number from 1 to 4096 is allowed");
    scene = {};
    scene.springs->damping = std::numeric_limits<double>::quiet_NaN();
    CHECK(message_of_scene(scene) == "springs.damping = nan: a number from 0 to 1000000 is allowed");
    scene = {};
    scene.name = "two\nlines";
    CHECK(is_one_line(message_of_scene(scene)));
    scene = {};
    scene.flag.texture = "no UTF-8: \xFF";
    CHECK(has(message_of_scene(scene), "flag.texture"));
    scene = {};
    scene.wind().emplace();
    CHECK(has(message_of_scene(scene), "nothing would feel it"));
    scene = {};
    scene.flag.attach = static_cast<Attach>(99);
    CHECK(has(message_of_scene(scene), "flag.attach"));
}

/// A scene that lists every setting of one material, each of another value than its default.
Scene unusual_scene(bool of_fabric) {
    Scene scene;
    settings::each_table(scene, [&](const std::string& table, auto& settings, const auto& keys) {
        if (table == (of_fabric ? "springs" : "fabric")) return;
        if constexpr (requires { settings.has_value(); }) settings.emplace();
        auto& values = *settings::listed(settings);
        settings::each_key(keys, [&](const auto& field) {
            auto& value = values.*field.member;
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::string>) {
                value = "5 = \"five\" # [flag]";
            } else if constexpr (std::is_same_v<Value, bool>) {
                value = !value;
            } else if constexpr (std::is_enum_v<Value>) {
                value = static_cast<Value>(value == Value{} ? 1 : 0);
            } else if constexpr (std::is_same_v<Value, glm::dvec3>) {
                value = value + glm::dvec3(0.5, 1.0, 2e-7);
            } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
                value = value.value_or(0.125) + 0.25;
            } else {
                value = value + Value{1};
            }
        });
    });
    scene.time.tolerance.reset();               // goes with an automatic step only
    scene.limits.get<Ground>()->height = -9.5;  // below the flag
    if (of_fabric) scene.springs.reset();
    return scene;
}

TEST_CASE("every setting can be assigned as a file says it") {
    const bool of_fabric = GENERATE(false, true);
    const Scene wanted = unusual_scene(of_fabric);
    std::vector<Assignment> assignments;
    if (of_fabric) assignments.push_back(assignment_in("springs=off"));
    std::istringstream file(write_scene(wanted));
    std::string table;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#') || line.empty()) continue;
        if (line.starts_with('[')) {
            table = line.substr(1, line.size() - 2) + ".";
        } else {
            assignments.push_back(assignment_in(table + line));
        }
    }
    CHECK(assignments.size() > 30);
    CHECK(parse_scene(springs, "storm.toml", assignments) == wanted);
}

TEST_CASE("an assignment may be said as people say it, and is refused as in a file") {
    const auto assigned = [](const std::vector<std::string>& texts) {
        std::vector<Assignment> assignments;
        for (const std::string& text : texts) assignments.push_back(assignment_in(text));
        return parse_scene(springs + "drag = 0.001\n[gravity]\n[view]\nsprings = true\n", "storm.toml", assignments);
    };
    CHECK(assigned({"time.method=rk4"}).time.method == method_id<Rk4>);
    CHECK(assigned({"time.method = \"rk4\""}).time.method == method_id<Rk4>);
    CHECK(assigned({"flag.width=.5"}).flag.width == 0.5);
    CHECK(assigned({"name=5"}).name == "5");
    CHECK(assigned({"name=A = b"}).name == "A = b");
    CHECK(assigned({"wind.velocity=[3, 0, 0]"}).wind()->velocity.x == 3.0);
    CHECK(assigned({"wind=on"}).wind() == Wind{});
    CHECK(assigned({"wind=on", "wind=off"}).wind() == std::nullopt);
    CHECK(assigned({"gravity=off"}).gravity() == std::nullopt);
    CHECK(assigned({"springs.drag=off"}).springs->drag == std::nullopt);
    CHECK(assigned({"air=on", "air.pressure=off"}).terms.get<Air>() == Air{.pressure = {}});
    CHECK(assigned({"time.dt=0.001", "time.dt=auto"}).time.dt == std::nullopt);
    CHECK(assigned({"view.springs=off", "view.masses=on"}).view.masses);
    CHECK_FALSE(assigned({"view.springs=off"}).view.springs);

    const auto refused = [&](const std::string& text) { return message_from([&] { assigned({text}); }); };
    CHECK(refused("flag.columns=0") == "--set flag.columns = 0: a whole number from 1 to 4096 is allowed");
    CHECK(refused("flag.columns=many") == "--set flag.columns = \"many\": a whole number from 1 to 4096 is allowed");
    CHECK(refused("flag.width=0,5") == "--set flag.width = \"0,5\": a number from 0.001 to 1000 is allowed");
    CHECK(refused("flag.width=1\nheight = 2") ==
          "--set flag.width = \"1\\u000aheight = 2\": a number from 0.001 to 1000 is allowed");
    CHECK(has(refused("flag.colums=3"), "--set flag.colums = 3: unknown key; did you mean columns?"));
    CHECK(has(refused("flg.columns=3"), "unknown table; did you mean flag?"));
    CHECK(has(refused("columns=3"), "--set columns = 3: unknown key; it belongs under [flag]"));
    CHECK(has(refused("time.method=xpbdd"), "--set time.method = \"xpbdd\": \"forward-euler\""));
    CHECK(has(refused("springs=off"), "the material is missing"));
    CHECK(has(refused("springs=none"), "--set springs = \"none\": a table is expected"));
    CHECK(has(refused("fabric=on"), "--set fabric: the material is given by [springs] and [fabric]"));
    CHECK(has(refused("springs.mass=off"), "--set springs.mass = \"off\": a number"));
    CHECK(has(refused("limit=on"), "--set limit: limit.stretch is missing"));
    CHECK(has(refused("flag.columns=9223372036854775808"), "--set flag.columns = 9223372036854775808"));
    CHECK(has(refused("time.dt=off"), "--set time.dt = \"off\": \"auto\" or a number"));
    std::string deep = "flag.columns={a";
    for (int n = 0; n < 60000; ++n) deep += ".a";
    CHECK(has(refused(deep + "=1}"), "at most 5000 are allowed"));
    for (const std::string text :
         {"", "=", "=3", "flag.columns", "flag.columns 3", "a.b.c=3", "a b=3", "[flag]=3", ".=3"})
        CHECK(has(refused(text), "KEY=VALUE is wanted"));
}

TEST_CASE("docs/scene.md is what the table of settings says") {
    std::ifstream page(DRAPEAU_DOCS "/scene.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    CHECK(text == settings_reference());  // drapeau-lab settings >docs/scene.md
}

TEST_CASE("a scene is found by path or by its shipped name") {
    const Folder folder;
    const fs::path file = folder.write("mine.toml", springs);
    CHECK(find_scene(file.string()) == file);
    CHECK(find_scene("storm").filename() == "storm.toml");
    CHECK(fs::exists(find_scene("storm")));
    const std::string typo = message_from([] { find_scene("strom"); });
    CHECK(has(typo, "strom: no such file or shipped scene; did you mean storm?"));
    CHECK(has(typo, "shipped: report"));
    CHECK_THROWS_AS(find_scene("../scenes/storm"), InputError);
    CHECK_THROWS_AS(find_scene(""), InputError);
    CHECK(has(message_from([&] { find_scene(folder.path.string()); }), "folder"));
}

TEST_CASE("a texture lies beside the scene or among the flags") {
    const Folder folder;
    folder.write("france.png", "mine");
    const fs::path scene =
        folder.write("x.toml", std::string(springs) + "[flag]\ncolumns = 4\ntexture = \"none.png\"\n");
    const std::string place = place_of_texture(scene);
    const auto found = [&](const std::string& texture) { return find_texture(texture, scene, place); };
    CHECK(found("france.png") == folder.path / "france.png");
    CHECK(found("japan.png") == assets_directory() / "flags" / "japan.png");
    const auto line = 3 + std::count(springs.begin(), springs.end(), '\n');
    const std::string told = scene.string() + ":" + std::to_string(line) + ": flag.texture = \"none.png\": neither";
    CHECK(message_from([&] { found("none.png"); }).starts_with(told));
    CHECK(has(message_from([&] { found("jpan.png"); }), "did you mean japan.png?"));
    CHECK(message_from([&] { found("none.png"); }).size() < told.size() + 250);  // a few lines at most
    CHECK_THROWS_AS(found(""), InputError);
    CHECK(place_of_texture(folder.path / "nowhere.toml") == (folder.path / "nowhere.toml").string());
}

TEST_CASE("a value out of its range is said as it was given, one that was computed is rounded, with its unit") {
    Scene scene = parse_scene("[springs]\nmass = 0.01\nstiffness = 5\n", "typed.toml");
    scene.time.dt = 7.5e-10;
    CHECK(message_of_scene(scene).starts_with("time.dt = 7.5e-10: "));
    scene.time.dt = std::nextafter(7.5e-10, 1.0);  // 7.500000000000001e-10
    CHECK(message_of_scene(scene).starts_with("time.dt = 0.75 ns: "));
}

TEST_CASE("every shipped scene loads, finds its texture and runs a second within a few per cent of stretch") {
    const auto names = shipped_scenes();
    REQUIRE(names.size() >= 8);
    CHECK(names.front() == "report");
    for (const std::string& name : names) {
        INFO(name);
        const fs::path file = find_scene(name);
        const Scene scene = read_scene(file);
        if (!scene.flag.texture.empty()) CHECK(fs::exists(find_texture(scene.flag.texture, file, name)));

        Simulation simulation(scene);
        for (int batch = 0; batch < 60; ++batch) {
            const auto divergence = simulation.advance_batch();
            INFO((divergence ? divergence->message : ""));
            REQUIRE_FALSE(divergence);
        }
        const auto state = simulation.state();
        for (const auto* field : {&state.position, &state.velocity})
            for (int c = 0; c < 3; ++c)
                for (const double value : field->component(c)) REQUIRE(std::isfinite(value));
        // A spring meant to be seen swinging may stretch; cloth may not, but across the bias: where the storm makes
        // the fly snap, 17 % was seen there, and 7 % along the threads.
        const double most = name == "storm" || name == "flutter" ? 0.2 : 0.1;
        if (name != "spring") CHECK(simulation.readings().max_stretch < most + scene.flag.prestretch);
        CHECK(simulation.steps_per_batch() <= 1000);
    }
}

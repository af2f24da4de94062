// Films: when their frames are, what they pass into, what is refused, and what is written.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "io/error.hpp"
#include "viewer/batch_track.hpp"
#include "viewer/film.hpp"
#include "viewer/film_flight.hpp"
#include "viewer/film_plan.hpp"
#include "viewer/film_writer.hpp"
#include "viewer/numbered_name.hpp"
#include "viewer/obj_file.hpp"
#include "viewer/progress_line.hpp"
#include "viewer/transparency.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

struct Folder : TemporaryFolder {
    long long files() const { return std::distance(fs::directory_iterator(path), {}); }
};

/// 40 steps a batch: 24, 25, 30, 50 and 120 frames/s are all whole numbers of steps.
Scene flying() {
    Scene scene;
    scene.flag.columns = 12, scene.flag.rows = 8;
    scene.springs->damping = 0.002;
    scene.springs->drag = 0.0006;
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {5.0, 0.0, 1.0}, .gusts = {1.0, 0.5, 1.0}};
    scene.time.dt = 1.0 / 2400.0;
    scene.time.precision = Precision::double_precision;
    return scene;
}

double greatest_distance(const FieldBuffer<float>& a, const FieldBuffer<float>& b) {
    double greatest = 0.0;
    for (int row = 0; row < a.rows(); ++row)
        for (int column = 0; column < a.columns(); ++column) {
            const glm::dvec3 d = a.at(column, row) - b.at(column, row);
            greatest = std::max(greatest, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
        }
    return greatest;
}

std::vector<FilmFrame> frames_of(const FilmPlan& plan, const Scene& scene) {
    FilmFlight flight(plan, scene, std::nullopt);
    std::vector<FilmFrame> frames;
    while (static_cast<long long>(frames.size()) < plan.frames()) {
        flight.wait(10.0);
        auto frame = flight.take();
        REQUIRE(frame.has_value());
        frames.push_back(std::move(*frame));
    }
    return frames;
}

void check_refused(const FilmPlan& plan, const std::string& part) {
    CAPTURE(plan.file.string(), part);
    CHECK_THROWS_WITH(check_film(plan), ContainsSubstring(part));
}

}  // namespace

TEST_CASE("a frame shows the flag at its own time, whether a batch ends there or not") {
    for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 120.0}) {
        CAPTURE(rate);
        Simulation filmed(flying()), stepped(flying());
        BatchTrack track(filmed);
        const std::atomic<bool> never{false};
        const auto steps = std::llround(2400.0 / rate);
        Snapshot frame, before, exact;
        double greatest = 0.0, farthest = 0.0;
        for (int k = 0; k < int(rate); ++k) {
            REQUIRE(!track.follow(k / rate, frame, never));
            stepped.snapshot(exact);
            CHECK(std::abs(frame.time - k / rate) < 1e-9);
            greatest = std::max(greatest, greatest_distance(frame.position, exact.position));
            if (k > 0) farthest = std::max(farthest, greatest_distance(exact.position, before.position));
            before = exact;
            REQUIRE(!stepped.advance_steps(steps));
        }
        CHECK(farthest > 0.01);
        // The cubic is off by what springs vibrate faster than batches, here with less than 0.5 mm. Rounding to the
        // nearest batch would be off by up to half of its way, which is more than 2 mm at 0.3 m/s. Ends of batches are
        // the run's own, to the bit.
        CHECK(greatest < (rate == 30.0 || rate == 60.0 ? 1e-12 : 5e-4));
    }
}

TEST_CASE("the end of a film that loops passes into its beginning as one frame into the next") {
    const FilmPlan plan{.file = "a.mp4", .rate = 30.0, .seconds = 2.0, .from = 1.0, .loop = true};
    CHECK(plan.blended() == 30);
    const auto frames = frames_of(plan, flying());
    double between_neighbours = 0.0;
    for (std::size_t k = 1; k < frames.size(); ++k)
        between_neighbours = std::max(between_neighbours,
                                      greatest_distance(frames[k].snapshot.position, frames[k - 1].snapshot.position));
    CHECK(greatest_distance(frames.back().snapshot.position, frames.front().snapshot.position) <= between_neighbours);

    // Without the loop it jumps.
    FilmPlan plain = plan;
    plain.loop = false;
    const auto others = frames_of(plain, flying());
    CHECK(greatest_distance(others.back().snapshot.position, others.front().snapshot.position) >
          2.0 * between_neighbours);
    // What is not blended is the same.
    CHECK(greatest_distance(others[20].snapshot.position, frames[20].snapshot.position) == 0.0);
}

TEST_CASE("a film has as many frames as its length at its rate, at their times") {
    CHECK(FilmPlan{.file = "a.mp4", .rate = 24.0, .seconds = 8.0}.frames() == 192);
    CHECK(FilmPlan{.file = "a.mp4", .rate = 60.0, .seconds = 0.001}.frames() == 1);
    CHECK(FilmPlan{.file = "a.mp4", .rate = 30.0, .seconds = 1.01}.frames() == 30);
    CHECK(FilmPlan{.file = "a.mp4", .rate = 25.0, .from = 2.0}.time_of(5) == 2.2);
    const FilmPlan loop{.file = "a.mp4", .rate = 60.0, .seconds = 4.0, .from = 3.0, .loop = true};
    CHECK(loop.share_of_beginning(180) == 0.0);
    CHECK(loop.share_of_beginning(210) == 0.5);
    CHECK(loop.share_of_beginning(239) > 0.99);
    CHECK(progress_text({.file = "flag.mp4", .rate = 60.0, .seconds = 8.0}, 120, 4.0) ==
          "flag.mp4: 120 of 480 frames, 25 %, 12 s left");
}

TEST_CASE("a film that cannot be is refused in one line that says what can") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const FilmPlan good{.file = "a.mp4", .width = 160, .height = 100};
    CHECK_NOTHROW(check_film(good));
    const auto with = [&](auto change) {
        FilmPlan plan = good;
        change(plan);
        return plan;
    };
    for (const double rate : {0.0, -1.0, 1e9, nan})
        check_refused(with([&](FilmPlan& p) { p.rate = rate; }), "from 1 to 240 frames/s");
    for (const double seconds : {0.0, -1.0, 1e9, nan, HUGE_VAL})
        check_refused(with([&](FilmPlan& p) { p.seconds = seconds; }), "from 1 to 1000000 frames");
    for (const double from : {-1.0, 1e9, nan})
        check_refused(with([&](FilmPlan& p) { p.from = from; }), "from 0 to 3600 s");
    check_refused(with([](FilmPlan& p) { p.loop = true; }), "1.00 s before its first frame");
    check_refused(with([](FilmPlan& p) { p.width = 161; }), "even sides, such as 162x100");
    check_refused(with([](FilmPlan& p) { p.transparent = true; }), ".mov, .webm, .gif, frames-%04d.png are");
    check_refused(with([](FilmPlan& p) { p.file = "a.txt"; }), "the ending chooses the format");
    check_refused(with([](FilmPlan& p) { p.file = "a.png"; }), "frames-%04d.png");
    check_refused(with([](FilmPlan& p) { p.file = "a-%d.mp4"; }), "a sequence is one of pictures");
    check_refused(with([](FilmPlan& p) { p.file = "a.gif"; }), "50, 25, 20 or 10 frames/s, not 60");
    check_refused(with([](FilmPlan& p) { p.file = "a.gif", p.rate = 25.0, p.seconds = 1e4, p.width = 4000; }),
                  "of memory");
    for (const char* name : {"a.webm", "a.MOV", "a-%03d.png"})
        CHECK_NOTHROW(check_film(with([&](FilmPlan& p) { p.file = name, p.transparent = true; })));
    CHECK_NOTHROW(check_film(with([](FilmPlan& p) { p.file = "a-%d.png", p.width = 161; })));
}

TEST_CASE("a numbered name has one place for the number") {
    CHECK(numbered("out/frames-%04d.png", 7) == fs::path("out/frames-0007.png"));
    CHECK(numbered("%d.png", 12) == fs::path("12.png"));
    CHECK(numbered("a%02d", 123) == fs::path("a123"));
    CHECK(!means_sequence("50%/a.png"));
    for (const char* bad : {"%", "a%s.png", "a%4d.png", "%d%d.png", "a%00d.png", "100%.png", "%n.png"})
        CHECK_THROWS_AS(check_numbered(bad), InputError);
}

TEST_CASE("a sequence of pictures is whole, or nothing is left of it and pictures of its names stay as they were") {
    const Folder folder;
    const fs::path older = folder.path / "p-00.png";
    std::ofstream(older) << "older";
    const FilmPlan plan{.file = folder.path / "p-%02d.png",
                        .width = 16,
                        .height = 16,
                        .rate = 10.0,
                        .seconds = 0.3,
                        .transparent = true};
    {
        FilmWriter given_up(plan, "");
        given_up.add(blank_image(16, 16));
        while (given_up.written() == 0 && given_up.trouble().empty()) given_up.wait(1.0);
        CHECK(folder.files() == 2);
    }
    CHECK(folder.files() == 1);
    CHECK(fs::file_size(older) == 5);
    FilmWriter whole(plan, "");
    for (int k = 0; k < 3; ++k) whole.add(blank_image(16, 16));
    while (!whole.done() && whole.trouble().empty()) whole.wait(1.0);
    CHECK(whole.trouble().empty());
    CHECK(folder.files() == 3);
    CHECK(fs::exists(folder.path / "p-02.png"));
    CHECK(fs::file_size(older) > 5);
}

TEST_CASE("what was drawn over nothing has its own colour again, and its alpha") {
    const auto linear = [](double srgb) {
        return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
    };
    const auto srgb = [](double light) {
        return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    };
    for (const int alpha : {64, 128, 191, 255})
        for (const int colour : {40, 128, 220, 255}) {
            const double share = linear(colour / 255.0) * alpha / 255.0;
            Image image = blank_image(1, 1);
            image.rgba = {std::uint8_t(std::lround(255.0 * srgb(share))), 0, 0, std::uint8_t(alpha)};
            const Image back = unpremultiplied(image);
            CHECK(back.rgba[3] == alpha);
            // Half a step of what was rounded; d srgb/d srgb of the product is at most 255/alpha.
            CHECK(std::abs(back.rgba[0] - colour) <= 0.5 * 255.0 / alpha + 0.5);
        }
    CHECK(unpremultiplied(blank_image(1, 1)).rgba == std::vector<std::uint8_t>{0, 0, 0, 0});
}

TEST_CASE("a shape's file has every mass with its place on the image, and faces that show the front") {
    const Folder folder;
    Simulation run(flying());
    REQUIRE(!run.advance_batch());
    Snapshot shape;
    run.snapshot(shape);
    write_obj(folder.path / "a.obj", shape);
    std::ifstream file(folder.path / "a.obj");
    std::vector<glm::dvec3> places, normals;
    std::vector<std::pair<double, double>> on_image;
    int faces = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        glm::dvec3 v(0.0);
        if (kind == "v") words >> v.x >> v.y >> v.z, places.push_back(v);
        if (kind == "vn") words >> v.x >> v.y >> v.z, normals.push_back(v);
        if (kind == "vt") words >> v.x >> v.y, on_image.emplace_back(v.x, v.y);
        if (kind != "f") continue;
        ++faces;
        std::vector<std::size_t> corners;
        for (std::string corner; words >> corner;) corners.push_back(std::stoul(corner) - 1);
        REQUIRE(corners.size() == 4);
        const glm::dvec3 a = places[corners[1]] - places[corners[0]], b = places[corners[2]] - places[corners[0]];
        const glm::dvec3 n = normals[corners[0]];
        CHECK((a.y * b.z - a.z * b.y) * n.x + (a.z * b.x - a.x * b.z) * n.y + (a.x * b.y - a.y * b.x) * n.z > 0.0);
    }
    CHECK(faces == 11 * 7);
    REQUIRE(places.size() == 96);
    REQUIRE(normals.size() == 96);
    REQUIRE(on_image.size() == 96);
    CHECK(on_image.front() == std::pair(0.0, 1.0));
    CHECK(on_image.back() == std::pair(1.0, 0.0));
    for (int n = 0; n < 96; ++n) {
        const glm::dvec3 mass = shape.position.at(n % 12, n / 12), place = places[std::size_t(n)];
        CHECK((float(place.x) == float(mass.x) && float(place.y) == float(mass.y) && float(place.z) == float(mass.z)));
    }
    CHECK_THROWS_AS(check_obj_name("a.stl"), InputError);
    CHECK_THROWS_AS(check_obj_name("a-%s.obj"), InputError);
    CHECK_NOTHROW(check_obj_name("a-%d.OBJ"));
}

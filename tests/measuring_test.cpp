// Measuring: what the window finds out beside the flag is what the laboratory would, can be ended at any moment, and
// says what is wrong where nothing can be measured.
#include "catch.hpp"

#include "measure/setting_choice.hpp"
#include "scene/file.hpp"
#include "viewer/findings.hpp"
#include "viewer/measuring.hpp"

#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <utility>

using namespace drapeau;
using namespace std::chrono_literals;

namespace {

/// One mass on one spring, moving up and down: its motion is known.
Scene oscillator() {
    return parse_scene(R"(
[flag]
columns = 1
rows = 2
height = 1.0
attach = "top"
prestretch = 0.1
[springs]
mass = 0.01
stiffness = 10.0
[time]
method = "leapfrog"
)",
                       "oscillator");
}

MeasuredScene measured(Measuring::Subject subject, const Scene& scene) {
    Measuring measuring;
    measuring.measure(subject, scene);
    measuring.wait();
    auto found = measuring.take();
    REQUIRE(found);
    CHECK_FALSE(measuring.take());
    CHECK_FALSE(measuring.under_way());
    return std::move(*found);
}

/// What leapfrog makes of an oscillation x = A cos(w t) from t on, after so many steps: it turns by
/// theta = 2 asin(w dt / 2) a step instead of w dt.
double by_leapfrog(double amplitude, double w, double t, double dt, long long steps) {
    const double x = amplitude * std::cos(w * t), v = -amplitude * w * std::sin(w * t);
    const double theta = 2.0 * std::asin(0.5 * w * dt), turned = theta * static_cast<double>(steps);
    return x * std::cos(turned) + dt * v / std::sin(theta) * std::sin(turned);
}

Measured point_of(Method method, double ms, double error) {
    Measured point;
    point.point.method = method;
    point.point.precision = Precision::double_precision;
    point.outcome = Measured::Outcome::measured;
    point.ms_per_second = ms;
    point.error.at_end = point.error.over_time = point.error_in_time.at_end = point.error_in_time.over_time = error;
    return point;
}

constexpr double span = 0.1;  // s

/// Leapfrog, rk4 and implicit Euler; errors in mm a simulated second, costs in ms a simulated second.
Findings three_settings(const Scene& scene) {
    MeasuredTrade trade;
    trade.scene = scene;
    trade.seconds = span;
    trade.points = {point_of(method_id<Leapfrog>, 20.0, 1e-3 * 1.0 * span),
                    point_of(method_id<Rk4>, 60.0, 1e-3 * 0.01 * span),
                    point_of(method_id<ImplicitEuler>, 5.0, 1e-3 * 50.0 * span),
                    point_of(method_id<Rk4>, 5000.0, 1e-3 * 0.001 * span)};
    trade.automatic = {1, 1, 1, 1};
    Findings findings;
    findings.trade = trade;
    return findings;
}

bool mentions(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("errors measured beside the flag are those of the methods' closed motion") {
    const Scene scene = oscillator();
    const MeasuredScene found = measured(Measuring::Subject::trade, scene);
    CHECK(found.trouble == "");
    REQUIRE(found.trade);
    const MeasuredTrade& trade = *found.trade;
    CHECK(trade.seconds == Approx(span));
    CHECK(trade.since == Approx(2.0));
    const double w = std::sqrt(scene.springs->stiffness / scene.springs->mass);
    constexpr double amplitude = 0.1;  // m: nothing else pulls
    int compared = 0;
    for (const Measured& point : trade.points) {
        if (point.point.method != method_id<Leapfrog> || point.point.precision != Precision::double_precision) continue;
        if (!point.is_measured() || point.is_below_resolution()) continue;
        const long long steps = 6 * point.point.steps_a_batch;
        const double expected = std::abs(by_leapfrog(amplitude, w, trade.since, point.point.dt(), steps) -
                                         amplitude * std::cos(w * (trade.since + span)));
        CAPTURE(point.point.key);
        // Swinging in, rk4 at its automatic step keeps a thousandth of the amplitude.
        CHECK(std::abs(error_rate(point, span) * span - expected) <= 1e-3 * expected + 2.0 * point.known_to);
        CHECK(point.ms_per_second > 0.0);
        ++compared;
    }
    CHECK(compared >= 2);
    for (const std::size_t n : trade.front) CHECK(trade.points[n].is_measured());
}

TEST_CASE("what a part costs and matters is found beside the flag") {
    Scene scene = oscillator();
    scene.springs->drag = 0.002;
    const MeasuredScene found = measured(Measuring::Subject::prices, scene);
    CHECK(found.trouble == "");
    REQUIRE(found.prices);
    const MeasuredPrices& prices = *found.prices;
    CHECK(prices.ms_per_second > 0.0);
    bool has_drag = false;
    for (const Priced& priced : prices.parts) {
        if (priced.part.key != "springs.drag") continue;
        has_drag = true;
        REQUIRE(priced.effect.is_measured);
        // Both motions begin with what the drag left after two seconds. Without it x = e + B cos(w t + p) goes on for
        // ever; with it, B exp(-g t) with g = d/2m, at almost the same frequency: they part by at most
        // B (1 - exp(-g T)) and the phase (w - w') T B, and by no more than twice that anywhere.
        const double m = scene.springs->mass, w = std::sqrt(scene.springs->stiffness / m), g = 0.5 * 0.002 / m;
        const double left = 0.1 * std::exp(-g * prices.since), seconds = prices.seconds;
        const double most = left * (1.0 - std::exp(-g * seconds)) + left * (w - std::sqrt(w * w - g * g)) * seconds;
        CHECK(priced.effect.apart.at_end <= 1.01 * most + left * g / w);
        CHECK(priced.effect.apart.greatest >= 0.5 * left * (1.0 - std::exp(-g * seconds)));
    }
    CHECK(has_drag);
}

TEST_CASE("a measurement can be ended at any moment, and another takes its place", "[threads]") {
    Scene large = oscillator();
    large.flag.columns = 60, large.flag.rows = 40;
    Measuring measuring;
    for (const auto pause : {0ms, 5ms, 50ms, 300ms}) {
        measuring.measure(Measuring::Subject::trade, large);
        CHECK(measuring.under_way() == Measuring::Subject::trade);
        std::this_thread::sleep_for(pause);
        measuring.stop();
        CHECK_FALSE(measuring.under_way());
        measuring.wait();
        CHECK_FALSE(measuring.take());
    }
    measuring.measure(Measuring::Subject::trade, oscillator());
    measuring.wait();
    measuring.stop();
    CHECK_FALSE(measuring.take());
    measuring.measure(Measuring::Subject::prices, large);
    measuring.measure(Measuring::Subject::trade, oscillator());
    measuring.wait();
    const auto found = measuring.take();
    REQUIRE(found);
    CHECK((found->trade && found->trade->scene == oscillator()));
}

TEST_CASE("where nothing can be measured it is said why") {
    Scene scene = oscillator();
    scene.flag.attach = Attach::all;
    const MeasuredScene found = measured(Measuring::Subject::trade, scene);
    CHECK_FALSE(found.trade);
    CHECK(mentions(found.trouble, "every mass is held"));
    CHECK(mentions(measured(Measuring::Subject::prices, scene).trouble, "every mass is held"));
}

TEST_CASE("an accuracy is met by the cheapest setting measured that has it") {
    Scene scene = oscillator();
    Findings findings = three_settings(scene);
    const auto method_for = [&](double millimetres) {
        return settings_for(1e-3 * millimetres, scene, findings).method;
    };
    CHECK(method_for(100.0) == method_id<ImplicitEuler>);
    CHECK(method_for(2.0) == method_id<Leapfrog>);
    CHECK(method_for(0.1) == method_id<Rk4>);
    const TimeSettings time = settings_for(2e-3, scene, findings);
    CHECK_FALSE(time.dt);
    CHECK(time.tolerance == 2e-3);
    const AccuracyAnswer answer = answer_for(2e-3, scene, findings);
    CHECK(answer.is_good);
    CHECK_FALSE(answer.instead);
    CAPTURE(answer.text);
    CHECK(mentions(answer.text, "1.0 mm/s for 20 ms of processor time a second (50 times real time)"));
    CHECK(mentions(answer.text, "next rk4, 60 ms"));
    const double dt = findings.trade->points[0].point.dt();
    CHECK_FALSE(mentions(answer_for(2e-3, scene, findings, dt).text, "Now it needs"));
    CHECK(mentions(answer_for(2e-3, scene, findings, 0.5 * dt).text, "Now it needs steps of"));

    SECTION("an automatic step that is never as long does not count") {
        findings.trade->automatic[0] = 0;
        CHECK(method_for(2.0) == method_id<Rk4>);
    }
    SECTION("where the machine cannot keep up the nearest with which it can is offered") {
        const AccuracyAnswer slow = answer_for(2e-6, scene, findings);
        CHECK_FALSE(slow.is_good);
        CHECK(mentions(slow.text, "cannot keep up"));
        REQUIRE(slow.instead);
        CHECK(*slow.instead >= 1e-5);
        CHECK(answer_for(*slow.instead, scene, findings).is_good);
    }
    SECTION("where none is as accurate the nearest is offered") {
        const AccuracyAnswer none = answer_for(1e-7, scene, findings);
        CHECK_FALSE(none.is_good);
        CAPTURE(none.text);
        CHECK(mentions(none.text, "None of 4 settings measured stays within 0.00010 mm/s"));
        REQUIRE(none.instead);
        CHECK(answer_for(*none.instead, scene, findings).is_good);
    }
    SECTION("of another scene nothing is known") {
        scene.springs->stiffness = 20.0;
        CHECK(settings_for(100e-3, scene, findings).method == scene.time.method);
        CHECK(mentions(answer_for(100e-3, scene, findings).text, "has changed"));
    }
    SECTION("how the scene is stepped does not matter") {
        scene.time.method = method_id<ForwardEuler>;
        scene.time.dt = 1e-5;
        CHECK(method_for(2.0) == method_id<Leapfrog>);
    }
}

TEST_CASE("what was measured is followed unless somebody set a method meanwhile") {
    Scene scene = oscillator();
    scene.time.method = method_id<SemiImplicitEuler>;
    Findings findings;
    findings.accuracy = 2e-3;
    scene.time = findings.chosen = settings_for(2e-3, scene, findings);
    CHECK(scene.time.method == method_id<SemiImplicitEuler>);
    MeasuredScene news;
    news.trade = three_settings(scene).trade;
    SECTION("nobody did") {
        take(std::move(news), scene, findings);
        CHECK(scene.time.method == method_id<Leapfrog>);
        CHECK(scene.time == findings.chosen);
    }
    SECTION("somebody did") {
        scene.time.method = method_id<Xpbd>;
        take(std::move(news), scene, findings);
        CHECK(scene.time.method == method_id<Xpbd>);
    }
}

namespace {

/// Findings of a scene whose parts were priced.
Findings priced(const Scene& scene) {
    MeasuredPrices prices{.scene = scene, .since = 0.0, .seconds = 0.1, .parts = {}};
    for (const ScenePart& part : parts_of(scene)) prices.parts.emplace_back().part = part;
    Findings findings;
    findings.prices = std::move(prices);
    return findings;
}

}  // namespace

TEST_CASE("parts are switched off and on again in any order") {
    Scene given = oscillator();
    given.springs->drag = 0.002;
    given.springs->damping = 0.01;
    given.wind().emplace();
    Findings findings = priced(given);
    Scene scene = given;
    CHECK(are_of(findings, scene));
    leave_out("springs.damping", true, scene, findings);
    CHECK_FALSE(scene.springs->damping);
    CHECK(are_of(findings, scene));
    CHECK_FALSE(are_of(findings, given));
    CHECK(findings.missing.empty());
    // Nothing would feel the wind.
    leave_out("springs.drag", true, scene, findings);
    CHECK_FALSE(scene.springs->drag);
    CHECK_FALSE(scene.wind());
    CHECK(findings.missing.contains("wind"));
    CHECK_FALSE(findings.missing.contains("springs.damping"));
    leave_out("springs.damping", false, scene, findings);
    CHECK(scene.springs->damping == 0.01);
    SECTION("a method chosen meanwhile stays") {
        scene.time.method = method_id<Rk4>;
        CHECK(are_of(findings, scene));
        leave_out("springs.drag", false, scene, findings);
        CHECK(scene.time.method == method_id<Rk4>);
    }
    leave_out("springs.drag", false, scene, findings);
    scene.time = given.time;
    CHECK(scene == given);
    CHECK(findings.missing.empty());
}

TEST_CASE("double precision and a tolerance are switched off and on like other parts") {
    Scene given = oscillator();
    given.time.precision = Precision::double_precision;
    given.time.tolerance = 1e-3;
    Findings findings = priced(given);
    Scene scene = given;
    for (const std::string key : {"time.precision", "time.tolerance"}) {
        CAPTURE(key);
        leave_out(key, true, scene, findings);
        hear_of_scene(findings, scene);
        CHECK(findings.left_out.contains(key));
    }
    CHECK(scene.time.precision == Precision::single_precision);
    CHECK_FALSE(scene.time.tolerance);
    leave_out("time.tolerance", false, scene, findings);
    CHECK(scene.time.tolerance == 1e-3);
    leave_out("time.precision", false, scene, findings);
    CHECK(scene == given);
}

TEST_CASE("settings that the run refused leave no part switched off") {
    Scene given = oscillator();
    given.springs->drag = 0.002;
    Findings findings = priced(given);
    Scene scene = given;
    leave_out("springs.drag", true, scene, findings);
    hear_of_scene(findings, scene);
    CHECK(findings.left_out.size() == 1);
    hear_of_scene(findings, given);
    CHECK(findings.left_out.empty());
    Scene other = given;
    other.springs->mass *= 2.0;
    leave_out("springs.drag", true, scene, findings);
    hear_of_scene(findings, other);
    CHECK(findings.left_out.size() == 1);
    CHECK_FALSE(are_of(findings, other));
}

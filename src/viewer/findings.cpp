#include "findings.hpp"

#include "io/text.hpp"
#include "measure/setting_choice.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr double real_time = 1000.0;      // ms a simulated second
constexpr double most = 0.9 * real_time;  // of them that one thread has beside everything else
constexpr double room = 0.8;              // an error measured, of what is then asked for: it varies with the motion

std::string rate_text(double rate) {
    return rounded(1e3 * rate, 2) + " mm/s";
}

std::string cost_text(double ms_per_second) {
    return quantity(1e-3 * ms_per_second, "s", 2);
}

std::string pace_text(double ms_per_second) {
    return rounded(real_time / ms_per_second, 2) + " times real time";
}

/// The priced scene without some of its parts, stepped as `now` is but for what of that is a part too.
Scene without(const MeasuredPrices& prices, const std::set<std::string>& left_out, const Scene& now) {
    Scene scene = prices.scene;
    const TimeSettings priced = prices.scene.time;
    scene.time = now.time;
    if (priced.precision == Precision::double_precision) scene.time.precision = priced.precision;
    if (priced.tolerance && !now.time.dt && !now.time.tolerance) scene.time.tolerance = priced.tolerance;
    scene.view = now.view;
    scene.name = now.name;
    scene.flag.texture = now.flag.texture;
    for (const std::string& key : left_out) {
        const std::vector<ScenePart> parts = parts_of(scene);
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const ScenePart& p) { return p.key == key; });
        if (part != parts.end() && part->impossible.empty()) scene = part->without;
    }
    return scene;
}

}  // namespace

Scene physics_of(Scene scene) {
    scene.view = {};
    scene.name.clear();
    scene.flag.texture.clear();
    return scene;
}

bool holds_for(const Scene& measured, const Scene& now) {
    Scene a = physics_of(measured), b = physics_of(now);
    a.time = b.time = {};
    return a == b;
}

std::string setting_text(const TradePoint& point) {
    const bool is_float = point.precision == Precision::single_precision;
    return fmt::format("{} in {}, {}", name_of(point.method), is_float ? "float" : "double", quantity(point.dt(), "s"));
}

TimeSettings settings_for(double accuracy, const Scene& scene, const Findings& findings) {
    TimeSettings time = scene.time;
    time.dt.reset();
    time.tolerance = accuracy;
    if (!findings.trade || !holds_for(findings.trade->scene, scene)) return time;
    const MeasuredTrade& trade = *findings.trade;
    const SettingChoice choice = choose_setting(trade.points, trade.automatic, trade.seconds, accuracy, most);
    if (const auto place = choice.chosen ? choice.chosen : choice.nearest) {
        time.method = trade.points[*place].point.method;
        time.precision = trade.points[*place].point.precision;
    }
    return time;
}

AccuracyAnswer answer_for(double accuracy, const Scene& scene, const Findings& findings, double dt) {
    AccuracyAnswer answer;
    if (!findings.trade || !holds_for(findings.trade->scene, scene)) {
        answer.text = "The step follows the accuracy asked for; the method ";
        if (findings.under_way == Measuring::Subject::trade)
            answer.text += "is chosen once the settings are measured.";
        else
            answer.text += findings.trade ? "stays, for the scene has changed since its settings were measured."
                                          : "stays, for its settings are not measured.";
        return answer;
    }
    const MeasuredTrade& trade = *findings.trade;
    const SettingChoice choice = choose_setting(trade.points, trade.automatic, trade.seconds, accuracy, most);
    const auto told = [&](const Measured& point) {
        return fmt::format("{}: {} for {} of processor time a second", setting_text(point.point),
                           rate_text(error_rate(point, trade.seconds)), cost_text(point.ms_per_second));
    };
    if (choice.chosen) {
        const Measured& best = trade.points[*choice.chosen];
        answer.text = told(best) + fmt::format(" ({}) when it was measured. Of automatic steps the cheapest within {}",
                                               pace_text(best.ms_per_second), rate_text(accuracy));
        if (choice.next) {
            const Measured& next = trade.points[*choice.next];
            answer.text +=
                fmt::format("; next {}, {} a second", name_of(next.point.method), cost_text(next.ms_per_second));
        }
        answer.text += ".";
        constexpr double smaller = 0.95;
        if (dt > 0.0 && dt < smaller * best.point.dt())
            answer.text += " Now it needs steps of " + quantity(dt, "s") + ".";
        answer.is_good = choice.keeps_up;
        if (choice.keeps_up) return answer;
        answer.text += " This machine cannot keep up with that.";
    } else {
        const auto measured = std::count_if(trade.points.begin(), trade.points.end(),
                                            [](const Measured& point) { return point.is_measured(); });
        answer.text = fmt::format("None of {} settings measured stays within {}.", measured, rate_text(accuracy));
    }
    if (!choice.nearest) {
        answer.text += " It keeps up with none.";
        return answer;
    }
    const Measured& nearest = trade.points[*choice.nearest];
    const double rate = std::max(nearest.error.distance(), nearest.known_to) / trade.seconds;
    answer.instead = rate / room;
    answer.text += " The nearest that keeps up: " + told(nearest) + ".";
    return answer;
}

void take(MeasuredScene measurement, Scene& scene, Findings& findings) {
    findings.trouble = measurement.trouble;
    findings.troubled = measurement.subject;
    if (measurement.trade) findings.trade = std::move(measurement.trade);
    if (measurement.prices) {
        findings.prices = std::move(measurement.prices);
        findings.left_out.clear();
        findings.missing.clear();
    }
    if (findings.accuracy && scene.time == findings.chosen)
        scene.time = findings.chosen = settings_for(*findings.accuracy, scene, findings);
}

TimeSettings settings_of(const TradePoint& point, TimeSettings time) {
    time.method = point.method;
    time.precision = point.precision;
    time.dt = point.dt();
    time.tolerance.reset();
    return time;
}

std::optional<std::size_t> place_of(const TimeSettings& time, double dt, const MeasuredTrade& trade) {
    constexpr double same = 1e-6;  // relative
    for (std::size_t n = 0; n < trade.points.size(); ++n) {
        const TradePoint& point = trade.points[n].point;
        if (point.method == time.method && point.precision == time.precision && std::abs(point.dt() - dt) < same * dt)
            return n;
    }
    return {};
}

void leave_out(const std::string& key, bool is_out, Scene& scene, Findings& findings) {
    const MeasuredPrices& prices = *findings.prices;
    if (is_out)
        findings.left_out.insert(key);
    else
        findings.left_out.erase(key);
    scene = findings.reduced = without(prices, findings.left_out, scene);
    findings.missing.clear();
    for (const Priced& priced : prices.parts)
        if (!findings.left_out.contains(priced.part.key)) findings.missing.insert(priced.part.key);
    for (const ScenePart& part : parts_of(scene)) findings.missing.erase(part.key);
}

void hear_of_scene(Findings& findings, const Scene& now) {
    if (findings.left_out.empty() || are_of(findings, now) || !holds_for(findings.prices->scene, now)) return;
    findings.left_out.clear();
    findings.missing.clear();
}

bool are_of(const Findings& findings, const Scene& now) {
    return findings.prices && holds_for(findings.left_out.empty() ? findings.prices->scene : findings.reduced, now);
}

}  // namespace drapeau

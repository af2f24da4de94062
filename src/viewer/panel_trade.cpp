// The page on speed against accuracy: the setting for an accuracy, all that were measured, and what each part of the
// scene costs and matters.
#include "panels.hpp"

#include "setting_controls.hpp"
#include "trade_chart.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace drapeau {

using namespace settings;

namespace {

using Subject = Measuring::Subject;

/// A paragraph over the panel's width.
void paragraph(const std::string& text) {
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::PopTextWrapPos();
}

/// The button that begins a measurement, or how far it is and the button that ends it.
void measure_button(AppState& app, Subject subject, const char* label, const char* tip, Widgets& widgets) {
    const Findings& findings = app.findings;
    if (findings.under_way != subject) {
        if (widgets.button(label, tip, -1.0f)) app.commands.measure = subject;
        if (!findings.trouble.empty() && findings.troubled == subject)
            widgets.remark("Not measured", "Not measured: " + printable(findings.trouble) + ".", "");
        return;
    }
    const float stop = ImGui::CalcTextSize("Stop").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const float width = ImGui::GetContentRegionAvail().x - stop - ImGui::GetStyle().ItemSpacing.x;
    ImGui::ProgressBar(float(app.findings.share), {width, ImGui::GetFrameHeight()},
                       fmt::format("measuring: {:.0f} %", 100.0 * app.findings.share).c_str());
    widgets.note("Progress", rounded(app.findings.share, 2));
    ImGui::SameLine();
    if (widgets.button("Stop", "Ends the measurement; what was measured before stays."))
        app.commands.stop_measuring = true;
}

void set_time(AppState& app, const TimeSettings& time) {
    app.scene.time = app.findings.chosen = time;
}

void edit_accuracy(AppState& app, Widgets& widgets) {
    Findings& findings = app.findings;
    // Whoever sets a method or a step has no need of one that is chosen.
    if (findings.accuracy && app.scene.time != findings.chosen) findings.accuracy.reset();
    const auto row = row_of(&TimeSettings::tolerance, time_keys);
    const std::optional<double> none;
    constexpr double usual = 1e-3;  // m a simulated second
    const bool was_on = findings.accuracy.has_value();
    if (widgets.term(
            "Accuracy", findings.accuracy, scale_of(row.about, row.control, row.range), none, usual, "as set",
            "The error that may be made, as the reading Error has it: in a tenth of a second, as so much a second. "
            "The program picks the method and the precision that cost least for it with automatic steps, among "
            "all that it measured, and follows it with the step. A method or a step set by hand ends that.",
            "On: the program picks the method, the precision and the step. Off: they are as the page Time says.")) {
        if (findings.accuracy) {
            set_time(app, settings_for(*findings.accuracy, app.scene, findings));
            const bool known = findings.trade && holds_for(findings.trade->scene, app.scene);
            if (!was_on && !known && !findings.under_way) app.commands.measure = Subject::trade;
        } else if (was_on) {
            app.scene.time.tolerance.reset();
        }
    }
    if (!findings.accuracy) return;
    const AccuracyAnswer answer = answer_for(*findings.accuracy, app.scene, findings, app.status.dt);
    if (answer.is_good || !answer.instead)
        paragraph(answer.text);
    else
        widgets.remark("Accuracy", answer.text, "Costs are of one thread, measured beside the flag.");
    widgets.note("Answer", answer.text);
    if (!answer.instead) return;
    const std::string label = "Take " + rounded(1e3 * *answer.instead, 2) + " mm/s";
    if (!widgets.button("Take the nearest", "Asks for as much accuracy as this machine keeps up with.", -1.0f,
                        label.c_str()))
        return;
    findings.accuracy = std::min(*answer.instead, row.control.range.highest);
    set_time(app, settings_for(*findings.accuracy, app.scene, findings));
}

TradeMark mark_of(const AppState& app, const MeasuredTrade& trade) {
    const Status& s = app.status;
    TradeMark now;
    now.accuracy = app.findings.accuracy;
    now.place = place_of(app.scene.time, s.dt, trade);
    if (s.stands()) return now;
    if (s.error && s.error->resolved()) now.rate = s.error->rate;
    if (s.clock) now.ms_per_second = 1e3 * s.times_slower();
    return now;
}

void draw_trade(AppState& app, Widgets& widgets) {
    Findings& findings = app.findings;
    const bool has = findings.trade.has_value(), is_of = has && holds_for(findings.trade->scene, app.scene);
    if (has) {
        const MeasuredTrade& trade = *findings.trade;
        if (!is_of) paragraph("The scene has changed since this was measured.");
        const auto clicked = draw_trade_chart(trade, mark_of(app, trade), widgets);
        if (clicked) {
            findings.accuracy.reset();
            app.scene.time = settings_of(trade.points[*clicked].point, app.scene.time);
        }
        paragraph(
            fmt::format("Each flown for {} from t = {} on.", quantity(trade.seconds, "s"), quantity(trade.since, "s")));
    }
    measure_button(app, Subject::trade, is_of ? "Measure anew" : "Measure settings",
                   "Flies the scene for a tenth of a second with every method, many steps and both precisions, and "
                   "compares them with a reference of another method at far smaller steps. It is done beside the flag, "
                   "in some ten seconds of one processor.",
                   widgets);
}

std::string effect_text(const Priced& priced) {
    if (!priced.effect.is_measured) return "\xe2\x80\x93";
    return rounded(1e3 * priced.effect.apart.distance(), 2) + " mm";
}

/// "springs.diagonal_stiffness" for a person, who sees no table: "Diagonal stiffness".
std::string part_name(const ScenePart& part) {
    if (part.key == "flag") return "Fine grid";
    if (part.key == "time.precision") return "Double precision";
    std::string name = part.key;
    for (const std::string_view material : {"springs.", "fabric."})
        if (name.starts_with(material)) name.erase(0, material.size());
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '.' || c == '_'; }, ' ');
    return capitalised(name);
}

std::string tip_of(const Priced& priced, const MeasuredPrices& prices) {
    std::string text = priced.part.label + ".\nIt costs " + percent(priced.cost.own) + " of the time";
    if (priced.effect.is_measured)
        text += fmt::format("; without it masses are {} elsewhere after {} (root mean square)", effect_text(priced),
                            quantity(prices.seconds, "s"));
    text += ".";
    if (!priced.remark.empty()) text += "\n" + as_sentence(priced.remark);
    return text;
}

void draw_price_rows(AppState& app, Widgets& widgets) {
    Findings& findings = app.findings;
    const MeasuredPrices& prices = *findings.prices;
    const bool is_of = are_of(findings, app.scene);
    if (!ImGui::BeginTable("prices", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings)) return;
    ImGui::TableSetupColumn("part", ImGuiTableColumnFlags_WidthStretch);
    for (const char* title : {"part", "cost", "effect"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", title);
    }
    if (!is_of) ImGui::BeginDisabled();
    for (const Priced& priced : prices.parts) {
        const std::string& key = priced.part.key;
        ImGui::TableNextColumn();
        const bool is_missing = findings.missing.contains(key);
        bool on = !findings.left_out.contains(key) && !is_missing;
        if (is_missing) ImGui::BeginDisabled();
        if (widgets.toggle(("Part: " + key).c_str(), on, tip_of(priced, prices).c_str(),
                           part_name(priced.part).c_str())) {
            leave_out(key, !on, app.scene, findings);
        }
        if (is_missing) ImGui::EndDisabled();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(percent(priced.cost.own).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(effect_text(priced).c_str());
    }
    if (!is_of) ImGui::EndDisabled();
    ImGui::EndTable();
}

void draw_prices(AppState& app, Widgets& widgets) {
    Findings& findings = app.findings;
    if (findings.prices) {
        hear_of_scene(findings, app.scene);
        if (!are_of(findings, app.scene)) paragraph("The scene has changed since it was priced.");
        draw_price_rows(app, widgets);
        paragraph(fmt::format(
            "Time saved and change after {} without each part alone, of {} of processor time a second.",
            quantity(findings.prices->seconds, "s"), quantity(1e-3 * findings.prices->ms_per_second, "s", 2)));
    }
    measure_button(
        app, Subject::prices, findings.prices ? "Price anew" : "Price each part",
        "What every part of the scene costs in time and changes in millimetres: the scene is flown with and "
        "without it from the same state. It is done beside the flag, in some fifteen seconds of one processor.",
        widgets);
}

}  // namespace

void draw_trade_page(AppState& app, Widgets& widgets) {
    edit_accuracy(app, widgets);
    ImGui::Spacing();
    draw_trade(app, widgets);
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    draw_prices(app, widgets);
}

}  // namespace drapeau

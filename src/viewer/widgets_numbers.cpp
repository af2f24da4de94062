// Widgets for numbers: sliders, and terms that may be missing.
#include "row_layout.hpp"
#include "widgets.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace drapeau {

namespace {

constexpr double same = 1e-9;  // relative: two numbers a slider cannot tell apart
const std::string how_to_type = "\nA double click on the bar, or a click on the number, lets it be typed.";

std::string digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

bool differ(double a, double b) {
    return std::abs(a - b) > same * std::max(std::abs(a), std::abs(b));
}

std::string in_full(double value, const SliderScale& scale) {
    const std::string unit = unit_of(scale.format);
    return digits(value) + (unit.empty() ? "" : " ") + unit;
}

std::string why_not_taken(const char* label, const BarMemory::NotTaken& typed, double value, const SliderScale& scale) {
    if (typed.number)
        return fmt::format("{} = {}: {} to {} is allowed, {} is taken.", label, in_full(*typed.number, scale),
                           in_full(scale.least.value_or(scale.low), scale),
                           in_full(scale.most.value_or(scale.high), scale), in_full(value, scale));
    const std::string unit = unit_of(scale.format);
    return fmt::format("{} = {}: no number{}; it stays {}.", label, one_line(typed.text, 40),
                       unit.empty() ? "" : " of " + unit, in_full(value, scale));
}

}  // namespace

bool Widgets::bar(const char* label, double& shown, const SliderScale& scale, float width, const char* tip_text,
                  const std::string& noted) {
    BarMemory& bars = memory_.bars;
    ImGui::PushID(label);
    const unsigned id = ImGui::GetID("bar");
    const std::string tip_of_bar = tip_text + how_to_type;
    const auto note_bar = [&] { note(label, noted.empty() ? digits(scale.whole ? std::round(shown) : shown) : noted); };
    bool changed = false;
    if (is_typed(id, {width, ImGui::GetFrameHeight()}, shown, bars)) {
        changed = edit_number(shown, scale, width, bars);
        if (const auto typed = std::exchange(bars.not_taken, std::nullopt))
            correction_ = why_not_taken(label, *typed, shown, scale);
        note_bar();
        ImGui::PopID();
        return changed;
    }
    const auto text = [&] { return number_text(bars.click.bar == id ? bars.click.value : shown, scale.format); };
    const float beside = std::max(number_width(scale.widest), number_width(text().c_str()));
    double waits = 0.0;
    changed = drag_bar(id, shown, scale, std::max(arrow_width(), width - beside - gap_to_number()), bars, waits);
    wait_for(waits);
    note_bar();
    if (!ImGui::IsItemActive()) tip(tip_of_bar.c_str());
    ImGui::SameLine(0.0f, gap_to_number());
    if (draw_number(text(), beside) && !bars.typing.bar) type_number(id, shown, bars);
    note(("Number: " + std::string(label)).c_str(), text());
    tip(tip_of_bar.c_str());
    ImGui::PopID();
    return changed;
}

bool Widgets::slider(const char* label, double& value, const SliderScale& scale, double origin, const char* tip_text) {
    ImGui::PushID(label);
    begin_row(label, true);
    double shown = value * scale.shown_per_unit;
    bool changed = bar(label, shown, scale, control_width(), tip_text);
    if (changed) value = shown / scale.shown_per_unit;
    if (back_arrow(label, differ(value, origin))) {
        value = origin;
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

bool Widgets::slider(const char* label, long long& value, const SliderScale& scale, long long origin,
                     const char* tip_text) {
    ImGui::PushID(label);
    begin_row(label, true);
    double shown = double(value);
    bool changed = bar(label, shown, scale, control_width(), tip_text);
    if (changed) value = std::llround(shown);
    if (shown != double(value)) correction_ = fmt::format("{} is a whole number: {} is taken.", label, value);  // typed
    if (back_arrow(label, value != origin)) {
        value = origin;
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

/// In the place of a bar and its number: what a number that is missing means.
void Widgets::draw_absent(const std::string& text, float width) const {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight(), inset = 0.5f * ImGui::GetStyle().FramePadding.x;
    const float beside = std::max(number_width(SliderScale{}.widest), number_width(text.c_str()));
    const float bar = width - beside - gap_to_number(), half = 0.135f * height, middle = low.y + 0.5f * height;
    ImGui::Dummy({width, height});
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (bar >= height)
        list->AddRectFilled({low.x, middle - half}, {low.x + bar, middle + half},
                            ImGui::GetColorU32(ImGuiCol_FrameBg, 0.6f), half);
    const float left = bar >= height ? low.x + width - beside : low.x;
    list->AddText({left + inset, low.y + ImGui::GetStyle().FramePadding.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                  text.c_str());
}

bool Widgets::term(const char* label, std::optional<double>& value, const SliderScale& scale,
                   const std::optional<double>& origin, double usual, const std::string& absent, const char* tip_text,
                   const char* switch_tip) {
    ImGui::PushID(label);
    begin_row(label, value.has_value());
    bool on = value.has_value();
    bool changed = ImGui::Checkbox("##on", &on);
    note((std::string(label) + " on").c_str(), on ? "1" : "0");
    tip(switch_tip);
    if (changed) value = on ? std::optional(origin.value_or(usual)) : std::nullopt;
    ImGui::SameLine();
    if (value) {
        double shown = *value * scale.shown_per_unit;
        if (bar(label, shown, scale, control_width(), tip_text)) {
            value = shown / scale.shown_per_unit;
            changed = true;
        }
    } else {
        draw_absent(absent, control_width());
        tip(tip_text);
    }
    const bool differs = value.has_value() != origin.has_value() || (value && differ(*value, *origin));
    if (back_arrow(label, differs)) {
        value = origin;
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

}  // namespace drapeau

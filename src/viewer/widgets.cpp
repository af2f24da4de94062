#include "row_layout.hpp"
#include "widgets.hpp"

#include "io/text.hpp"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace drapeau {

namespace {

const ImVec4 amber(1.0f, 0.76f, 0.38f, 1.0f), red(1.0f, 0.52f, 0.46f, 1.0f);  // of text

}  // namespace

Widgets::Widgets(UiMap& map, std::optional<Mark>& mark, WidgetMemory& memory)
    : map_(map), mark_(mark), memory_(memory) {
    begin_bars(memory.bars);
    memory.tip.seen = false;
    memory.due = 0.0;
}

Widgets::~Widgets() {
    if (!memory_.tip.seen) memory_.tip = {};
}

void Widgets::wait_for(double seconds) const {
    if (seconds > 0.0 && (memory_.due <= 0.0 || seconds < memory_.due)) memory_.due = seconds;
}

void Widgets::note_area(const char* label, const ImVec2& low, const ImVec2& high, const std::string& value) {
    if (!map_.wanted() || ImGui::GetCurrentWindowRead()->Hidden) return;  // a box is laid out before it is shown
    const ImVec2 middle((low.x + high.x) / 2.0f, (low.y + high.y) / 2.0f);
    const ImDrawList* list = ImGui::GetWindowDrawList();
    const ImVec2 clip_low = list->GetClipRectMin(), clip_high = list->GetClipRectMax();
    if (middle.x < clip_low.x || middle.y < clip_low.y || middle.x > clip_high.x || middle.y > clip_high.y) return;
    map_.control(label, low.x, low.y, high.x, high.y, value);
}

// A control that was looked for comes into sight and is framed, until the frame fades.
void Widgets::frame_if_marked(const char* label) {
    if (!mark_ || !mark_->means(label)) return;
    if (!mark_->scrolled) ImGui::SetScrollHereY(0.5f);
    constexpr int most_tries = 4;
    mark_->scrolled = mark_->scrolled || ImGui::IsItemVisible() || ++mark_->tries == most_tries;
    if (!mark_->framed) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec4 color = amber;
    color.w = float(std::clamp(mark_->seconds_left, 0.0, 1.0));
    ImGui::GetWindowDrawList()->AddRect(low, high, ImGui::GetColorU32(color), 4.0f, 0, 2.0f);
}

void Widgets::note(const char* label, const std::string& value) {
    frame_if_marked(label);
    note_area(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), value);
}

void Widgets::note_place(const char* label, float x, float y, float radius) {
    note_area(label, {x - radius, y - radius}, {x + radius, y + radius}, "");
}

void Widgets::tip(const char* text) const {
    wait_for(show_tip(text, memory_.tip, map_));
}

void Widgets::begin_row(const char* label, bool bright) {
    ImGui::AlignTextToFramePadding();
    if (bright)
        ImGui::TextUnformatted(label);
    else
        ImGui::TextDisabled("%s", label);
    if (stacks()) return;
    ImGui::SameLine(ImGui::GetWindowContentRegionMin().x +
                    label_share * (ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x));
}

float Widgets::control_width() const {
    return std::max(40.0f, ImGui::GetContentRegionAvail().x - arrow_width() - ImGui::GetStyle().ItemSpacing.x);
}

// A small turning arrow, drawn rather than written, for not every font has one.
bool Widgets::back_arrow(const char* label, bool differs) {
    ImGui::SameLine();
    const float side = arrow_width();
    if (!differs) {
        ImGui::Dummy({side, side});
        return false;
    }
    const bool clicked = ImGui::InvisibleButton("back", {side, side});
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 centre(corner.x + side / 2.0f, corner.y + side / 2.0f);
    const ImU32 color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float r = 0.24f * side, begin = -2.4f, end = 2.3f;
    list->PathArcTo(centre, r, begin, end, 20);
    list->PathStroke(color, 0, 1.6f);
    const ImVec2 head(centre.x + r * std::cos(begin), centre.y + r * std::sin(begin));
    list->AddTriangleFilled({head.x - 0.17f * side, head.y - 0.10f * side},
                            {head.x + 0.14f * side, head.y - 0.13f * side},
                            {head.x - 0.07f * side, head.y + 0.19f * side}, color);
    note((std::string("Back: ") + label).c_str(), "");
    tip("Back to the scene's value.");
    return clicked;
}

bool Widgets::toggle(const char* label, bool& value, const char* tip_text, const char* shown) {
    ImGui::PushID(label);
    const bool changed = ImGui::Checkbox(shown ? shown : label, &value);
    ImGui::PopID();
    note(label, value ? "1" : "0");
    tip(tip_text);
    return changed;
}

bool Widgets::choice(const char* label, int& index, const std::vector<std::string>& names, int origin,
                     const char* tip_text) {
    ImGui::PushID(label);
    begin_row(label, true);
    const bool returns = origin >= 0;
    ImGui::SetNextItemWidth(returns ? control_width() : -1.0f);
    const bool known = index >= 0 && index < int(names.size());
    const int before = index;
    const std::string now = known ? printable(names[std::size_t(index)]) : "";
    const bool listed = ImGui::BeginCombo("##value", now.c_str(), ImGuiComboFlags_HeightLarge);
    if (!listed) {
        note(label, now);
        tip(tip_text);
    } else {
        for (int i = 0; i < int(names.size()); ++i) {
            const std::string name = printable(names[std::size_t(i)]);
            ImGui::PushID(i);
            if (ImGui::Selectable("##entry", i == index)) index = i;
            note((std::string(label) + ": " + name).c_str(), i == index ? "1" : "0");
            ImGui::SameLine(0.0f, 0.0f);
            ImGui::TextUnformatted(name.c_str());  // a Selectable ends its label at ##
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    if (returns && back_arrow(label, index != origin)) index = origin;
    ImGui::PopID();
    return index != before;
}

bool Widgets::text(const char* label, std::string& value, const char* hint, const char* tip_text) {
    ImGui::PushID(label);
    begin_row(label, true);
    ImGui::SetNextItemWidth(-1.0f);
    const bool entered = ImGui::InputTextWithHint("##value", hint, &value, ImGuiInputTextFlags_EnterReturnsTrue);
    note(label, value);
    tip(tip_text);
    ImGui::PopID();
    return entered;
}

bool Widgets::button(const char* label, const char* tip_text, float width, const char* shown) {
    ImGui::PushID(label);
    const bool clicked = ImGui::Button(shown ? shown : label, {width, 0.0f});
    ImGui::PopID();
    note(label, "");
    tip(tip_text);
    const bool found = mark_ && mark_->control == label && std::exchange(mark_->presses, false);
    return clicked || found;
}

bool Widgets::page(const char* label, bool chosen, float width, const char* tip_text) {
    ImGui::PushID("page");  // a switch may have the same label
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(chosen ? ImGuiCol_HeaderActive : ImGuiCol_FrameBg));
    const bool clicked = ImGui::Button(label, {width, 0.0f});
    ImGui::PopStyleColor();
    ImGui::PopID();
    note(("Page: " + std::string(label)).c_str(), chosen ? "1" : "0");
    tip(tip_text);
    return clicked;
}

void Widgets::reading(const char* label, const std::string& value, const char* tip_text, Mood mood) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(reading_column());
    ImGui::PushStyleColor(ImGuiCol_Text, mood == Mood::calm    ? ImGui::GetStyleColorVec4(ImGuiCol_Text)
                                         : mood == Mood::close ? amber
                                                               : red);
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopStyleColor();
    note(("Reading: " + std::string(label)).c_str(), value);
    tip(tip_text);
}

void Widgets::remark(const char* label, const std::string& text, const char* tip_text) {
    ImGui::PushStyleColor(ImGuiCol_Text, amber);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    note(("Reading: " + std::string(label)).c_str(), text);
    tip(tip_text);
}

void Widgets::gauge(const char* label, double share, Mood mood, const std::string& text, const char* tip_text) {
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(reading_column());
    const ImVec4 calm(0.24f, 0.52f, 0.40f, 1.0f), close(0.66f, 0.47f, 0.13f, 1.0f), past(0.72f, 0.22f, 0.20f, 1.0f);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, mood == Mood::bad ? past : mood == Mood::close ? close : calm);
    ImGui::ProgressBar(float(std::clamp(share, 0.0, 1.0)), {-1.0f, ImGui::GetTextLineHeight() + 2.0f}, "");
    ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float smaller = std::min(1.0f, (high.x - low.x - 4.0f) / size.x);  // so that it stays within
    size = {smaller * size.x, smaller * size.y};
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), smaller * ImGui::GetFontSize(),
                                        {(low.x + high.x - size.x) / 2.0f, (low.y + high.y - size.y) / 2.0f},
                                        ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    note(("Reading: " + std::string(label)).c_str(), text);
    tip(tip_text);
}

}  // namespace drapeau

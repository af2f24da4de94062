#include "slider_bar.hpp"

#include "double_press.hpp"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace drapeau {

namespace {

constexpr float drag_pixels = 3.0f;  // window units; a hand that clicks moves by less
constexpr int frames_to_ask = 3;     // until a field that was asked to take the keyboard has it
constexpr int frames_to_give_up = 12;

struct Bar {
    float left, right;  // of the handle's middle, at the ends
    float middle, radius;

    float place(double share) const { return left + float(share) * (right - left); }
    double share(float x) const { return double(x - left) / double(std::max(1.0f, right - left)); }
};

Bar bar_of_item() {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float radius = 0.30f * (high.y - low.y);
    return {low.x + radius, high.x - radius, 0.5f * (low.y + high.y), radius};
}

void draw_handle(const Bar& bar, double share) {
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float half = 0.45f * bar.radius, x = bar.place(share);
    const auto line = [&](float from, float to, ImGuiCol color) {
        list->AddRectFilled({from, bar.middle - half}, {to, bar.middle + half}, ImGui::GetColorU32(color), half);
    };
    line(bar.left - bar.radius, bar.right + bar.radius, hovered || active ? ImGuiCol_FrameBgActive : ImGuiCol_FrameBg);
    line(bar.left - bar.radius, x, ImGuiCol_HeaderActive);
    list->AddCircleFilled({x, bar.middle}, bar.radius,
                          ImGui::GetColorU32(active || hovered ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab), 24);
}

void begin_click(unsigned id, const Bar& bar, double value, const SliderScale& scale, BarMemory& memory) {
    const float x = ImGui::GetIO().MousePos.x, off = x - bar.place(share_of(value, scale));
    const bool on_handle = std::abs(off) <= bar.radius + 1.0f;
    memory.click = {id, value, ImGui::GetTime(), x, on_handle ? off : 0.0f, on_handle};
}

/// ImGui 1.87 and later take what happened within a frame one by one, over several.
bool mouse_is_settled() {
#if IMGUI_VERSION_NUM >= 18700
    for (const ImGuiInputEvent& event : ImGui::GetCurrentContext()->InputEventsQueue)
        if (event.Type == ImGuiInputEventType_MouseButton || event.Type == ImGuiInputEventType_MousePos) return false;
#endif
    return !ImGui::IsMouseDown(0);
}

/// ImGui 1.89 and later complete a text by Tab alone.
bool is_tab_back() {
#if IMGUI_VERSION_NUM >= 18900
    return ImGui::GetIO().KeyShift && ImGui::IsKeyPressed(ImGuiKey_Tab, false);
#else
    return false;
#endif
}

bool is_disabled() {
    return (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
}

std::string in_digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// Takes Tab; a decimal comma is a point.
int on_typing(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
        static_cast<BarMemory::Typing*>(data->UserData)->goes_on = true;
        return 0;
    }
    if (data->EventChar == ',') data->EventChar = '.';
    return 0;
}

}  // namespace

void begin_bars(BarMemory& memory) {
    BarMemory::Typing& typing = memory.typing;
    if (!typing.seen) typing = {};
    typing.seen = false;
    memory.drawn = 0;
}

void type_number(unsigned id, double value, BarMemory& memory) {
    memory.click = {};
    memory.typing = {};
    memory.typing.bar = id;
    memory.typing.text = memory.typing.first_text = in_digits(value);
    memory.typing.seen = true;
}

bool is_typed(unsigned id, glm::vec2 size, double value, BarMemory& memory) {
    BarMemory::Typing& typing = memory.typing;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImRect whole(low.x, low.y, low.x + size.x, low.y + size.y);
    const auto twice = memory.pressed_twice;
    if (is_disabled()) return false;
    const unsigned before = std::exchange(memory.drawn, id);
    const bool is_next = typing.goes_to ? typing.goes_to == id : typing.goes_on;
    if (!typing.bar && is_next) {
        type_number(id, value, memory);
    } else if (twice && whole.Contains({twice->x, twice->y}) && typing.bar != id &&
               ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
        type_number(id, value, memory);
    }
    if (typing.bar != id) return false;
    typing.seen = true;
    typing.before = before;
    if (!typing.open && mouse_is_settled()) typing.open = true;
    return typing.open;
}

namespace {

/// What the bar that was pressed shows now; it is the value too once it is no first click of two.
double follow_click(const Bar& bar, double& value, const SliderScale& scale, BarMemory& memory, double& waits) {
    BarMemory::Click& click = memory.click;
    const bool active = ImGui::IsItemActive();
    if (!active && (click.live || click.on_handle)) {  // it is over
        click = {};
        return value;
    }
    const float x = ImGui::GetIO().MousePos.x;
    const double left = click.begun + DoublePress::seconds - ImGui::GetTime();
    const bool moved = active && std::abs(x - click.pressed_x) > drag_pixels;
    if (moved || (active && !click.on_handle && (scale.at_once || left <= 0.0))) click.live = true;
    if (click.on_handle && !click.live) return value;
    if (active) click.value = value_at(bar.share(x - click.grip), scale);
    const double shown = click.value;
    const bool pressed_elsewhere = ImGui::IsMouseClicked(0) && !ImGui::IsItemActivated();
    const bool sets = click.live || left <= 0.0 || pressed_elsewhere;
    if (sets) value = shown;
    if (sets && !active) click = {};
    if (!sets) waits = left;
    return shown;
}

}  // namespace

bool drag_bar(unsigned id, double& value, const SliderScale& scale, float width, BarMemory& memory, double& waits) {
    BarMemory::Click& click = memory.click;
    ImGui::InvisibleButton("bar", {width, ImGui::GetFrameHeight()});
    const Bar bar = bar_of_item();
    const double before = value;
    waits = 0.0;
    if (ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl) type_number(id, value, memory);
    const bool is_typed = memory.typing.bar == id;
    if (ImGui::IsItemActivated() && !is_typed) begin_click(id, bar, value, scale, memory);
    const double shown = click.bar == id ? follow_click(bar, value, scale, memory, waits) : value;
    draw_handle(bar, share_of(shown, scale));
    return value != before;
}

bool draw_number(const std::string& text, float width) {
    const bool clicked = ImGui::InvisibleButton("number", {width, ImGui::GetFrameHeight()});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImGuiStyle& style = ImGui::GetStyle();
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) {
        list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), style.FrameRounding);
        ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    }
    list->AddText({low.x + 0.5f * style.FramePadding.x, low.y + style.FramePadding.y},
                  ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    return clicked;
}

bool edit_number(double& value, const SliderScale& scale, float width, BarMemory& memory) {
    BarMemory::Typing& typing = memory.typing;
    if (!typing.active && typing.frames++ % frames_to_ask == 0) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(width);
    ImGui::InputText("##typed", &typing.text,
                     ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackCharFilter |
                         ImGuiInputTextFlags_CallbackCompletion,
                     on_typing, &typing);
    const double before = value;
    const auto twice = memory.pressed_twice;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGuiInputTextState* field = ImGui::GetInputTextState(ImGui::GetItemID());
    if (field && twice && ImRect(low, high).Contains({twice->x, twice->y})) field->SelectAll();
    const std::string unit = unit_of(scale.format);
    const ImVec2 extent = ImGui::CalcTextSize(unit.c_str()), padding = ImGui::GetStyle().FramePadding;
    ImGui::GetWindowDrawList()->AddText({high.x - padding.x - extent.x, low.y + padding.y},
                                        ImGui::GetColorU32(ImGuiCol_TextDisabled), unit.c_str());
    const bool was_active = typing.active;
    if (was_active && is_tab_back()) typing.goes_on = true;
    typing.active = ImGui::IsItemActive();
    const bool ends = (was_active && !typing.active) || typing.goes_on || typing.frames > frames_to_give_up;
    if (ends) {
        if (typing.active) ImGui::ClearActiveID();
        // Escape brings the first text back.
        if (!typing.text.empty() && typing.text != typing.first_text) {
            const auto number = typed_number(typing.text, unit);
            if (number) value = std::clamp(*number, scale.least.value_or(scale.low), scale.most.value_or(scale.high));
            if (value != number) memory.not_taken = {typing.text, number};
        }
        const bool goes_on = typing.goes_on, back = goes_on && ImGui::GetIO().KeyShift;
        const unsigned goes_to = back ? typing.before : 0;
        typing = {};
        typing.goes_on = typing.seen = goes_on && (!back || goes_to);
        typing.goes_to = goes_to;
    }
    return value != before;
}

}  // namespace drapeau

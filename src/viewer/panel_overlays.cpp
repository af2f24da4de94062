// What lies over the picture: the message, the list of keys, a question.
#include "panels.hpp"

#include "actions.hpp"
#include "box_room.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size

constexpr ImGuiWindowFlags box_flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

constexpr const char* mouse[][2] = {{"Left drag", "turn"},
                                    {"Right drag", "move"},
                                    {"Shift drag", "take hold of the cloth, and pull"},
                                    {"Click", "read a mass or a spring"},
                                    {"Wheel", "closer, further"},
                                    {"Double click", "the first view"},
                                    {"Drop a file", "an image or a scene"}};

struct KeyLine {
    std::string key, does;
};

/// A line for each key; actions that share one stand together in the table.
std::vector<KeyLine> key_lines() {
    std::vector<KeyLine> lines;
    for (const auto& [way, does] : mouse) lines.push_back({way, does});
    for (const Action& action : actions()) {
        if (action.key.empty() || action.key == lines.back().key) continue;
        lines.push_back({action.key, action.together.empty() ? action.does : action.together});
    }
    return lines;
}

/// Lines below each other, keys and what they do, no further than `right` within the window; -1: however far.
void draw_lines(std::span<const KeyLine> lines, float right) {
    const float gap = 2.0f * ImGui::GetStyle().WindowPadding.x;
    float second = 0.0f;
    for (const KeyLine& line : lines) second = std::max(second, ImGui::CalcTextSize(line.key.c_str()).x + gap);
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(right);
    for (const KeyLine& line : lines) {
        ImGui::TextUnformatted(line.key.c_str());
        ImGui::SameLine(second);
        ImGui::TextDisabled("%s", line.does.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
}

/// In two columns where there is room for them.
void draw_keys(float room) {
    const std::vector<KeyLine> lines = key_lines();
    const std::span<const KeyLine> all(lines);
    const std::size_t half = room > 55.0f * ImGui::GetFontSize() ? (lines.size() + 1) / 2 : lines.size();
    const ImGuiStyle& style = ImGui::GetStyle();
    const bool one_column = half == lines.size();
    draw_lines(all.first(half), one_column ? room - style.WindowPadding.x - style.ScrollbarSize : -1.0f);
    if (one_column) return;
    ImGui::SameLine(0.0f, 2.0f * ImGui::GetStyle().WindowPadding.x);
    draw_lines(all.subspan(half), -1.0f);
}

Area claim_window(AppState& app) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    return app.claimed.emplace_back(Area{low.x, low.y, low.x + size.x, low.y + size.y});
}

/// In the middle of the view, below the button that opens the panel.
void place_at_top(const AppState& app) {
    const float middle = (app.view_area.x0 + app.view_area.x1) / 2.0f;
    const float button = app.opener_shown() ? ImGui::GetFrameHeight() + ImGui::GetStyle().WindowPadding.y : 0.0f;
    ImGui::SetNextWindowPos({middle, app.view_area.y0 + button + 14.0f}, ImGuiCond_Always, {0.5f, 0.0f});
}

/// Why the run stands, in a few words.
std::string stopped_because(const Status& status) {
    if (!status.divergence) return "Stopped: the simulation could not go on";
    const Divergence& divergence = *status.divergence;
    const std::string when = "Stopped at t = " + quantity(divergence.time, "s", 3) + ": ";
    switch (divergence.cause) {
        case Divergence::Cause::past_the_limit:
            return when + "the step is above the stability limit";
        case Divergence::Cause::energy_created:
            return when + "the step created energy";
        case Divergence::Cause::too_soft:
            return when + "the step made springs too soft";
        case Divergence::Cause::energy_lost:
            return when + "the step lost energy";
        case Divergence::Cause::float_rounding:
            return when + "the step is too small for float";
        case Divergence::Cause::beyond_precision:
            break;
    }
    return when + "forces beyond the precision";
}

/// In the place of a closed message, as long as the run stands.
void draw_standstill(AppState& app, Widgets& widgets) {
    place_at_top(app);
    ImGui::Begin("standstill", nullptr, box_flags);
    if (widgets.button("Stopped", "Opens the message that says why the run stopped, and what helps.", 0.0f,
                       stopped_because(app.status).c_str()))
        say_why_it_stands(app);
    app.message_area = claim_window(app);
    ImGui::End();
}

}  // namespace

void draw_message(AppState& app, Widgets& widgets) {
    Message& message = app.message;
    if (message.text.empty()) {
        if (app.status.stands()) draw_standstill(app, widgets);
        return;
    }
    const float scale = ImGui::GetFontSize() / usual_font;
    const float width = std::min(620.0f * scale, app.view_area.width() - 24.0f * scale);
    place_at_top(app);
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, 1e4f});
    ImGui::Begin("message", nullptr, box_flags);
    const ImVec4 color = message.trouble ? ImVec4(1.0f, 0.72f, 0.45f, 1.0f) : ImVec4(0.66f, 0.90f, 0.72f, 1.0f);
    ImGui::PushTextWrapPos(width - 30.0f * scale);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(message.shown().c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    const auto& divergence = app.status.divergence;
    if (message.cause == Message::Cause::standstill && divergence && divergence->safe_dt > 0.0) {
        const std::string tip = "Sets the step to " + quantity(divergence->safe_dt, "s") +
                                ", which was tried from the last good state and held, and goes on there.";
        if (widgets.button("Use the safe step", tip.c_str())) app.commands.use_safe_step = true;
        ImGui::SameLine();
    }
    const bool closed = widgets.button("Close", "Key Esc");
    app.message_area = claim_window(app);
    ImGui::End();
    if (message.seconds_left > 0.0) {
        message.seconds_left -= double(ImGui::GetIO().DeltaTime);
        if (message.seconds_left <= 0.0) message.text.clear();
    }
    if (closed) message.text.clear();
}

void draw_question(AppState& app, Widgets& widgets) {
    if (!app.question) return;
    const Area& view = app.view_area;
    const float scale = ImGui::GetFontSize() / usual_font;
    const float width = std::min(520.0f * scale, view.width() - 24.0f * scale);
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, (view.y0 + view.y1) / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, 1e4f});
    ImGui::Begin("question", nullptr, box_flags);
    ImGui::PushTextWrapPos(width - 30.0f * scale);
    ImGui::TextUnformatted(printable(app.question->text).c_str());
    ImGui::PopTextWrapPos();
    const Question& question = *app.question;
    const bool agreed = widgets.button(question.answer.c_str(), (question.tip + " Key Enter").c_str(), 0.0f,
                                       (question.answer + " (Enter)").c_str());
    ImGui::SameLine();
    const bool declined = widgets.button("Cancel", "Everything stays as it is. Key Esc", 0.0f, "Cancel (Esc)");
    claim_window(app);
    ImGui::End();
    if (agreed) agree(app);
    if (declined) app.question.reset();
}

void draw_activity(const AppState& app) {
    const Status& status = app.status;
    std::string text;
    if (!status.loading.empty()) text = "Loading " + printable(status.loading) + "...";
    if (status.settling) text += std::string(text.empty() ? "" : "\n") + "Settling...";
    if (text.empty()) return;
    const Area& view = app.view_area;
    const float line = ImGui::GetTextLineHeight();  // above the legends
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, view.y1 - 6.0f * line}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::Begin("activity", nullptr, box_flags | ImGuiWindowFlags_NoInputs);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

void draw_help(AppState& app, Widgets& widgets) {
    if (!app.help_shown) return;
    const Area view = room_for_box(app, 34.0f * ImGui::GetFontSize());
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, (view.y0 + view.y1) / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {view.width(), view.height()});  // scrolls where it is cut off
    ImGui::Begin("keys", nullptr, box_flags);
    draw_keys(view.width());
    ImGui::Spacing();
    if (widgets.button("Close keys", "Key Esc")) app.help_shown = false;
    claim_window(app);
    ImGui::End();
}

}  // namespace drapeau

#include "row_layout.hpp"

#include "slider_scale.hpp"

#include <imgui.h>

namespace drapeau {

namespace {

constexpr float shortest_bar = 2.4f;  // lines of text

}  // namespace

float arrow_width() {
    return ImGui::GetFrameHeight();
}

float gap_to_number() {
    return ImGui::GetStyle().ItemInnerSpacing.x;
}

float number_width(const char* widest) {
    return ImGui::CalcTextSize(widest).x + ImGui::GetStyle().FramePadding.x;
}

bool stacks() {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const float bar = (1.0f - label_share) * width - 2.0f * (arrow_width() + style.ItemSpacing.x) - gap_to_number() -
                      number_width(SliderScale{}.widest);
    return bar < shortest_bar * ImGui::GetFontSize();
}

float reading_column() {
    const float left = ImGui::GetWindowContentRegionMin().x, width = ImGui::GetWindowContentRegionMax().x - left;
    if (stacks()) return left + ImGui::CalcTextSize("Reference").x + ImGui::GetStyle().ItemSpacing.x;
    return left + label_share * width;
}

}  // namespace drapeau

#include "layout.hpp"

#include <algorithm>

namespace drapeau {

namespace {

constexpr float margin = 12.0f;                                   // window units around the panel
constexpr float widest_panel = 384.0f, narrowest_panel = 280.0f;  // window units; narrower cuts off its labels
constexpr float opened_share = 0.62f;                             // of a narrow window

}  // namespace

void lay_out(AppState& app, float width, float height, float scale) {
    const float gap = margin * scale, half = 0.5f * width - gap;
    app.panel_area = {};
    app.view_area = {0.0f, 0.0f, width, height};
    app.narrow = half < narrowest_panel * scale;
    if (!app.panel_open()) return;
    const float panel = std::min(widest_panel * scale, app.narrow ? opened_share * width - gap : half);
    app.panel_area = {gap, gap, gap + panel, height - gap};
    app.view_area.x0 = app.panel_area.x1;
}

}  // namespace drapeau

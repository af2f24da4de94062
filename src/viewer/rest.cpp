#include "rest.hpp"

#include <algorithm>

namespace drapeau {

namespace {

constexpr int settling_frames = 4;      // ImGui lays out a new box over several
constexpr double longest = 60.0;        // s
constexpr double hidden_seconds = 0.1;  // s between the requests of batches that nobody sees
constexpr double cursor_seconds = 0.2;  // s; it blinks more slowly
constexpr double past_message = 0.01;   // s; so that the next frame finds it expired

}  // namespace

double Rest::seconds(const Activity& activity) {
    if (activity.hidden && activity.runs) return hidden_seconds;
    const bool message_gone = message_left_ > 0.0 && activity.message_left <= 0.0;
    const bool panel_changed = panel_left_ > 0.0 && activity.panel_left <= 0.0;
    message_left_ = activity.message_left;
    panel_left_ = activity.panel_left;
    if (activity.events || activity.runs || activity.simulation || message_gone || panel_changed)
        settling_ = settling_frames;
    if (settling_ > 0) {
        --settling_;
        return 0.0;
    }
    double wait = activity.typing ? cursor_seconds : longest;
    for (const double left : {activity.message_left, activity.panel_left})
        if (left > 0.0) wait = std::min(wait, left + past_message);
    return wait;
}

}  // namespace drapeau

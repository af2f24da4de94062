#include "key_feed.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace drapeau {

#if IMGUI_VERSION_NUM < 18700

namespace {

using Kind = InputEvent::Kind;

bool is_modifier(int code) {
    return code >= GLFW_KEY_LEFT_SHIFT && code <= GLFW_KEY_RIGHT_SUPER;
}

bool is_control(int code) {
    return code == GLFW_KEY_LEFT_CONTROL || code == GLFW_KEY_RIGHT_CONTROL;
}

bool is_of_keyboard(const InputEvent& event) {
    const bool key = event.kind == Kind::key || event.kind == Kind::key_up;
    return event.kind == Kind::character || (key && event.code >= 0 && event.code < GLFW_KEY_LAST);
}

}  // namespace

void KeyFeed::new_frame(const std::vector<InputEvent>& events, bool keeps) {
    feed(events, keeps);
    ImGui::NewFrame();
}

// A press may open a field, and so may letting go: what comes after it waits for a frame.
void KeyFeed::feed(const std::vector<InputEvent>& events, bool keeps) {
    const auto is_press = [](const InputEvent& event) { return event.kind == Kind::press; };
    const auto take = [this](auto from, auto to) {
        std::copy_if(from, to, std::back_inserter(waiting_), is_of_keyboard);
    };
    const auto first = std::find_if(events.begin(), events.end(), is_press);
    const auto behind_last = std::find_if(events.rbegin(), events.rend(), is_press).base();
    take(events.begin(), first);
    const bool was_down = ImGui::GetIO().MouseDownDuration[0] >= 0.0f;
    give(keeps || was_down);
    if (first == events.end()) return;
    take(first, behind_last);
    drop(waiting_.size());
    take(behind_last, events.end());
}

void KeyFeed::drop(std::size_t count) {
    for (; count > 0; --count, waiting_.pop_front()) {
        const InputEvent& event = waiting_.front();
        if (event.kind == Kind::key_up) down_.erase(event.code);
        if (event.kind == Kind::key && is_modifier(event.code)) down_.insert(event.code);
        if (event.kind == Kind::character) dropped_ = true;
    }
}

// A frame takes characters and then one key: ImGui types first and knows no order among keys. What is pressed stays
// down for a frame, and the modifiers with it; what is let go stays up for one.
void KeyFeed::give(bool keeps) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClearInputCharacters();
    if (keeps) return;
    bool typed = false;
    int pressed = GLFW_KEY_UNKNOWN;  // the one key
    std::set<int> released;
    for (; !waiting_.empty(); waiting_.pop_front()) {
        const InputEvent& event = waiting_.front();
        const bool acted = pressed != GLFW_KEY_UNKNOWN;
        if (event.kind == Kind::character) {
            if (acted) break;
            io.AddInputCharacter(event.typed);
            typed = true;
            continue;
        }
        if (is_modifier(event.code) ? acted || (typed && is_control(event.code)) : event.code == pressed) break;
        if (event.kind == Kind::key_up) {
            down_.erase(event.code);
            released.insert(event.code);
            continue;
        }
        // A key that types is what it types.
        if (waiting_.size() > 1 && waiting_[1].kind == Kind::character) continue;
        if (released.contains(event.code) || (!is_modifier(event.code) && acted)) break;
        down_.insert(event.code);
        if (!is_modifier(event.code)) pressed = event.code;
    }
    const auto holds = [this](int left, int right) { return down_.contains(left) || down_.contains(right); };
    for (int code = 0; code < GLFW_KEY_LAST; ++code) io.KeysDown[code] = down_.contains(code);
    io.KeyCtrl = holds(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = holds(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = holds(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = holds(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

bool KeyFeed::has_waiting() const {
    return !waiting_.empty();
}

#else

// Back in the queue after the frame, keys keep their order, and ImGui compares the next one with them.
void KeyFeed::new_frame(const std::vector<InputEvent>&, bool keeps) {
    auto& queue = ImGui::GetCurrentContext()->InputEventsQueue;
    const auto is_of_mouse = [](const ImGuiInputEvent& event) {
        return event.Type != ImGuiInputEventType_Key && event.Type != ImGuiInputEventType_Text;
    };
    std::vector<ImGuiInputEvent> kept;
    if (keeps) {
        const auto is_press = [](const ImGuiInputEvent& event) {
            return event.Type == ImGuiInputEventType_MouseButton && event.MouseButton.Down;
        };
        const auto is_text = [](const ImGuiInputEvent& event) { return event.Type == ImGuiInputEventType_Text; };
        const int pressed_at = int(
            std::find_if(std::reverse_iterator(queue.end()), std::reverse_iterator(queue.begin()), is_press).base() -
            queue.begin());
        for (int i = pressed_at; i-- > 0;)
            if (is_text(queue[i])) {
                queue.erase(&queue[i]);
                dropped_ = true;
            }
        const auto keys = std::stable_partition(queue.begin(), queue.end(), is_of_mouse);
        kept.assign(keys, queue.end());
        queue.resize(int(keys - queue.begin()));
    }
    ImGui::NewFrame();
    for (const ImGuiInputEvent& event : kept) queue.push_back(event);
}

bool KeyFeed::has_waiting() const {
    return !ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

#endif

}  // namespace drapeau

// Widgets: the panel's controls. Each has a label, a unit, a tooltip that says what raising it does, an arrow back to
// its default where it differs from it, and a line in the UI map.
#pragma once

#include "palette.hpp"
#include "slider_bar.hpp"
#include "tips.hpp"
#include "ui_map.hpp"

#include <optional>
#include <string>
#include <vector>

struct ImVec2;

namespace drapeau {

/// What the controls remember between frames.
struct WidgetMemory {
    BarMemory bars;
    TipMemory tip;
    double due = 0.0;  // s until they change by themselves; 0: they do not
};

class Widgets {
public:
    static constexpr const char* usual_switch_tip = "On or off. What is off is not computed and costs nothing.";

    /// `mark`: the control that is framed, if one is.
    Widgets(UiMap& map, std::optional<Mark>& mark, WidgetMemory& memory);
    ~Widgets();

    bool slider(const char* label, double& value, const SliderScale& scale, double origin, const char* tip);
    bool slider(const char* label, long long& value, const SliderScale& whole, long long origin, const char* tip);

    /// The bar and its number alone, of a width in all. `noted`: what the UI map says of it; "" for its number.
    bool bar(const char* label, double& shown, const SliderScale& scale, float width, const char* tip,
             const std::string& noted = "");

    /// A number that may be missing: a switch and a slider, or the word `absent`. Switched on, it is `origin` or else
    /// `usual`. `switch_tip`: of the switch.
    bool term(const char* label, std::optional<double>& value, const SliderScale& scale,
              const std::optional<double>& origin, double usual, const std::string& absent, const char* tip,
              const char* switch_tip = usual_switch_tip);

    /// `shown`: what stands beside it instead of its label.
    bool toggle(const char* label, bool& value, const char* tip, const char* shown = nullptr);
    bool choice(const char* label, int& index, const std::vector<std::string>& names, int origin, const char* tip);
    bool text(const char* label, std::string& value, const char* hint, const char* tip);
    bool button(const char* label, const char* tip, float width = 0.0f, const char* shown = nullptr);
    bool page(const char* label, bool chosen, float width, const char* tip);

    enum class Mood { calm, close, bad };  // of a reading: plain or green, amber, red
    void reading(const char* label, const std::string& value, const char* tip, Mood mood = Mood::calm);
    void gauge(const char* label, double share, Mood mood, const std::string& text, const char* tip);
    /// A sentence over the panel's width, in amber.
    void remark(const char* label, const std::string& text, const char* tip);

    /// Notes the last item of ImGui in the UI map if its middle can be seen.
    void note(const char* label, const std::string& value);
    /// The same for a place within the last item that can be clicked on its own.
    void note_place(const char* label, float x, float y, float radius);
    UiMap& map() { return map_; }
    void tip(const char* text) const;  // of the last item of ImGui, once the mouse rests on it

    /// What was made of a number that could not be taken as it was typed; empty if all could.
    const std::string& correction() const { return correction_; }

private:
    void note_area(const char* label, const ImVec2& low, const ImVec2& high, const std::string& value);
    void begin_row(const char* label, bool bright);
    void wait_for(double seconds) const;
    void draw_absent(const std::string& text, float width) const;
    float control_width() const;
    bool back_arrow(const char* label, bool differs);
    void frame_if_marked(const char* label);  // the last item

    UiMap& map_;
    std::optional<Mark>& mark_;
    WidgetMemory& memory_;
    std::string correction_;
};

}  // namespace drapeau

#include "setting_controls.hpp"

namespace drapeau {

std::string tip_of(std::string_view table, std::string_view key, const settings::About& about) {
    return as_sentence(about.help) + " " + as_sentence(about.tip) + "\n" + settings::full_name(table, key);
}

SliderScale scale_of(const settings::About& about, const settings::Control& control, const settings::Range& allowed) {
    const std::string_view unit = control.unit.empty() ? about.unit : control.unit;
    std::string format(control.number);
    if (!unit.empty()) format.append(" ").append(unit == "%" ? "%%" : unit);
    SliderScale scale{control.range.lowest, control.range.highest, control.logarithmic, format, control.shown_per_unit};
    scale.least = control.shown_per_unit * allowed.lowest, scale.most = control.shown_per_unit * allowed.highest;
    return scale;
}

bool switch_table(Widgets& widgets, std::string_view name, std::string_view remark, bool on) {
    const std::string label = capitalised(name);
    const std::string tip = label + " on or off. What is off is not computed and costs nothing. " + std::string(remark);
    return widgets.toggle(label.c_str(), on, tip.c_str());
}

}  // namespace drapeau

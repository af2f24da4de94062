// Controls of settings, made from their rows in the table of settings: label, ends, unit and tooltip stand there.
#pragma once

#include "scene/settings.hpp"
#include "widgets.hpp"

#include <algorithm>
#include <concepts>
#include <string>
#include <tuple>
#include <utility>

namespace drapeau {

/// What a control says when the mouse rests on it.
std::string tip_of(std::string_view table, std::string_view key, const settings::About& about);

/// The slider of a number; what is in `allowed` may be typed.
SliderScale scale_of(const settings::About& about, const settings::Control& control, const settings::Range& allowed);

/// The switch of a term: whether it was clicked.
bool switch_table(Widgets& widgets, std::string_view name, std::string_view remark, bool on);

// One control for each type of value. Each gives whether the value was changed; `origin` is what its arrow goes back
// to.

template <class Field>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, double& value, const double& origin) {
    return widgets.slider(field.about.label, value, scale_of(field.about, field.control, field.range), origin,
                          tip.c_str());
}

template <class Field>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, std::optional<double>& value,
          const std::optional<double>& origin) {
    const std::string absent = field.absent.empty() ? "not modelled" : std::string(field.absent);
    const char* switch_tip = absent == "auto" ? "On: fixed by you. Off: automatic." : Widgets::usual_switch_tip;
    return widgets.term(field.about.label, value, scale_of(field.about, field.control, field.range), origin,
                        field.control.usual, absent, tip.c_str(), switch_tip);
}

template <class Field, std::integral Whole>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, Whole& value, const Whole& origin) {
    SliderScale scale = scale_of(field.about, field.control, field.range);
    constexpr double most_typed = 9007199254740992.0;  // up to 2^53 a double holds every whole number
    scale.format = "%.0f", scale.whole = true, scale.most = std::min(*scale.most, most_typed);
    auto shown = static_cast<long long>(value);  // a seed may be greater than an int
    if (!widgets.slider(field.about.label, shown, scale, static_cast<long long>(origin), tip.c_str())) return false;
    value = static_cast<Whole>(shown);
    return true;
}

template <class Field>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, bool& value, const bool&) {
    return widgets.toggle(field.about.label, value, tip.c_str());
}

template <class Field, class Enum>
requires std::is_enum_v<Enum>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, Enum& value, const Enum& origin) {
    const auto words = settings::names_of(value);
    int index = static_cast<int>(value);
    if (!widgets.choice(field.about.label, index, {words.begin(), words.end()}, static_cast<int>(origin), tip.c_str()))
        return false;
    value = static_cast<Enum>(index);
    return true;
}

template <class Field>
bool edit(Widgets& widgets, const Field& field, const std::string& tip, glm::dvec3& value, const glm::dvec3& origin) {
    bool changed = false;
    const SliderScale scale = scale_of(field.about, field.control, field.range);
    for (const auto& [axis, name] : {std::pair{0, " along"}, {1, " up"}, {2, " across"}})
        changed |= widgets.slider((std::string(field.about.label) + name).c_str(), value[axis], scale, origin[axis],
                                  tip.c_str());
    return changed;
}

/// A text has no control of its own: what it names is chosen.
template <class Field>
bool edit(Widgets&, const Field&, const std::string&, std::string&, const std::string&) {
    return false;
}

/// The control of one setting.
template <class Settings, class Value>
bool edit(Widgets& widgets, std::string_view table, const settings::Key<Settings, Value>& field, Settings& settings,
          const Settings& origin) {
    return edit(widgets, field, tip_of(table, field.key, field.about), settings.*field.member, origin.*field.member);
}

/// The controls of a term's or limit's table: a switch, and its settings while it is on; of a table with one number,
/// both in a row. Switched on it is as in `origin`, or else `listed_anew`.
template <class Term>
void edit_table(Widgets& widgets, std::optional<Term>& term, const std::optional<Term>& origin,
                const Term& listed_anew = {}) {
    constexpr auto& keys = settings::keys_of<Term>;
    const auto& first = std::get<0>(keys);
    if constexpr (std::tuple_size_v<std::decay_t<decltype(keys)>> == 1 && requires { double{Term{}.*first.member}; }) {
        const auto value_of = [&](const auto& t) { return t ? std::optional(*t.*first.member) : std::nullopt; };
        auto value = value_of(term);
        const auto tip = tip_of(Term::table, first.key, first.about);
        if (!widgets.term(first.about.label, value, scale_of(first.about, first.control, first.range), value_of(origin),
                          Term{}.*first.member, "not modelled", tip.c_str()))
            return;
        if (!value) return term.reset();
        if (!term) term.emplace();
        *term.*first.member = *value;
    } else {
        const Term usual = origin.value_or(listed_anew);
        if (switch_table(widgets, Term::name, settings::remark_on<Term>, term.has_value())) {
            term = term ? std::nullopt : std::optional(usual);
        }
        if (!term) return;
        settings::each_key(keys, [&](const auto& field) { edit(widgets, Term::table, field, *term, usual); });
    }
}

/// The row of a key, by its member.
template <class Settings, class Value, class Keys>
constexpr settings::Key<Settings, Value> row_of(Value Settings::*member, const Keys& keys) {
    settings::Key<Settings, Value> found{};
    settings::each_key(keys, [&]<class S, class V>(const settings::Key<S, V>& field) {
        if constexpr (std::is_same_v<V, Value>)
            if (field.member == member) found = field;
    });
    return found;
}

}  // namespace drapeau

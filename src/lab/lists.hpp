// Lists: what the laboratory's options say as lists and numbers, with one way to refuse what they may not be.
#pragma once

#include "io/error.hpp"
#include "io/text.hpp"
#include "scene/setting.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau::lab {

/// Throws InputError: "--dt = soon: a number is allowed".
[[noreturn]] inline void refuse(const std::string& option, const std::string& text, const std::string& allowed) {
    throw InputError(option + " = " + (text.empty() ? "(nothing)" : one_line(text, 60)) + ": " + allowed +
                     " is allowed");
}

/// What stands between commas, without the space around it; of no text nothing.
inline std::vector<std::string> items_of(const std::string& list) {
    std::vector<std::string> items;
    for (std::size_t from = 0; !list.empty() && from <= list.size();) {
        const std::size_t to = std::min(list.find(',', from), list.size());
        items.emplace_back(without_space(std::string_view(list).substr(from, to - from)));
        from = to + 1;
    }
    return items;
}

/// A number of `unit` in the range. Throws InputError.
inline double number_option(const std::string& option, const std::string& text, const settings::Range& range,
                            const std::string& unit) {
    const auto number = number_in(without_space(text));
    if (number && range.contains(*number)) return *number;
    refuse(option, text, "a number of " + unit + settings::range_text(range));
}

/// The values that a list names, none twice. Throws InputError.
template <class Enum>
std::vector<Enum> names_option(const std::string& option, const std::string& list,
                               std::span<const std::string_view> names) {
    std::vector<Enum> chosen;
    for (const std::string& item : items_of(list)) {
        const auto found = std::find(names.begin(), names.end(), item);
        if (found == names.end()) refuse(option, item, choices(names));
        const auto value = static_cast<Enum>(found - names.begin());
        if (std::find(chosen.begin(), chosen.end(), value) == chosen.end()) chosen.push_back(value);
    }
    return chosen;
}

}  // namespace drapeau::lab

#include "keyboard.hpp"

#include <algorithm>

namespace drapeau {

namespace {

bool is_latin(const std::string& types) {
    return types.size() == 1 && ((types[0] >= 'a' && types[0] <= 'z') || (types[0] >= 'A' && types[0] <= 'Z'));
}

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
}

}  // namespace

char shortcut_letter(const std::string& types, char us_letter, const std::vector<std::string>& layout) {
    if (is_latin(types)) return lower(types[0]);
    const auto is_it = [&](const std::string& other) { return is_latin(other) && lower(other[0]) == us_letter; };
    return std::any_of(layout.begin(), layout.end(), is_it) ? '\0' : us_letter;
}

}  // namespace drapeau

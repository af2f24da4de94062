#include "scene_difference.hpp"

#include "io/text.hpp"
#include "scene/settings.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace drapeau {

namespace {

using namespace settings;

struct Said {
    std::string label, value;
};
using Table = std::map<std::string, Said>;  // by key

std::map<std::string, Table> tables_of(const Scene& scene) {
    std::map<std::string, Table> tables;
    each_table(scene, [&](const std::string& name, const auto& settings, const auto& keys) {
        const auto* values = listed(settings);
        if (!values) return;
        each_key(keys, [&](const auto& field) {
            const auto& value = values->*field.member;
            std::string text = "none";
            if constexpr (requires { value.has_value(); }) {
                if (value) text = value_text(*value);
            } else {
                text = value_text(value);
            }
            tables[name][std::string(field.key)] = {field.about.label, text};
        });
    });
    return tables;
}

/// What a person calls a table that comes or goes.
std::string name_of_table(const std::string& table, const Table& keys) {
    return keys.size() == 1 ? keys.begin()->second.label : capitalised(table);
}

void add(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::string difference_between(const Scene& before, const Scene& after) {
    if (before.fabric.has_value() != after.fabric.has_value()) return "Material";
    const auto old_tables = tables_of(before), new_tables = tables_of(after);
    std::vector<std::string> names;
    for (const auto& entry : new_tables)
        if (!old_tables.contains(entry.first)) add(names, name_of_table(entry.first, entry.second));
    for (const auto& entry : old_tables) {
        const auto found = new_tables.find(entry.first);
        if (found == new_tables.end()) {
            add(names, name_of_table(entry.first, entry.second));
            continue;
        }
        for (const auto& key : entry.second)
            if (found->second.at(key.first).value != key.second.value) add(names, key.second.label);
    }
    if (names.size() > 2) return counted(names.size(), "setting");
    if (names.empty()) return "";
    return names[0] + (names.size() == 2 ? " and " + names[1] : "");
}

}  // namespace drapeau

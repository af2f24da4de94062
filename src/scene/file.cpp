#include "scene/file.hpp"

#include "io/encoding.hpp"
#include "io/error.hpp"
#include "io/text_file.hpp"
#include "scene/assign.hpp"
#include "scene/check.hpp"
#include "scene/material.hpp"
#include "scene/settings.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <climits>

namespace drapeau {

namespace {

using namespace settings;

constexpr std::size_t max_bytes = 1 << 20;

// Every dot or bracket may nest one table deeper, and tables are destroyed recursively: this many fit the stack.
constexpr std::ptrdiff_t max_nesting = 4000;

/// One fault in one file: "storm.toml:7: flag.columns = 0: a whole number from 1 to 4096 is allowed". Of an assignment
/// its option stands in place of file and key.
[[noreturn]] void fail(const std::string& origin, const toml::node& at, const std::string& what) {
    if (const auto& source = at.source().path; source && *source != origin) {
        const auto value = what.find(" = ");
        throw InputError(*source + (value == std::string::npos ? ": " + what : what.substr(value)));
    }
    throw InputError(one_line(origin, 1000) + ":" + std::to_string(at.source().begin.line) + ": " + what);
}

[[noreturn]] void fail(const std::string& origin, const std::string& what) {
    throw InputError(one_line(origin, 1000) + ": " + what);
}

/// A value as the file says it, for messages.
std::string echo(const toml::node& node) {
    if (const auto* value = node.as_boolean()) return value_text(value->get());
    if (const auto* value = node.as_integer()) return std::to_string(value->get());
    if (const auto* value = node.as_floating_point()) {
        const std::string text = shortest(value->get());
        return text + (text.find_first_not_of("-0123456789") == std::string::npos ? ".0" : "");
    }
    if (const auto* value = node.as_string()) return in_quotes(value->get());
    if (node.is_table()) return "a table";
    if (const auto* array = node.as_array()) {
        std::string text = "[";
        for (std::size_t i = 0; i < array->size() && i < 8; ++i) text += (i > 0 ? ", " : "") + echo(*array->get(i));
        return text + (array->size() > 8 ? ", ...]" : "]");
    }
    return "a date or time";
}

// Whether a node holds a value of the type, and that value. Whole numbers are numbers; numbers are not whole numbers.
// What is out of an int's range stays out of every range that settings allow.

bool take(const toml::node& node, bool& value) {
    if (!node.is_boolean()) return false;
    value = node.as_boolean()->get();
    return true;
}
bool take(const toml::node& node, int& value) {
    if (!node.is_integer()) return false;
    value = static_cast<int>(std::clamp<std::int64_t>(node.as_integer()->get(), INT_MIN, INT_MAX));
    return true;
}
bool take(const toml::node& node, std::uint64_t& value) {
    if (!node.is_integer()) return false;
    value = static_cast<std::uint64_t>(node.as_integer()->get());
    return true;
}
bool take(const toml::node& node, double& value) {
    if (node.is_integer()) {
        value = static_cast<double>(node.as_integer()->get());
    } else if (node.is_floating_point()) {
        value = node.as_floating_point()->get();
    } else {
        return false;
    }
    return true;
}
bool take(const toml::node& node, std::string& value) {
    if (!node.is_string()) return false;
    value = node.as_string()->get();
    return true;
}
bool take(const toml::node& node, glm::dvec3& value) {
    const toml::array* array = node.as_array();
    return array && array->size() == 3 && take(*array->get(0), value.x) && take(*array->get(1), value.y) &&
           take(*array->get(2), value.z);
}
template <class Enum>
requires std::is_enum_v<Enum>
bool take(const toml::node& node, Enum& value) {
    const auto names = names_of(value);
    const auto name = node.value<std::string_view>();
    const auto found = name ? std::find(names.begin(), names.end(), *name) : names.end();
    if (found == names.end()) return false;
    value = static_cast<Enum>(found - names.begin());
    return true;
}

template <class Settings, class Value>
bool take_field(const toml::node& node, Settings& settings, const Key<Settings, Value>& field) {
    return take(node, settings.*field.member);
}
template <class Settings, class Value>
bool take_field(const toml::node& node, Settings& settings, const Key<Settings, std::optional<Value>>& field) {
    auto& value = settings.*field.member;
    value.reset();
    if (!field.absent.empty() && node.value<std::string_view>() == field.absent) return true;
    return take(node, value.emplace());
}

bool is_one_of(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Where a key that stands in the wrong table belongs.
std::optional<std::string> table_of(std::string_view key) {
    const Scene any;
    std::optional<std::string> found;
    each_table(any, [&](const std::string& table, const auto&, const auto& keys) {
        const auto names = names_in(keys);
        if (!found && !table.empty() && is_one_of(names, key)) found = table;
    });
    return found;
}

/// Why a name does not belong here, and what may have been meant.
std::string unknown_text(std::string_view name, std::span<const std::string_view> known) {
    const auto longer =
        std::find_if(known.begin(), known.end(), [&](auto k) { return k.starts_with(std::string(name) + "_"); });
    const auto meant = longer != known.end() ? std::optional(*longer) : nearest(name, known);
    if (meant) return "; did you mean " + std::string(*meant) + "?";
    if (const auto table = table_of(name)) return "; it belongs under [" + *table + "]";
    std::string list;
    for (const auto& candidate : known) list += (list.empty() ? "; known here: " : ", ") + std::string(candidate);
    return list;
}

void refuse_unknown_keys(const toml::table& node, std::string_view table, std::span<const std::string_view> known,
                         const std::string& origin) {
    for (const auto& [key, value] : node) {
        const std::string_view name = key.str();
        if (is_one_of(known, name)) continue;
        const std::string full = one_line(full_name(table, name), 60);
        if (value.is_table()) fail(origin, value, "[" + full + "]: unknown table" + unknown_text(name, known));
        fail(origin, value, full + " = " + one_line(echo(value), 60) + ": unknown key" + unknown_text(name, known));
    }
}

template <class Settings, class Keys>
void read_keys(const toml::table& node, const std::string& table, Settings& settings, const Keys& keys,
               const std::string& origin) {
    each_key(keys, [&](const auto& field) {
        const std::string name = full_name(table, field.key);
        const toml::node* value = node.get(field.key);
        if (!value && field.required) fail(origin, node, name + " is missing: " + allowed_text(field));
        if (!value || take_field(*value, settings, field)) return;

        fail(origin, *value, name + " = " + one_line(echo(*value), 60) + ": " + allowed_text(field));
    });
}

/// Tables of the file that no scene has, or that no scene of this version has.
void refuse_unknown_tables(const toml::table& root, const std::string& origin) {
    std::vector<std::string_view> known = names_in(scene_keys);
    const Scene any;
    each_table(any, [&](std::string_view table, const auto&, const auto&) {
        if (!table.empty()) known.push_back(table);
    });
    refuse_unknown_keys(root, "", known, origin);
}

/// A fabric begins with the values of its name.
void begin(Fabric& fabric, const toml::table& node, const Scene&) {
    if (const toml::node* name = node.get("name"); name && take(*name, fabric.name)) fabric = fabric_of(fabric.name);
}
void begin(Bending& bending, const toml::table&, const Scene& scene) {
    bending = usual_term<Bending>(scene);
}
template <class Settings>
void begin(Settings&, const toml::table&, const Scene&) {}

void read_tables(const toml::table& root, Scene& scene, const std::string& origin) {
    scene.springs.reset();
    if (const toml::node* fabric = root.get("fabric"); fabric && root.get("springs"))
        fail(origin, *fabric, two_materials);
    each_table(scene, [&](const std::string& table, auto& settings, const auto& keys) {
        if (table.empty()) {
            read_keys(root, table, *listed(settings), keys, origin);
            return;
        }
        const toml::node* node = root.get(table);
        if (!node) return;
        if (!node->is_table())
            fail(origin, *node, table + " = " + one_line(echo(*node), 60) + ": a table is expected, [" + table + "]");

        if constexpr (requires { settings.has_value(); }) begin(settings.emplace(), *node->as_table(), scene);
        refuse_unknown_keys(*node->as_table(), table, names_in(keys), origin);
        read_keys(*node->as_table(), table, *listed(settings), keys, origin);
    });
}

/// The fault of a scene's values, at the line that says it.
[[noreturn]] void report(SceneFault fault, const toml::table& root, const std::string& origin) {
    const toml::node* at = fault.table.empty() ? &root : root.get(fault.table);
    if (const toml::table* table = at ? at->as_table() : nullptr; table && !fault.key.empty()) {
        if (const toml::node* value = table->get(fault.key)) {
            fault.value = echo(*value);
            at = value;
        }
    }
    if (at) fail(origin, *at, fault.text());
    fail(origin, fault.text());
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, std::span<const Assignment> assignments) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) fail(file.string(), "a folder, a scene file is wanted");
    return parse_scene(read_text_file(file.string(), max_bytes), file.string(), assignments);
}

Scene parse_scene(std::string_view text, const std::string& origin, std::span<const Assignment> assignments) {
    if (text.empty()) fail(origin, "empty, a scene is wanted");
    if (const std::string fault = encoding_fault(text); !fault.empty()) fail(origin, fault);
    if (without_space(text.substr(0, 100)).starts_with('<'))
        fail(origin, "markup, such as an SVG image, and no scene; an image is given with --texture");
    const auto nesting =
        std::count_if(text.begin(), text.end(), [](char c) { return c == '.' || c == '[' || c == '{'; });
    if (text.size() > max_bytes) fail(origin, "more than 1 MiB, a scene is smaller");
    if (nesting > max_nesting) {
        fail(origin,
             std::to_string(nesting) + " dots and brackets, at most " + std::to_string(max_nesting) + " are allowed");
    }

    toml::table root;
    try {
        root = toml::parse(text, origin);
    } catch (const toml::parse_error& error) {
        throw InputError(one_line(origin, 1000) + ":" + std::to_string(error.source().begin.line) + ": " +
                         one_line(error.description(), 300));
    }

    for (const Assignment& assignment : assignments) assign(root, assignment);

    Scene scene;
    scene.name = std::filesystem::path(origin).stem().string();
    if (!is_allowed(scene.name, {})) scene.name = "Scene";
    refuse_unknown_tables(root, origin);
    read_tables(root, scene, origin);
    if (auto fault = find_fault(scene)) report(std::move(*fault), root, origin);
    return scene;
}

std::string place_of_texture(std::string_view text, const std::string& origin) {
    try {
        const toml::table root = toml::parse(text, origin);
        const auto texture = root["flag"]["texture"];
        return texture ? origin + ":" + std::to_string(texture.node()->source().begin.line) : origin;
    } catch (const toml::parse_error&) {
        return origin;
    }
}

std::string place_of_texture(const std::filesystem::path& scene_file) {
    const std::string name = one_line(scene_file.string(), 1000);
    try {
        return place_of_texture(read_text_file(scene_file.string(), max_bytes), name);
    } catch (const InputError&) {
        return name;
    }
}

}  // namespace drapeau

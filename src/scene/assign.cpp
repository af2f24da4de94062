#include "scene/assign.hpp"

#include "io/error.hpp"
#include "scene/settings.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace drapeau {

namespace {

using namespace settings;

constexpr std::size_t max_assignment = 5000;  // bytes

/// What an assignment means to change.
enum class Target { other, text, boolean, left_out, table };

template <class Value>
constexpr Target target_of = std::is_same_v<Value, std::string> ? Target::text
                             : std::is_same_v<Value, bool>      ? Target::boolean
                                                                : Target::other;
template <class Value>
constexpr Target target_of<std::optional<Value>> = Target::left_out;

Target find_target(std::string_view key) {
    const Scene any;
    Target found = Target::other;
    each_table(any, [&](const std::string& table, const auto& settings, const auto& keys) {
        if (requires { settings.has_value(); } && key == table) found = Target::table;
        each_key(keys, [&]<class Settings, class Value>(const Key<Settings, Value>& field) {
            if (key == full_name(table, field.key) && field.absent.empty()) found = target_of<Value>;
        });
    });
    return found;
}

bool is_bare_key(std::string_view key) {
    constexpr auto allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !key.empty() && key.find_first_not_of(allowed) == std::string_view::npos;
}

/// The number as TOML has it, however many digits it has.
std::string as_float(double number) {
    const std::string text = value_text(number);
    return text + (text.find_first_not_of("-0123456789") == std::string::npos ? ".0" : "");
}

/// A file that says just this.
toml::table as_file(const Assignment& assignment, Target target) {
    const std::string& value = assignment.value;
    const auto dot = assignment.key.find('.');
    const bool in_table = dot != std::string::npos;
    const std::string table = in_table ? assignment.key.substr(0, dot) : "";
    const std::string name = in_table ? assignment.key.substr(dot + 1) : assignment.key;
    const auto parsed = [&](const std::string& text) {
        return toml::parse((in_table ? "[" + table + "]\n" : "") + name + " = " + text, assignment.option);
    };
    if (target == Target::boolean && value == "on") return parsed("true");
    if (target == Target::boolean && value == "off") return parsed("false");
    try {
        auto file = parsed(value);
        const toml::table* keys = in_table ? file[table].as_table() : &file;
        const bool alone = file.size() == 1 && keys->size() == 1;
        if (alone && (target != Target::text || keys->get(name)->is_string())) return file;
    } catch (const toml::parse_error&) {  // a word, or a number that TOML would write otherwise
        const auto number = number_in(value);
        if (number && target != Target::text) return parsed(as_float(*number));
    }
    toml::table file = parsed("''");
    toml::table& keys = in_table ? *file[table].as_table() : file;
    keys[name].as_string()->get() = value;  // whatever bytes it has: what is no text is refused with the rest
    return file;
}

void merge(toml::table& into, toml::table&& from) {
    for (auto& [key, node] : from) {
        toml::node* present = into.get(key.str());
        if (present && present->is_table() && node.is_table()) {
            merge(*present->as_table(), std::move(*node.as_table()));
        } else {
            node.visit([&, &name = key](auto& concrete) { into.insert_or_assign(name, std::move(concrete)); });
        }
    }
}

}  // namespace

Assignment assignment_in(const std::string& text) {
    const auto equals = text.find('=');
    const std::string key(without_space(std::string_view(text).substr(0, equals)));
    const auto dot = key.find('.');
    const bool is_key =
        is_bare_key(key.substr(0, dot)) && (dot == std::string::npos || is_bare_key(key.substr(dot + 1)));
    if (equals == std::string::npos || !is_key) {
        throw InputError("--set " + one_line(text, 60) +
                         ": KEY=VALUE is wanted, such as flag.columns=90; drapeau-lab settings lists the keys");
    }
    if (text.size() > max_assignment) {  // no value is as long, and what nests this deep fits the stack
        throw InputError(fmt::format("--set {}: {} bytes, at most {} are allowed", key, text.size(), max_assignment));
    }
    return {"--set " + key, key, std::string(without_space(std::string_view(text).substr(equals + 1)))};
}

void assign(toml::table& root, const Assignment& assignment) {
    const auto& [option, key, value] = assignment;
    const Target target = find_target(key);
    if (value == "off" && target == Target::table) {
        root.erase(key);
    } else if (value == "off" && target == Target::left_out) {
        if (toml::table* table = root[key.substr(0, key.find('.'))].as_table())
            table->erase(key.substr(key.find('.') + 1));
    } else if (value == "on" && target == Target::table) {
        merge(root, toml::parse("[" + key + "]", option));
    } else {
        merge(root, as_file(assignment, target));
    }
}

}  // namespace drapeau

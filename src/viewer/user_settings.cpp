#include "user_settings.hpp"

#include "io/encoding.hpp"
#include "io/error.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_bytes = 1 << 16;
constexpr std::ptrdiff_t max_nesting = 4000;  // dots and brackets: tables are destroyed recursively
constexpr std::size_t max_text = 4096;        // bytes

// Whether a node holds such a value, and that value.

bool take(const toml::node& node, int& value, int lowest, int highest) {
    if (!node.is_integer()) return false;
    const std::int64_t number = node.as_integer()->get();
    if (number < lowest || number > highest) return false;
    value = int(number);
    return true;
}
bool take(const toml::node& node, bool& value, int, int) {
    if (!node.is_boolean()) return false;
    value = node.as_boolean()->get();
    return true;
}
bool take(const toml::node& node, std::string& value, int, int) {
    if (!node.is_string() || node.as_string()->get().size() > max_text) return false;
    value = node.as_string()->get();
    return value.find('\0') == std::string::npos;
}
bool take(const toml::node& node, std::vector<std::string>& value, int, int) {
    if (!node.is_array()) return false;
    value.clear();
    for (const toml::node& element : *node.as_array())
        if (!take(element, value.emplace_back(), 0, 0) || value.back().empty()) return false;
    if (value.size() > max_recent_files) value.resize(max_recent_files);
    return true;
}

std::string wanted(int, int lowest, int highest) {
    return "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
}
std::string wanted(bool, int, int) {
    return "true or false";
}
std::string wanted(const std::string&, int, int) {
    return "text in quotes";
}
std::string wanted(const std::vector<std::string>&, int, int) {
    return "a list of texts in quotes";
}

std::string text_of(int value) {
    return std::to_string(value);
}
std::string text_of(bool value) {
    return value ? "true" : "false";
}
std::string text_of(const std::string& value) {
    return in_quotes(value);
}
std::string text_of(const std::vector<std::string>& value) {
    std::string text;
    for (const std::string& element : value)
        if (is_utf8(element)) text += (text.empty() ? "" : ", ") + in_quotes(element);  // TOML holds no other path
    return "[" + text + "]";
}

std::string at_line(const std::string& origin, const toml::source_region& source) {
    return one_line(origin, 1000) + ":" + std::to_string(source.begin.line) + ": ";
}

/// The first free name of FILE.bad, FILE.bad-2 ...
fs::path name_aside(const fs::path& file) {
    std::error_code failure;
    fs::path aside = file;
    aside += ".bad";
    for (int number = 2; number < 100 && fs::exists(fs::symlink_status(aside, failure)); ++number) {
        aside = file;
        aside += ".bad-" + std::to_string(number);
    }
    return aside;
}

}  // namespace

fs::path user_settings_file() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    fs::path folder;
    if (config && *config == '/')
        folder = config;
    else if (home && *home == '/')
        folder = fs::path(home) / ".config";
    return folder.empty() ? folder : folder / "drapeau" / "settings.toml";
}

UserSettings parse_user_settings(const std::string& text, const std::string& origin) {
    const std::string name = one_line(origin, 1000);
    if (const std::string fault = encoding_fault(text); !fault.empty()) throw InputError(name + ": " + fault);
    const auto nests = [](char c) { return c == '.' || c == '[' || c == '{'; };
    if (text.size() > max_bytes || std::count_if(text.begin(), text.end(), nests) > max_nesting)
        throw InputError(name + ": not written by drapeau");
    toml::table root;
    try {
        root = toml::parse(text, origin);
    } catch (const toml::parse_error& error) {
        throw InputError(at_line(origin, error.source()) + one_line(error.description(), 300));
    }
    UserSettings settings;
    each_remembered(settings, [&](const char* key, auto& value, int lowest, int highest) {
        const toml::node* node = root.get(key);
        if (node && !take(*node, value, lowest, highest))
            throw InputError(at_line(origin, node->source()) + key + ": " + wanted(value, lowest, highest) +
                             " is wanted");
    });
    return settings;
}

std::string write_user_settings(const UserSettings& settings) {
    std::string text = "# What the window of drapeau remembers between runs.\n";
    each_remembered(settings, [&](const char* key, const auto& value, int, int) {
        text += std::string(key) + " = " + text_of(value) + "\n";
    });
    return text;
}

FoundSettings find_user_settings(const fs::path& file) {
    std::error_code failure;
    if (file.empty()) return {};
    if (!fs::exists(file, failure) && !failure) return {.settings = {}, .trouble = {}, .may_be_saved = true};
    try {
        return {.settings = parse_user_settings(read_text_file(file.string(), max_bytes), file.string()),
                .trouble = {},
                .may_be_saved = true};
    } catch (const InputError& fault) {
        const fs::path aside = name_aside(file);
        fs::rename(file, aside, failure);
        const std::string what = "The window begins with defaults: " + std::string(fault.what()) + ". ";
        if (failure) return {.settings = {}, .trouble = what + "Nothing is remembered until that is mended."};
        return {.settings = {}, .trouble = what + "The file is now " + aside.string(), .may_be_saved = true};
    }
}

void save_user_settings(const UserSettings& settings, const fs::path& file) {
    std::error_code failure;
    fs::create_directories(file.parent_path(), failure);
    if (failure) throw InputError(one_line(file.parent_path().string(), 1000) + ": " + failure.message());
    write_file(file.string(), [&](const Append& append) { append(write_user_settings(settings)); });
}

}  // namespace drapeau

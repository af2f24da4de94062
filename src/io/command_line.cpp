#include "io/command_line.hpp"

#include "io/given_path.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace drapeau {

namespace {

void refuse_empty_values(CLI::App& app) {
    const CLI::Validator not_empty(
        [](std::string& value) { return std::string(value.empty() ? "an empty value" : ""); }, "");
    for (CLI::Option* option : app.get_options())
        if (option->get_items_expected_max() > 0) option->check(not_empty);
    for (CLI::App* command : app.get_subcommands({})) refuse_empty_values(*command);
}

const CLI::Option* find_option(const CLI::App& app, const std::string& name) {
    if (const CLI::Option* option = app.get_option_no_throw(name)) return option;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (const CLI::Option* option = command->get_option_no_throw(name)) return option;
    return nullptr;
}

const CLI::Option* find_repeated(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
        if (option->get_items_expected_max() == 1 && option->count() > 1) return option;
    for (const CLI::App* command : app.get_subcommands())
        if (const CLI::Option* option = find_repeated(*command)) return option;
    return nullptr;
}

/// The words after the program's name. "--film=" is "--film" and an empty value: CLI11 would take the next word for it.
std::vector<std::string> words_of(const CLI::App& app, int count, char** words) {
    std::vector<std::string> all;
    bool options_over = false;
    for (int i = 1; i < count; ++i) {
        std::string word = words[i];
        options_over = options_over || word == "--";
        const bool cut_off = !options_over && word.starts_with("--") && word.find('=') == word.size() - 1;
        if (cut_off) word.pop_back();
        const CLI::Option* option = cut_off ? find_option(app, word) : nullptr;
        if (option && option->get_items_expected_max() == 0) throw CLI::ArgumentMismatch(word + " takes no value");
        all.push_back(word);
        if (cut_off) all.emplace_back();
    }
    return all;
}

/// Whether a word that is no option may be a file's name all the same.
bool is_file_like(const std::string& word) {
    std::error_code ignored;
    return word.starts_with('-') && (std::filesystem::exists(word, ignored) || ending_of(word) == ".toml");
}

}  // namespace

void take_as_path(CLI::Option* option) {
    option->transform([](const std::string& given) { return meant_path(given); }, "");
}

CLI::Validator whole_number(long long lowest, long long highest) {
    return CLI::Validator(
        [=](std::string& text) {
            if (text.empty()) return std::string();  // parse() refuses that
            long long value = 0;
            const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool whole = fault == std::errc{} && end == text.data() + text.size();
            if (whole && value >= lowest && value <= highest) return std::string();
            return fmt::format("{}: a whole number from {} to {} is allowed", one_line(text, 60), lowest, highest);
        },
        "");
}

void add_assignments(CLI::App& app, std::vector<std::string>& assignments) {
    app.add_option("--set", assignments,
                   "A setting instead of the scene's own: flag.columns=90, springs.drag=off; docs/scene.md lists them")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void parse(CLI::App& app, int count, char** words) {
    refuse_empty_values(app);
    std::vector<std::string> all = words_of(app, count, words);
    std::reverse(all.begin(), all.end());  // as CLI11 takes them
    app.parse(all);
}

std::string explained(const CLI::App& app, const CLI::ParseError& error) {
    if (const CLI::Option* repeated = find_repeated(app)) return repeated->get_name() + " is given more than once";
    for (const std::string& word : app.remaining(true)) {
        if (!is_file_like(word)) continue;
        const std::string name = one_line(word);
        return name + " begins with a dash: a file of that name is given as ./" + name + " or after --";
    }
    return one_line(error.what(), 300);
}

}  // namespace drapeau

#include "io/given_path.hpp"

#include "io/text.hpp"

#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>

namespace drapeau {

namespace {

std::string_view without_quotes(std::string_view text) {
    const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// "%20" is a space. What is no byte that a path may hold stays as it is.
std::string percent_decoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
        if (low < 0 || (high == 0 && low == 0)) {
            decoded += text[i];
        } else {
            decoded += static_cast<char>(16 * high + low);
            i += 2;
        }
    }
    return decoded;
}

/// The path of file:///folder/file and file://localhost/folder/file.
std::optional<std::string> path_of_url(std::string_view text) {
    for (const std::string_view start : {"file://", "file://localhost"}) {
        if (text.starts_with(start) && text.substr(start.size()).starts_with('/'))
            return percent_decoded(text.substr(start.size()));
    }
    return {};
}

}  // namespace

std::string meant_path(const std::string& given) {
    std::error_code ignored;
    if (std::filesystem::exists(given, ignored)) return given;
    const std::string_view bare = without_quotes(without_space(given));
    if (const auto path = path_of_url(bare)) return *path;
    const char* home = std::getenv("HOME");
    if (home && *home && (bare == "~" || bare.starts_with("~/"))) return home + std::string(bare.substr(1));
    return std::string(bare);
}

std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
    return ending;
}

}  // namespace drapeau

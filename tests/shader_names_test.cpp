// Names that the viewer and its shaders share. OpenGL takes no notice of a value for a uniform that does not exist.
#include "catch.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path project = fs::path(DRAPEAU_DOCS).parent_path();

/// All files of a folder, one after the other.
std::string text_of(const fs::path& folder) {
    std::string text;
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::ifstream in(entry.path(), std::ios::binary);
        text.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return text;
}

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// The words of a text that stand outside brackets.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words{""};
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' ? 1 : c == ']' ? -1 : 0;
        if (depth == 0 && in_word(c))
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// What stands between each `before`, which begins a word, and the next `after`.
std::vector<std::string> found(const std::string& text, const std::string& before, const std::string& after) {
    std::vector<std::string> all;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        if (at > 0 && in_word(text[at - 1])) continue;
        const std::size_t begin = at + before.size();
        all.push_back(text.substr(begin, text.find(after, begin) - begin));
    }
    return all;
}

/// The uniforms that shaders declare, of which one declaration may name several after their type.
std::set<std::string> declared_uniforms() {
    std::set<std::string> names;
    for (const std::string& declared : found(text_of(project / "shaders"), "uniform ", ";")) {
        if (declared.find('{') != std::string::npos) continue;  // a block
        const std::vector<std::string> words = words_of(declared);
        names.insert(words.begin() + 1, words.end());
    }
    return names;
}

std::set<std::string> set_uniforms() {
    const std::vector<std::string> names = found(text_of(project / "src" / "viewer"), "set(\"", "\"");
    return {names.begin(), names.end()};
}

}  // namespace

TEST_CASE("every uniform that the viewer sets is declared by a shader, and the other way round") {
    CHECK(set_uniforms() == declared_uniforms());
    CHECK(declared_uniforms().size() > 20);
}

// Names that the viewer and its shaders share. OpenGL takes no notice of a value for a uniform that does not exist.
#include "catch.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

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

/// What stands where the pattern's first group does, wherever it is found.
std::set<std::string> found(const std::string& text, const char* pattern) {
    const std::regex looked_for(pattern);
    std::set<std::string> all;
    for (std::sregex_iterator match(text.begin(), text.end(), looked_for), end; match != end; ++match)
        all.insert((*match)[1].str());
    return all;
}

/// The uniforms that shaders declare, of which one declaration may name several.
std::set<std::string> declared_uniforms() {
    std::set<std::string> names;
    for (const std::string& list : found(text_of(project / "shaders"), R"(uniform \w+ ([\w, ]+)(?:\[\d+\])?;)"))
        names.merge(found(list, R"((\w+))"));
    return names;
}

}  // namespace

TEST_CASE("every uniform that the viewer sets is declared by a shader, and the other way round") {
    CHECK(found(text_of(project / "src" / "viewer"), R"re(\bset\("(\w+)")re") == declared_uniforms());
    CHECK(declared_uniforms().size() > 20);
}

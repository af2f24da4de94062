// The program that the README shows is the one that is compiled and run.
#include "catch.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("the README shows the example word for word", "[readme]") {
    const std::filesystem::path project = std::filesystem::path(DRAPEAU_DOCS).parent_path();
    const std::string example = text_of(project / "examples" / "embed.cpp");
    REQUIRE(!example.empty());
    CHECK(text_of(project / "README.md").find("```cpp\n" + example + "```\n") != std::string::npos);
}

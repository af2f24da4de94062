#include "scene_cards.hpp"

#include "io/text.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <fstream>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_opening = 2000;  // characters looked at

std::string beginning_of(const fs::path& file) {
    std::string text(longest_opening, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    return text;
}

}  // namespace

std::string opening_sentence(std::string_view scene_text) {
    std::string said;
    while (scene_text.starts_with('#')) {
        const std::string_view line = scene_text.substr(0, scene_text.find('\n'));
        const std::size_t first = line.find_first_not_of("# \t\r"), last = line.find_last_not_of(" \t\r");
        if (first != line.npos) said += (said.empty() ? "" : " ") + std::string(line.substr(first, last + 1 - first));
        scene_text.remove_prefix(std::min(line.size() + 1, scene_text.size()));
    }
    // A sentence ends at its full stop, one within a number is none.
    const std::size_t stop = said.find(". ");
    if (stop != said.npos) said.resize(stop + 1);
    return printable(said);
}

std::vector<SceneCard> scene_cards() {
    std::vector<SceneCard> cards;
    for (const std::string& name : shipped_scenes()) {
        const fs::path folder = assets_directory() / "scenes", picture = folder / "thumbnails" / (name + ".png");
        std::error_code failure;
        cards.push_back({.name = name,
                         .summary = opening_sentence(beginning_of(folder / (name + ".toml"))),
                         .picture = fs::is_regular_file(picture, failure) ? picture : fs::path()});
    }
    return cards;
}

}  // namespace drapeau

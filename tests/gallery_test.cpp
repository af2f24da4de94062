// Galleries: small copies of images that give way to what is wanted at once, and what is said of scenes.
#include "catch.hpp"

#include "viewer/loader.hpp"
#include "viewer/scene_cards.hpp"

#include <filesystem>
#include <set>

using namespace drapeau;

namespace {

std::filesystem::path flag_file(const std::string& name) {
    return assets_directory() / "flags" / name;
}

}  // namespace

TEST_CASE("a small copy is made once, whole, and nobody is told that a file is loaded") {
    Loader loader;
    for (int n = 0; n < 3; ++n) loader.load_small(flag_file("germany.png"));
    CHECK(loader.waiting_for().empty());
    loader.wait();
    CHECK(loader.makes_small());  // it waits to be taken
    const auto made = loader.take_small();
    REQUIRE(made);
    REQUIRE(made->image);
    CHECK(made->file == flag_file("germany.png"));
    CHECK(made->image->width == 240);
    CHECK(made->image->height == 144);
    CHECK(made->image->pixel(120, 72)[0] == 0xdd);
    CHECK(!loader.take_small());
    CHECK(!loader.makes_small());
    CHECK(!loader.take());
}

TEST_CASE("an image that cannot be read has no small copy") {
    Loader loader;
    loader.load_small(flag_file("draw_flags.py"));
    loader.wait();
    const auto made = loader.take_small();
    REQUIRE(made);
    CHECK(!made->image);
}

TEST_CASE("small copies give way to what a person chose") {
    Loader loader;
    for (const auto& file : shipped_pictures()) loader.load_small(file);
    loader.load_image("japan");
    while (!loader.waiting_for().empty()) std::this_thread::yield();
    CHECK(loader.makes_small());  // most of them still wait
    const auto loaded = loader.take();
    REQUIRE(loaded);
    CHECK(loaded->file == flag_file("japan.png"));
    // All are made in the end; one that gave way is asked for again.
    std::set<std::filesystem::path> made;
    for (int round = 0; round < 2; ++round) {
        for (const auto& file : shipped_pictures())
            if (!made.contains(file)) loader.load_small(file);
        loader.wait();
        while (const auto small = loader.take_small()) {
            CHECK(small->image.has_value());
            CHECK(made.insert(small->file).second);
        }
    }
    CHECK(made.size() == shipped_pictures().size());
}

TEST_CASE("what a gallery says of a scene is the first sentence of its opening comment") {
    CHECK(opening_sentence("# One: two.\n# Three.\nname = \"x\"\n") == "One: two.");
    CHECK(opening_sentence("# A period of\r\n# 0.89 s\r\nname = \"x\"\n") == "A period of 0.89 s");
    CHECK(opening_sentence("#\n#") == "");
    CHECK(opening_sentence("name = \"x\"\n# Later.\n") == "");
    CHECK(opening_sentence("") == "");
    CHECK(opening_sentence("# a\x1b[1m") == "a\\x1b[1m");
}

TEST_CASE("every scene that ships has a sentence and a picture in the gallery, and the pictures are small") {
    std::uintmax_t bytes = 0;
    const auto cards = scene_cards();
    CHECK(cards.size() == shipped_scenes().size());
    for (const SceneCard& card : cards) {
        CAPTURE(card.name, card.summary);
        CHECK(card.summary.size() > 20);
        CHECK(card.summary.size() < 160);
        REQUIRE(!card.picture.empty());
        bytes += std::filesystem::file_size(card.picture);
    }
    CHECK(bytes < 250000);
}

// Loader: files chosen in the window are read beside it, the newest choice counts, and nothing waits for the others.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "image/image.hpp"
#include "viewer/loader.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

using namespace drapeau;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto promptly = 4s;  // hundredths of a second, and the rest for a busy machine

struct Folder : TemporaryFolder {
    std::string picture(const std::string& name, int width = 2, int height = 1) const {
        Image image = blank_image(width, height);
        for (std::uint8_t& value : image.rgba) value = 255;
        write_png(path / name, image);
        return (path / name).string();
    }
    std::string text(const std::string& name, const std::string& content) const {
        std::ofstream(path / name) << content;
        return (path / name).string();
    }
    /// An SVG of copies of copies, 10^12 rectangles: it is drawn until its limit of 10 s is over.
    std::string slow_picture(const std::string& name) const {
        std::string copies = R"(<g id="a0"><rect width="3" height="2"/></g>)";
        for (int i = 1; i <= 12; ++i) {
            copies += "<g id=\"a" + std::to_string(i) + "\">";
            for (int copy = 0; copy < 10; ++copy) copies += "<use xlink:href=\"#a" + std::to_string(i - 1) + "\"/>";
            copies += "</g>";
        }
        return text(name,
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                    "viewBox=\"0 0 3 2\">" +
                        copies + "</svg>");
    }
    std::string scene(const std::string& name, const std::string& texture) const {
        return text(name, "[flag]\ntexture = \"" + texture + "\"\n[springs]\nmass = 0.001\nstiffness = 50.0\n");
    }
};

Loaded next_of(Loader& loader) {
    loader.wait();
    auto loaded = loader.take();
    REQUIRE(loaded);
    return std::move(*loaded);
}

}  // namespace

TEST_CASE("an image is loaded beside the window, which is told its name meanwhile", "[threads]") {
    const Folder folder;
    Loader loader;
    CHECK(loader.waiting_for().empty());
    loader.load_image("'" + folder.slow_picture("slow.svg") + "' ");
    CHECK(loader.waiting_for() == "slow.svg");
    CHECK(!loader.take());
    loader.load_image(folder.picture("good.png"));
    const Loaded good = next_of(loader);
    CHECK(good.fault.empty());
    CHECK(good.file == folder.path / "good.png");
    REQUIRE(good.image);
    CHECK(good.image->width == 2);
    CHECK(loader.waiting_for().empty());
    CHECK(!loader.take());
}

TEST_CASE("a newer choice abandons an older one promptly", "[threads]") {
    const Folder folder;
    const std::string slow = folder.slow_picture("slow.svg"), slow_scene = folder.scene("slow.toml", "slow.svg");
    const std::string good = folder.picture("good.png"), good_scene = folder.scene("good.toml", "good.png");
    for (const bool scene : {false, true}) {
        CAPTURE(scene);
        Loader loader;
        scene ? loader.load_scene(slow_scene) : loader.load_image(slow);
        std::this_thread::sleep_for(100ms);
        const auto begin = std::chrono::steady_clock::now();
        scene ? loader.load_scene(good_scene) : loader.load_image(good);
        const Loaded loaded = next_of(loader);
        CHECK(std::chrono::steady_clock::now() - begin < promptly);
        CHECK(loaded.is_scene == scene);
        CHECK(loaded.fault.empty());
        CHECK(!loader.take());
    }
}

TEST_CASE("an image that was chosen after a scene comes after it, one before it not at all") {
    const Folder folder;
    const std::string image = folder.picture("good.png"), scene = folder.scene("good.toml", "good.png");
    Loader loader;
    loader.load_image(image);
    loader.load_scene(scene);
    CHECK(next_of(loader).is_scene);
    CHECK(!loader.take());
    loader.load_scene(scene);
    loader.load_image(image);
    CHECK(next_of(loader).is_scene);
    CHECK(!next_of(loader).is_scene);
    loader.load_image(image);
    loader.wait();
    CHECK(!loader.take(false));
    CHECK(loader.take(true));
    loader.load_scene(scene);
    loader.load_image(image);
    loader.forget_image();
    CHECK(next_of(loader).is_scene);
    CHECK(!loader.take());
}

TEST_CASE("a loader ends promptly while a file is loaded", "[threads]") {
    const Folder folder;
    auto loader = std::make_unique<Loader>();
    loader->load_image(folder.slow_picture("slow.svg"));
    std::this_thread::sleep_for(100ms);
    const auto begin = std::chrono::steady_clock::now();
    loader.reset();
    CHECK(std::chrono::steady_clock::now() - begin < promptly);
}

TEST_CASE("a file that cannot be loaded gives the reason and no more") {
    const Folder folder;
    Loader loader;
    loader.load_image(folder.text("text.png", "no picture"));
    const Loaded image = next_of(loader);
    CHECK(image.fault.find("text.png: a text, which cannot be read") != std::string::npos);
    CHECK(!image.image);
    loader.load_image("no-such-picture");
    CHECK(next_of(loader).fault.find("no-such-picture") != std::string::npos);
    loader.load_scene(folder.text("broken.toml", "colour = 1\n"));
    const Loaded scene = next_of(loader);
    CHECK(scene.is_scene);
    CHECK(scene.fault.find("broken.toml") != std::string::npos);
    // A scene whose image is missing is a scene.
    loader.load_scene(folder.scene("plain.toml", "missing.png"));
    const Loaded plain = next_of(loader);
    CHECK(plain.fault.empty());
    CHECK(plain.scene.fault.find("missing.png") != std::string::npos);
}

// Golden pictures: the main views, as they were when somebody last looked at them and found them right
// (golden/draw.sh).
#include "app.hpp"
#include "scenes.hpp"

#include "image/image_file.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace drapeau::window_tests;

namespace {

// Drivers and compilers round differently: edges of the flag lie a fraction of a pixel elsewhere. Four samples a pixel
// make that steps of a quarter of the contrast on edges, and next to nothing elsewhere.
constexpr double greatest_mean = 1.0;    // of 255, over all pixels and channels
constexpr int clearly = 40;              // of 255, in some channel
constexpr double greatest_share = 0.01;  // of pixels that differ clearly

struct Difference {
    double mean = 0.0;   // of 255
    double share = 0.0;  // of pixels that differ clearly
};

Difference difference(const drapeau::Image& a, const drapeau::Image& b) {
    double sum = 0.0, clear = 0.0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        int greatest = 0;
        for (std::size_t i = pixel; i < pixel + 4; ++i) {
            const int apart = std::abs(int(a.rgba[i]) - int(b.rgba[i]));
            sum += apart;
            greatest = std::max(greatest, apart);
        }
        clear += greatest > clearly;
    }
    return {sum / double(a.rgba.size()), clear / (double(a.rgba.size()) / 4.0)};
}

}  // namespace

TEST_CASE("the six main views look as they did when they were found right") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::filesystem::path golden = DRAPEAU_GOLDEN;
    std::ifstream views(golden / "views.txt");
    int looked_at = 0;
    for (std::string line; std::getline(views, line); ++looked_at) {
        std::istringstream words(line);
        std::string name, option;
        words >> name;
        std::vector<std::string> command{program()};
        while (words >> option) command.push_back(option);
        const std::string file = folder / (name + ".png");
        for (const std::string word : {"--frames", "30", "--hide-ui", "--size", "400x250", "--screenshot"})
            command.push_back(word);
        command.push_back(file);
        const Finished drawn = run(command, at_home_in(folder, screen.surroundings()));
        CAPTURE(name, drawn.errors);
        REQUIRE(drawn.status == 0);

        const drapeau::Image now = drapeau::load_image(file), then = drapeau::load_image(golden / (name + ".png"));
        REQUIRE(now.width == then.width);
        REQUIRE(now.height == then.height);
        const Difference apart = difference(now, then);
        std::filesystem::copy_file(file, std::filesystem::path(DRAPEAU_FAILURES) / ("golden-" + name + ".png"),
                                   std::filesystem::copy_options::overwrite_existing);
        INFO("drawn now: " << DRAPEAU_FAILURES << "/golden-" << name << ".png");
        CHECK(apart.mean < greatest_mean);
        CHECK(apart.share < greatest_share);
    }
    CHECK(looked_at == 6);
}

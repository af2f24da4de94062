// SVG: drawn at a flag's size, from nothing but itself, within limits.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "image/decoders.hpp"
#include "image_samples.hpp"
#include "io/error.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

FileBytes svg(const std::string& attributes, const std::string& content) {
    return bytes_of("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " +
                    attributes + ">" + content + "</svg>");
}

const std::string half_orange = R"(<rect width="3" height="2" fill="#c86432" fill-opacity="0.5"/>)";

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

}  // namespace

TEST_CASE("an SVG is drawn with its longest side at 2048 pixels, whatever size it states") {
    const auto [attributes, width, height] = GENERATE(table<std::string, double, double>({
        {R"(viewBox="0 0 3 2")", 2048.0, 2048.0 * 2 / 3},
        {R"(width="30" height="20" viewBox="0 0 3 2")", 2048.0, 2048.0 * 2 / 3},
        {R"(width="100%" height="100%" viewBox="0 0 3 2")", 2048.0, 2048.0 * 2 / 3},
        {R"(width="30cm" height="30cm" viewBox="0 0 3 2" preserveAspectRatio="none")", 2048.0, 2048.0},
        {R"(width="1e9" height="2e9" viewBox="0 0 3 2" preserveAspectRatio="none")", 1024.0, 2048.0},
    }));
    CAPTURE(attributes);
    const Image image = decode_image(svg(attributes, half_orange));
    CHECK(std::abs(image.width - width) <= 1.0);
    CHECK(std::abs(image.height - height) <= 1.0);
    // Its colour, to within what cairo's 8 bits multiplied by a half leave of it, up to every edge.
    const Rgba orange{200, 100, 50, 128};
    CHECK(has_corners(image, orange, orange, orange, orange, 1));
    CHECK(is_like(image, image.width / 2, image.height / 2, orange, 1));
}

TEST_CASE("an SVG opens no other file") {
    const TemporaryFolder folder;
    Image paint = blank_image(2, 2);
    for (std::uint8_t& value : paint.rgba) value = 255;
    write_png(folder / "paint.png", paint);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path);
    const std::string absolute = (folder / "paint.png").string();
    std::string images;
    for (const std::string& reference : {std::string("paint.png"), absolute, "file://" + absolute})
        images += "<image width=\"3\" height=\"2\" xlink:href=\"" + reference + "\"/>";
    const Image image = decode_image(svg(R"(viewBox="0 0 3 2")", images));
    std::filesystem::current_path(before);
    CHECK(is_like(image, image.width / 2, image.height / 2, {0, 0, 0, 0}, 0));
}

TEST_CASE("a hostile SVG ends in a message") {
    CHECK(says(error_of(svg("width=\"3\" height=\"2\"", repeated("<g>", 100000) + repeated("</g>", 100000))),
               "an SVG picture, damaged or unusual"));
    CHECK(says(error_of(svg("width=\"0\" height=\"0\"", "")), "damaged or unusual"));
    CHECK(says(error_of(bytes_of("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 3 2\"><rect wid")),
               "damaged or unusual"));

    // Copies of copies: 10^12 rectangles.
    std::string copies = R"(<g id="a0"><rect width="3" height="2"/></g>)";
    for (int i = 1; i <= 12; ++i)
        copies += "<g id=\"a" + std::to_string(i) + "\">" +
                  repeated("<use xlink:href=\"#a" + std::to_string(i - 1) + "\"/>", 10) + "</g>";
    const FileBytes bomb = svg(R"(viewBox="0 0 3 2")", copies);
    CHECK(says(message_of([&] { draw_svg(bomb, 1); }), "takes more than 1 s or 512 MiB"));
}

TEST_CASE("without rsvg-convert an SVG says what is missing") {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const std::string message = error_of(svg(R"(viewBox="0 0 3 2")", half_orange));
    setenv("PATH", path.c_str(), 1);
    CHECK(says(message, "needs rsvg-convert"));
    CHECK(says(message, "librsvg2-bin"));
}

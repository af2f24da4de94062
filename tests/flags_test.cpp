// Flags that ship: their proportions, and the colours at places that follow from the official construction.
#include "catch.hpp"

#include "image/image_file.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

using namespace drapeau;

namespace {

/// In heights of the flag, x from the hoist, y down from the top.
struct Place {
    double x = 0.0, y = 0.0;
    unsigned rgb = 0;
};

struct Drawn {
    std::string name;
    int height = 0, length = 0;  // the proportions
    std::vector<Place> places;
};

Image picture_of(const std::string& name) {
    return load_image(assets_directory() / "flags" / (name + ".png"));
}

unsigned colour_at(const Image& image, double x, double y) {
    const int column = std::clamp(int(x * image.height), 0, image.width - 1);
    const std::uint8_t* const pixel = image.pixel(column, std::clamp(int(y * image.height), 0, image.height - 1));
    return unsigned(pixel[0]) << 16 | unsigned(pixel[1]) << 8 | pixel[2];
}

/// Two places, each 4 pixels from the edge between two colours that lies at (x, y): `along` points from the first to
/// the second.
void add_edge(std::vector<Place>& places, double x, double y, double along_x, double along_y, unsigned first,
              unsigned second) {
    const double step = 4.0 / 720.0 / std::hypot(along_x, along_y);
    places.push_back({x - step * along_x, y - step * along_y, first});
    places.push_back({x + step * along_x, y + step * along_y, second});
}

Drawn level(const std::string& name, int height, int length, const std::vector<unsigned>& colours) {
    Drawn flag{name, height, length, {}};
    for (std::size_t i = 0; i + 1 < colours.size(); ++i)
        if (colours[i] != colours[i + 1])
            add_edge(flag.places, 0.1, double(i + 1) / double(colours.size()), 0, 1, colours[i], colours[i + 1]);
    return flag;
}

Drawn upright(const std::string& name, int height, int length, const std::vector<unsigned>& colours) {
    Drawn flag{name, height, length, {}};
    const double long_in_heights = double(length) / height;
    for (std::size_t i = 0; i + 1 < colours.size(); ++i)
        add_edge(flag.places, long_in_heights * double(i + 1) / double(colours.size()), 0.9, 1, 0, colours[i],
                 colours[i + 1]);
    return flag;
}

/// A cross whose parts along the fly and down the hoist are as many units wide; it reads field, edge, middle, edge ...
Drawn crossed(const std::string& name, const std::vector<int>& fly, const std::vector<int>& hoist,
              const std::vector<unsigned>& colours) {
    Drawn flag{name, 0, 0, {}};
    for (const int part : hoist) flag.height += part;
    for (const int part : fly) flag.length += part;
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i + 1 < fly.size(); ++i) {
        x += double(fly[i]) / flag.height;
        y += double(hoist[i]) / flag.height;
        add_edge(flag.places, x, 0.02, 1, 0, colours[i], colours[i + 1]);
        add_edge(flag.places, 0.02, y, 0, 1, colours[i], colours[i + 1]);
    }
    return flag;
}

Drawn united_kingdom() {
    constexpr unsigned white = 0xffffff, red = 0xc8102e, blue = 0x012169;
    Drawn flag{"united-kingdom", 1, 2, {}};
    auto& places = flag.places;
    const double part = 1.0 / 30.0;
    add_edge(places, 1 - 5 * part, 0.1, 1, 0, blue, white);
    add_edge(places, 1 - 3 * part, 0.1, 1, 0, white, red);
    add_edge(places, 1 + 5 * part, 0.9, 1, 0, white, blue);
    add_edge(places, 0.6, 0.5 - 3 * part, 0, 1, white, red);
    add_edge(places, 1.8, 0.5 + 5 * part, 0, 1, white, blue);
    // Half-way out on each diagonal, across it: blue, 3 of white, 2 of red, 1 of white, blue. Seen from the middle red
    // is on the left, so the broad white is above at the hoist and below at the fly.
    for (const double right : {-1.0, 1.0})
        for (const double down : {-1.0, 1.0}) {
            const double x = 1.0 + 0.6 * right, y = 0.5 + 0.3 * down, length = std::hypot(1.0, 0.5);
            const double nx = 0.5 * down / length, ny = -right / length;  // to the left, for y points down
            const auto across = [&](double parts, unsigned inner, unsigned outer) {
                add_edge(places, x + nx * parts * part, y + ny * parts * part, nx, ny, inner, outer);
            };
            across(-3, blue, white);
            across(0, white, red);
            across(2, red, white);
            across(3, white, blue);
        }
    return flag;
}

Drawn united_states() {
    constexpr unsigned white = 0xffffff, red = 0xb31942, blue = 0x0a3161;
    Drawn flag{"united-states", 10, 19, {}};
    for (int i = 0; i < 13; ++i) flag.places.push_back({1.5, (i + 0.5) / 13.0, i % 2 == 0 ? red : white});
    add_edge(flag.places, 0.76, 0.5 / 13, 1, 0, blue, red);
    add_edge(flag.places, 0.02, 7.0 / 13, 0, 1, blue, white);
    // A grid of eleven by nine places, 0.063 and 0.054 apart, with a star on every second one, the corners' included.
    for (int row = 1; row <= 9; ++row)
        for (int column = 1; column <= 11; ++column)
            flag.places.push_back({0.76 * column / 12, 7.0 / 13 * row / 10, (row + column) % 2 == 0 ? white : blue});
    add_edge(flag.places, 0.76 / 12, 0.7 / 13 - 0.0616 / 2 + 0.004, 0, 1, blue, white);  // the point, narrow
    return flag;
}

Drawn south_africa() {
    constexpr unsigned red = 0xe03c31, white = 0xffffff, green = 0x007749, gold = 0xffb81c, black = 0, blue = 0x001489;
    Drawn flag{"south-africa", 2, 3, {}};
    add_edge(flag.places, 1.4, 0.5 - 1.0 / 6, 0, 1, red, white);
    add_edge(flag.places, 1.4, 0.4, 0, 1, white, green);
    add_edge(flag.places, 1.4, 0.6, 0, 1, green, white);
    add_edge(flag.places, 1.4, 0.5 + 1.0 / 6, 0, 1, white, blue);
    // Across the arms a third of the way out: their middle line runs from the corner to the flag's middle.
    const double length = std::hypot(0.75, 0.5);
    for (const double down : {-1.0, 1.0}) {
        const double x = 0.3, y = 0.5 + 0.3 * down, nx = -0.5 / length,
                     ny = -0.75 * down / length;  // towards the hoist
        const auto across = [&](double heights, unsigned first, unsigned second) {
            add_edge(flag.places, x + nx * heights, y + ny * heights, nx, ny, first, second);
        };
        across(-1.0 / 6, down < 0 ? red : blue, white);
        across(-0.1, white, green);
        across(0.1, green, gold);
        across(1.0 / 6, gold, black);
    }
    return flag;
}

Drawn turkey() {
    constexpr unsigned red = 0xe30a17, white = 0xffffff;
    Drawn flag{"turkey", 2, 3, {}};
    add_edge(flag.places, 0.25, 0.5, 1, 0, red, white);          // 1/2 from the hoist, 1/2 wide
    add_edge(flag.places, 0.5, 0.25, 0, 1, red, white);          //
    add_edge(flag.places, 0.5625 - 0.2, 0.5, 1, 0, white, red);  // the inner circle, 4/10 wide
    const double point = 0.5625 - 0.2 + 1.0 / 3, middle = point + 0.125;
    flag.places.push_back({point - 0.006, 0.5, red});
    flag.places.push_back({point + 0.02, 0.5, white});
    for (int i = 0; i < 5; ++i) {  // points of the star, the first towards the hoist, and what lies between them
        const double at = std::numbers::pi * (1.0 + 0.4 * i), between = at + std::numbers::pi / 5;
        flag.places.push_back({middle + 0.105 * std::cos(at), 0.5 + 0.105 * std::sin(at), white});
        flag.places.push_back({middle + 0.06 * std::cos(between), 0.5 + 0.06 * std::sin(between), red});
    }
    return flag;
}

Drawn greece() {
    constexpr unsigned blue = 0x0d5eaf, white = 0xffffff;
    Drawn flag{"greece", 2, 3, {}};
    for (int i = 0; i < 9; ++i) flag.places.push_back({1.2, (i + 0.5) / 9, i % 2 == 0 ? blue : white});
    for (int i = 0; i < 5; ++i) flag.places.push_back({0.5 / 9, (i + 0.5) / 9, i == 2 ? white : blue});
    for (int i = 0; i < 5; ++i) flag.places.push_back({(i + 0.5) / 9, 0.5 / 9, i == 2 ? white : blue});
    add_edge(flag.places, 5.0 / 9, 1.5 / 9, 1, 0, blue, white);
    return flag;
}

Drawn checked(const std::string& name, int height, int length, int columns, int rows, unsigned first, unsigned second) {
    Drawn flag{name, height, length, {}};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            flag.places.push_back({(column + 0.5) * length / height / columns, (row + 0.5) / rows,
                                   (row + column) % 2 == 0 ? first : second});
    return flag;
}

const std::vector<Drawn>& flags() {
    static const std::vector<Drawn> all = {
        upright("france", 2, 3, {0x000091, 0xffffff, 0xe1000f}),
        upright("italy", 2, 3, {0x008c45, 0xf4f9ff, 0xcd212a}),
        upright("belgium", 13, 15, {0x000000, 0xfdda24, 0xef3340}),
        upright("ireland", 1, 2, {0x169b62, 0xffffff, 0xff883e}),
        upright("nigeria", 1, 2, {0x008751, 0xffffff, 0x008751}),
        level("germany", 3, 5, {0x000000, 0xdd0000, 0xffcc00}),
        level("netherlands", 2, 3, {0xae1c28, 0xffffff, 0x21468b}),
        level("estonia", 7, 11, {0x0072ce, 0x000000, 0xffffff}),
        level("poland", 5, 8, {0xe9e8e7, 0xd4213d}),
        level("ukraine", 2, 3, {0x0057b7, 0xffd700}),
        level("thailand", 2, 3, {0xa51931, 0xf4f5f8, 0x2d2a4a, 0x2d2a4a, 0xf4f5f8, 0xa51931}),
        level("pride-rainbow", 2, 3, {0xe40303, 0xff8c00, 0xffed00, 0x008026, 0x24408e, 0x732982}),
        level("pride-transgender", 3, 5, {0x5bcefa, 0xf5a9b8, 0xffffff, 0xf5a9b8, 0x5bcefa}),
        crossed("sweden", {5, 2, 9}, {4, 2, 4}, {0x006aa7, 0xfecc02, 0x006aa7}),
        crossed("denmark", {12, 4, 21}, {12, 4, 12}, {0xc8102e, 0xffffff, 0xc8102e}),
        crossed("finland", {5, 3, 10}, {4, 3, 4}, {0xffffff, 0x134483, 0xffffff}),
        crossed("norway", {6, 1, 2, 1, 12}, {6, 1, 2, 1, 6}, {0xba0c2f, 0xffffff, 0x00205b, 0xffffff, 0xba0c2f}),
        crossed("iceland", {7, 1, 2, 1, 14}, {7, 1, 2, 1, 7}, {0x02529c, 0xffffff, 0xdc1e35, 0xffffff, 0x02529c}),
        {"japan", 2, 3, {{0.75, 0.21, 0xbc002d}, {0.75, 0.19, 0xffffff}, {1.04, 0.5, 0xbc002d}, {1.06, 0.5, 0xffffff}}},
        {"bangladesh",
         3,
         5,
         {{0.75 - 0.325, 0.5, 0xf42a41},
          {0.75 - 0.342, 0.5, 0x006a4e},
          {0.75, 0.825, 0xf42a41},
          {0.75, 0.842, 0x006a4e}}},
        {"switzerland",
         1,
         1,
         {{0.2, 0.5, 0xffffff}, {0.18, 0.5, 0xda291c}, {0.42, 0.2, 0xffffff}, {0.4, 0.2, 0xda291c}}},
        {"chile",
         2,
         3,
         {{0.49, 0.49, 0x0039a6},
          {0.51, 0.49, 0xffffff},
          {0.49, 0.51, 0xd52b1e},
          {0.25, 0.14, 0xffffff},
          {0.25, 0.12, 0x0039a6},
          {0.25, 0.35, 0x0039a6},
          {0.25, 0.29, 0xffffff}}},
        {"czechia",
         2,
         3,
         {{0.74, 0.5, 0x11457e},
          {0.76, 0.49, 0xffffff},
          {0.76, 0.51, 0xd7141a},
          {0.3, 0.21, 0x11457e},
          {0.3, 0.19, 0xffffff},
          {0.3, 0.81, 0xd7141a}}},
        {"signal-l", 5, 6, {{0.3, 0.2, 0xffd100}, {0.9, 0.2, 0x000000}, {0.3, 0.8, 0x000000}, {0.9, 0.8, 0xffd100}}},
        {"signal-a", 5, 6, {{0.59, 0.5, 0xffffff}, {0.61, 0.5, 0x003da5}, {1.15, 0.05, 0x003da5}}},
        {"sheet", 2, 3, {{0.1, 0.1, 0xefeadf}, {1.4, 0.9, 0xefeadf}}},
        {"europe", 2, 3, {{0.75, 0.5 - 1.0 / 3, 0xffcc00}, {0.75 + 1.0 / 3, 0.5, 0xffcc00}, {0.75, 0.5, 0x003399}}},
        {"drapeau", 2, 3, {}},
        {"test-pattern", 2, 3, {{0.02, 0.02, 0xff0000}, {0.02, 0.98, 0x0000ff}}},
        {"uv-grid", 2, 3, {}},
        checked("signal-n", 5, 6, 4, 4, 0x003da5, 0xffffff),
        checked("racing-chequered", 4, 5, 10, 8, 0x000000, 0xffffff),
        greece(),
        south_africa(),
        turkey(),
        united_kingdom(),
        united_states()};
    return all;
}

/// How many pieces of one colour, or nearly so, there are in a part of the picture; pieces join through sides.
int pieces(const Image& image, unsigned rgb, int right, int bottom) {
    const auto is_it = [&](int x, int y) {
        const std::uint8_t* const p = image.pixel(x, y);
        return std::abs(p[0] - int(rgb >> 16)) + std::abs(p[1] - int(rgb >> 8 & 255)) +
                   std::abs(p[2] - int(rgb & 255)) <
               60;
    };
    std::vector<char> seen(std::size_t(right) * bottom);
    int count = 0;
    for (int y = 0; y < bottom; ++y)
        for (int x = 0; x < right; ++x) {
            std::vector<std::pair<int, int>> open{{x, y}};
            std::size_t size = 0;
            while (!open.empty()) {
                const auto at = open.back();
                open.pop_back();
                const int i = at.first, j = at.second;
                if (i < 0 || j < 0 || i >= right || j >= bottom) continue;
                char& known = seen[std::size_t(j) * right + i];
                if (known || !is_it(i, j)) continue;
                known = 1;
                ++size;
                for (const auto& next :
                     {std::pair(i + 1, j), std::pair(i - 1, j), std::pair(i, j + 1), std::pair(i, j - 1)})
                    open.push_back(next);
            }
            count += size > 20 ? 1 : 0;
        }
    return count;
}

}  // namespace

TEST_CASE("a flag that ships has its proportions, and its colours in their places") {
    for (const Drawn& flag : flags()) {
        CAPTURE(flag.name);
        const Image image = picture_of(flag.name);
        CHECK(image.width * flag.height == image.height * flag.length);
        CHECK(std::max(image.width, image.height) <= 1240);
        for (const Place& place : flag.places) {
            CAPTURE(place.x, place.y);
            CHECK(colour_at(image, place.x, place.y) == place.rgb);
        }
    }
}

TEST_CASE("fifty stars fly on the flag of the United States, and twelve on that of Europe") {
    const Image states = picture_of("united-states"), europe = picture_of("europe");
    CHECK(pieces(states, 0xffffff, int(0.759 * states.height), states.height * 7 / 13 - 1) == 50);
    CHECK(pieces(europe, 0xffcc00, europe.width, europe.height) == 12);
}

TEST_CASE("the signal A is cut out at its fly, and no other flag has holes") {
    for (const Drawn& flag : flags()) {
        CAPTURE(flag.name);
        CHECK(has_holes(picture_of(flag.name)) == (flag.name == "signal-a"));
    }
    const Image signal = picture_of("signal-a");
    CHECK(signal.pixel(signal.width - 10, signal.height / 2)[3] == 0);
    CHECK(signal.pixel(signal.width * 3 / 4 - 10, signal.height / 2)[3] == 255);
}

TEST_CASE("every flag that ships is checked here and has its source in docs/flags.md") {
    std::ifstream file(DRAPEAU_DOCS "/flags.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::uintmax_t bytes = 0;
    for (const auto& picture : shipped_pictures()) {
        const std::string name = picture.stem().string();
        CAPTURE(name);
        CHECK(std::any_of(flags().begin(), flags().end(), [&](const Drawn& flag) { return flag.name == name; }));
        CHECK(text.find("\n| `" + name + ".png` | ") != text.npos);
        bytes += std::filesystem::file_size(picture);
    }
    CHECK(shipped_pictures().size() == flags().size());
    CHECK(bytes < 600000);
}

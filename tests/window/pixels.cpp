#include "pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace drapeau::window_tests {

namespace {

const std::uint8_t* pixel(const Image& picture, int x, int y) {
    return picture.rgba.data() + (std::size_t(y) * picture.width + x) * 4;
}

}  // namespace

double Colour::vividness() const {
    return std::max({red, green, blue}) - std::min({red, green, blue});
}

Colour colour_at(const Image& picture, Point p) {
    return colour_around(picture, p, 0);
}

Colour colour_around(const Image& picture, Point p, int reach) {
    const int middle_x = int(std::lround(p.x)), middle_y = int(std::lround(p.y));
    Colour sum;
    int pixels = 0;
    for (int y = std::max(0, middle_y - reach); y <= std::min(picture.height - 1, middle_y + reach); ++y) {
        for (int x = std::max(0, middle_x - reach); x <= std::min(picture.width - 1, middle_x + reach); ++x) {
            const std::uint8_t* at = pixel(picture, x, y);
            sum = {sum.red + at[0], sum.green + at[1], sum.blue + at[2]};
            ++pixels;
        }
    }
    return {sum.red / pixels, sum.green / pixels, sum.blue / pixels};
}

int Mask::count() const {
    return int(std::count(set.begin(), set.end(), 1));
}

Mask changed(const Image& before, const Image& after, const Box& box, int tolerance) {
    const int x0 = std::max(0, int(box.x0)), x1 = std::min({int(box.x1), before.width, after.width});
    const int y0 = std::max(0, int(box.y0)), y1 = std::min({int(box.y1), before.height, after.height});
    Mask mask{std::max(0, x1 - x0), std::max(0, y1 - y0), {}};
    mask.set.resize(std::size_t(mask.width) * mask.height);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const std::uint8_t* a = pixel(before, x0 + x, y0 + y);
            const std::uint8_t* b = pixel(after, x0 + x, y0 + y);
            const int difference = std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
            mask.set[std::size_t(y) * mask.width + x] = difference > tolerance;
        }
    }
    return mask;
}

int enclosed_pieces(const Mask& lines, int smallest) {
    std::vector<char> seen = lines.set;
    std::vector<std::pair<int, int>> waiting;
    int pieces = 0;
    for (int start_y = 0; start_y < lines.height; ++start_y) {
        for (int start_x = 0; start_x < lines.width; ++start_x) {
            if (seen[std::size_t(start_y) * lines.width + start_x]) continue;
            int size = 0;
            bool touches_border = false;
            const auto visit = [&](int x, int y) {
                if (x < 0 || y < 0 || x >= lines.width || y >= lines.height) {
                    touches_border = true;
                    return;
                }
                char& here = seen[std::size_t(y) * lines.width + x];
                if (here) return;
                here = 1;
                waiting.emplace_back(x, y);
            };
            visit(start_x, start_y);
            while (!waiting.empty()) {
                const auto [x, y] = waiting.back();
                waiting.pop_back();
                ++size;
                visit(x - 1, y);
                visit(x + 1, y);
                visit(x, y - 1);
                visit(x, y + 1);
            }
            pieces += !touches_border && size >= smallest;
        }
    }
    return pieces;
}

}  // namespace drapeau::window_tests

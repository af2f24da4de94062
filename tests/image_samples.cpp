#include "image_samples.hpp"

#include "io/error.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace drapeau::testing {

FileBytes sample(const std::string& name) {
    std::ifstream stream(DRAPEAU_TEST_INPUTS "/" + name, std::ios::binary);
    if (!stream) throw std::runtime_error("no sample " + name);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return bytes_of(bytes);
}

FileBytes bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

FileBytes first(const FileBytes& bytes, std::size_t count) {
    return {bytes.begin(), bytes.begin() + std::ptrdiff_t(count)};
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& wrong) {
        return wrong.what();
    }
    return {};
}

bool is_like(const Image& image, int column, int row, Rgba colour, int tolerance) {
    const std::uint8_t* const pixel = image.pixel(column, row);
    const std::array wanted{colour.red, colour.green, colour.blue, colour.alpha};
    for (std::size_t channel = 0; channel < 4; ++channel)
        if (std::abs(pixel[channel] - wanted[channel]) > tolerance) return false;
    return true;
}

bool has_corners(const Image& image, Rgba top_left, Rgba top_right, Rgba bottom_left, Rgba bottom_right,
                 int tolerance) {
    const int right = image.width - 1, bottom = image.height - 1;
    return is_like(image, 0, 0, top_left, tolerance) && is_like(image, right, 0, top_right, tolerance) &&
           is_like(image, 0, bottom, bottom_left, tolerance) && is_like(image, right, bottom, bottom_right, tolerance);
}

}  // namespace drapeau::testing

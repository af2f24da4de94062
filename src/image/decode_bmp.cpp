// BMP by stb_image, which fills what a short file lacks: so its size is checked first.
#include "image/decoders.hpp"

#include <stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace drapeau {

namespace {

std::uint32_t number(Bytes bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint32_t(bytes[at + i]) << (8 * i);
    return value;
}

// Rows are padded to four bytes and stored without compression: stb_image reads no other.
void check_whole(Bytes bytes, std::int64_t width, std::int64_t height) {
    const std::int64_t rows_at = number(bytes, 10, 4);
    const std::int64_t bits = number(bytes, number(bytes, 14, 4) == 12 ? 24 : 28, 2);
    const std::int64_t row_bytes = (width * bits + 31) / 32 * 4;
    const std::int64_t there = std::max<std::int64_t>(0, std::int64_t(bytes.size()) - rows_at);
    if (row_bytes > 0 && there / row_bytes < height) fail_cut_short(there / row_bytes, height);
}

}  // namespace

Image decode_bmp(Bytes bytes, const std::stop_token& stop) {
    int width = 0, height = 0, channels = 0;
    const int count = int(bytes.size());
    if (bytes.size() < 30) fail_cut_in_header();
    if (!stbi_info_from_memory(bytes.data(), count, &width, &height, &channels)) fail_decoding(stbi_failure_reason());
    if (width <= 0 || height == 0) fail_decoding("it has no pixels");
    height = std::abs(height);
    check_memory(width, height, 4 + 4);  // stb_image's pixels and their copy
    check_whole(bytes, width, height);

    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), count, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) fail_decoding(stbi_failure_reason());
    check_wanted(stop);
    Image image = blank_image(width, height);
    std::copy_n(pixels.get(), image.rgba.size(), image.rgba.begin());
    return image;
}

}  // namespace drapeau

#include "image/image.hpp"

#include "error.hpp"
#include "image/image_file.hpp"
#include "output_file.hpp"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>

namespace drapeau {

namespace {

constexpr std::uintmax_t largest_file = 256u << 20;  // bytes

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
    std::error_code failure;
    const auto status = std::filesystem::status(file, failure);
    if (!std::filesystem::exists(status)) throw InputError(file.string() + ": no such image");
    if (std::filesystem::is_directory(status)) throw InputError(file.string() + ": a folder, not an image");
    if (!std::filesystem::is_regular_file(status)) throw InputError(file.string() + ": not an ordinary file");
    const auto size = std::filesystem::file_size(file, failure);
    if (failure) throw InputError(file.string() + ": cannot be read");
    if (size == 0) throw InputError(file.string() + ": an empty file, not an image");
    if (size > largest_file) throw InputError(file.string() + ": larger than 256 MB; use a smaller image");

    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file.string() + ": cannot be read (no permission?)");
    return {std::istreambuf_iterator<char>(in), {}};
}

void append_bytes(void* into, void* data, int size) {
    auto& bytes = *static_cast<std::vector<char>*>(into);
    bytes.insert(bytes.end(), static_cast<char*>(data), static_cast<char*>(data) + size);
}

}  // namespace

Image load_image(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_bytes(file);
    const ImageFormat format = image_format(bytes);
    if (format == ImageFormat::unknown)
        throw InputError(file.string() + ": not an image this program reads (PNG, JPEG, BMP or GIF)");
    if (!looks_whole(format, bytes)) throw InputError(file.string() + ": the image is cut short");

    // The size is known before decoding, so that an absurd one costs nothing.
    int width = 0, height = 0, channels = 0;
    const int count = int(bytes.size());
    if (!stbi_info_from_memory(bytes.data(), count, &width, &height, &channels))
        throw InputError(file.string() + ": a broken image (" + stbi_failure_reason() + ")");
    if (width > largest_image_side || height > largest_image_side)
        throw InputError(file.string() + ": " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels; at most " + std::to_string(largest_image_side) + " a side");

    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), count, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) throw InputError(file.string() + ": a broken or cut-short image (" + stbi_failure_reason() + ")");

    Image image{.width = width, .height = height, .rgba = {}};
    image.rgba.assign(pixels.get(), pixels.get() + std::size_t(width) * std::size_t(height) * 4);
    return shrunk_to(std::move(image), largest_kept_side);
}

Image shrunk_to(Image image, int side) {
    const int factor = (std::max(image.width, image.height) + side - 1) / side;
    if (factor <= 1) return image;
    Image small{.width = std::max(1, image.width / factor), .height = std::max(1, image.height / factor), .rgba = {}};
    small.rgba.resize(std::size_t(small.width) * std::size_t(small.height) * 4);
    for (int row = 0; row < small.height; ++row)
        for (int column = 0; column < small.width; ++column)
            for (int channel = 0; channel < 4; ++channel) {
                const int x1 = std::min(image.width, (column + 1) * factor);
                const int y1 = std::min(image.height, (row + 1) * factor);
                unsigned sum = 0, count = 0;
                for (int y = row * factor; y < y1; ++y)
                    for (int x = column * factor; x < x1; ++x, ++count)
                        sum += image.rgba[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * 4 +
                                          std::size_t(channel)];
                small.rgba[(std::size_t(row) * std::size_t(small.width) + std::size_t(column)) * 4 +
                           std::size_t(channel)] = std::uint8_t((sum + count / 2) / count);
            }
    return small;
}

void write_png(const std::filesystem::path& file, const Image& image) {
    std::vector<char> bytes;
    if (!stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 4, image.rgba.data(), image.width * 4))
        throw InputError(file.string() + ": the picture could not be encoded");
    write_file(file.string(), [&](const Append& append) { append({bytes.data(), bytes.size()}); });
}

}  // namespace drapeau

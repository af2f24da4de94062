#include "image/image_file.hpp"

#include "image/file_kind.hpp"
#include "io/error.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <fstream>
#include <new>
#include <string>
#include <system_error>

namespace drapeau {

namespace {

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file, const std::stop_token& stop) {
    std::error_code failure;
    const auto status = std::filesystem::status(file, failure);
    if (!std::filesystem::exists(status)) throw InputError("no such image");
    if (std::filesystem::is_directory(status)) throw InputError("a folder, not an image");
    if (!std::filesystem::is_regular_file(status)) throw InputError("not an ordinary file");
    const auto size = std::filesystem::file_size(file, failure);
    if (failure) throw InputError("cannot be read");
    if (size == 0) throw InputError("an empty file, not an image");
    if (size > largest_image_file)
        throw InputError("larger than " + memory_text(double(largest_image_file)) + "; use a smaller image");

    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot be read (no permission?)");
    std::vector<std::uint8_t> bytes(size);
    constexpr std::size_t piece = 4u << 20;  // bytes
    std::size_t there = 0;
    while (in && there < bytes.size()) {
        check_wanted(stop);
        in.read(reinterpret_cast<char*>(&bytes[there]), std::streamsize(std::min(piece, bytes.size() - there)));
        there += std::size_t(in.gcount());
    }
    bytes.resize(there);
    return bytes;
}

}  // namespace

Image decode_image(std::span<const std::uint8_t> bytes, const std::stop_token& stop) {
    const FileKind kind = file_kind(bytes);
    if (!kind.decode)
        throw InputError(std::string(kind.name) + ", which cannot be read; PNG, JPEG, WebP, SVG, GIF and BMP can");
    try {
        return shrunk_to(kind.decode(bytes, stop), largest_kept_side);
    } catch (const InputError& wrong) {
        throw InputError(std::string(kind.name) + ", " + wrong.what());
    }
}

Image load_image(const std::filesystem::path& file, const std::stop_token& stop) {
    const std::string name = one_line(file.string(), 1000);
    try {
        return decode_image(read_bytes(file, stop), stop);
    } catch (const InputError& wrong) {
        throw InputError(name + ": " + wrong.what());
    } catch (const std::bad_alloc&) {
        throw InputError(name + ": not enough memory to load this image; use a smaller one");
    }
}

}  // namespace drapeau

// PNG by libpng, row by row: the image itself is all that takes memory.
#include "image/decoders.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <new>
#include <utility>

namespace drapeau {

namespace {

struct Reading {
    png_structp png = nullptr;
    png_infop info = nullptr;
    Bytes rest;
    std::stop_token stop;
    bool at_end = false;  // libpng wanted more than there is
    char reason[120] = "";
    Image image;
    int passes = 1;
    int whole_rows = 0;

    Reading(Bytes bytes, const std::stop_token& asked) : rest(bytes), stop(asked) {}
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }
};

void read_some(png_structp png, png_bytep to, std::size_t count) {
    auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (count > reading.rest.size()) {
        reading.at_end = true;
        png_error(png, "the file ends");
    }
    std::copy_n(reading.rest.begin(), count, to);
    reading.rest = reading.rest.subspan(count);
}

void on_error(png_structp png, png_const_charp message) {
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    std::snprintf(reading.reason, sizeof reading.reason, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

// Errors of libpng jump back to setjmp: what they jump over owns nothing.

bool read_header(Reading& reading) {
    if (setjmp(png_jmpbuf(reading.png))) return false;
    png_set_read_fn(reading.png, &reading, read_some);
    png_set_compression_buffer_size(reading.png, 256);  // bytes read at once: of the last ones no row is made
    png_read_info(reading.png, reading.info);
    png_set_expand(reading.png);  // palettes, few bits and a transparent colour become 8-bit channels
    png_set_scale_16(reading.png);
    png_set_gray_to_rgb(reading.png);
    png_set_add_alpha(reading.png, 0xff, PNG_FILLER_AFTER);
    reading.passes = png_set_interlace_handling(reading.png);
    return true;
}

bool read_rows(Reading& reading) {
    if (setjmp(png_jmpbuf(reading.png))) return false;
    png_read_update_info(reading.png, reading.info);
    for (int pass = 1; pass <= reading.passes; ++pass)
        for (int row = 0; row < reading.image.height; ++row) {
            check_wanted(reading.stop);
            png_read_row(reading.png, reading.image.pixel(0, row), nullptr);
            if (pass == reading.passes) reading.whole_rows = row + 1;
        }
    return true;
}

}  // namespace

Image decode_png(Bytes bytes, const std::stop_token& stop) {
    Reading reading(bytes, stop);
    reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, on_error, on_warning);
    if (reading.png) reading.info = png_create_info_struct(reading.png);
    if (!reading.info) throw std::bad_alloc();

    if (!read_header(reading)) reading.at_end ? fail_cut_in_header() : fail_decoding(reading.reason);
    const auto width = png_get_image_width(reading.png, reading.info);
    const auto height = png_get_image_height(reading.png, reading.info);
    check_memory(width, height, 4);
    reading.image = blank_image(int(width), int(height));
    if (!read_rows(reading))
        reading.at_end ? fail_cut_short(reading.whole_rows, height) : fail_decoding(reading.reason);
    return std::move(reading.image);
}

}  // namespace drapeau

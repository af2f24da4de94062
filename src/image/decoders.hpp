// Decoders: from the bytes of a file of one kind to its image. A decoder knows the memory its picture takes before it
// begins. What is wrong is thrown as an InputError that continues "a JPEG picture, ...". Where the stop token is asked
// to stop, a decoder throws Abandoned within a few hundredths of a second.
#pragma once

#include "image/image.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

namespace drapeau {

using Bytes = std::span<const std::uint8_t>;
using Decode = Image(Bytes, const std::stop_token&);

Decode decode_png, decode_jpeg, decode_webp, decode_svg, decode_gif, decode_bmp;

/// decode_svg with another limit to the processor time a drawing may take.
Image draw_svg(Bytes bytes, int seconds, const std::stop_token& stop = {});

/// Throws Abandoned if the token says so.
void check_wanted(const std::stop_token& stop);

/// Throws if `bytes_per_pixel` (the decoder's own memory included) is more than largest_decoding_memory in all.
void check_memory(std::int64_t width, std::int64_t height, double bytes_per_pixel);

[[noreturn]] void fail_cut_short(std::int64_t rows, std::int64_t height);
[[noreturn]] void fail_cut_in_header();

/// `reason` is the library's own; it may be empty or null.
[[noreturn]] void fail_decoding(const char* reason);

}  // namespace drapeau

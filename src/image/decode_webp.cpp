// WebP by libwebp: a still picture, or the first frame of an animation on its target.
#include "image/decoders.hpp"

#include "io/error.hpp"

#include <webp/decode.h>
#include <webp/demux.h>

#include <algorithm>
#include <memory>
#include <new>

namespace drapeau {

namespace {

struct Delete {
    void operator()(WebPDemuxer* demuxer) const { WebPDemuxDelete(demuxer); }
    void operator()(WebPIDecoder* decoder) const { WebPIDelete(decoder); }
};

struct Frame {
    WebPIterator at{};

    explicit Frame(const WebPDemuxer* demuxer) {
        if (!WebPDemuxGetFrame(demuxer, 1, &at)) throw InputError("cut short: its first frame is not whole");
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    ~Frame() { WebPDemuxReleaseIterator(&at); }
};

}  // namespace

Image decode_webp(Bytes bytes, const std::stop_token& stop) {
    const WebPData data{bytes.data(), bytes.size()};
    WebPDemuxState state = WEBP_DEMUX_PARSE_ERROR;
    const std::unique_ptr<WebPDemuxer, Delete> demuxer(WebPDemuxPartial(&data, &state));
    if (state == WEBP_DEMUX_PARSE_ERROR) fail_decoding(nullptr);
    if (!demuxer || state == WEBP_DEMUX_PARSING_HEADER) fail_cut_in_header();

    const auto width = WebPDemuxGetI(demuxer.get(), WEBP_FF_CANVAS_WIDTH);
    const auto height = WebPDemuxGetI(demuxer.get(), WEBP_FF_CANVAS_HEIGHT);
    check_memory(width, height, 4 + 5);  // lossless: all its pixels, and its alpha, once more
    const Frame frame(demuxer.get());
    const WebPIterator& at = frame.at;
    if (at.x_offset < 0 || at.y_offset < 0 || at.width <= 0 || at.height <= 0 || at.x_offset + at.width > int(width) ||
        at.y_offset + at.height > int(height))
        fail_decoding("its first frame lies outside its target");

    Image image = blank_image(int(width), int(height));
    WebPDecoderConfig config;
    if (!WebPInitDecoderConfig(&config)) throw std::bad_alloc();
    config.output.colorspace = MODE_RGBA;
    config.output.is_external_memory = 1;
    std::uint8_t* const first = image.pixel(at.x_offset, at.y_offset);
    config.output.u.RGBA = {first, image.width * 4, std::size_t(image.rgba.data() + image.rgba.size() - first)};
    const std::unique_ptr<WebPIDecoder, Delete> decoder(WebPIDecode(nullptr, 0, &config));
    if (!decoder) throw std::bad_alloc();

    // Piece by piece, so that it can be abandoned.
    constexpr std::size_t piece = 256u << 10;  // bytes
    VP8StatusCode status = VP8_STATUS_SUSPENDED;
    for (std::size_t given = 0; given < at.fragment.size && status == VP8_STATUS_SUSPENDED;) {
        check_wanted(stop);
        given = std::min(at.fragment.size, given + piece);
        status = WebPIUpdate(decoder.get(), at.fragment.bytes, given);
    }
    if (status == VP8_STATUS_OK) return image;
    if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status != VP8_STATUS_SUSPENDED && status != VP8_STATUS_NOT_ENOUGH_DATA) fail_decoding(nullptr);
    int rows = 0;
    WebPIDecGetRGB(decoder.get(), &rows, nullptr, nullptr, nullptr);
    fail_cut_short(rows, at.height);
}

}  // namespace drapeau

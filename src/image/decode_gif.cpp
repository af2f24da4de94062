// GIF by giflib: the first frame on its target. What follows that frame is not looked at.
#include "image/decoders.hpp"

#include "io/error.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <memory>

namespace drapeau {

namespace {

struct Source {
    Bytes rest;
    bool at_end = false;  // giflib wanted more than there is
};

// After the last byte comes a zero, which ends a chain of blocks: so a file may end where its last block does.
int read_some(GifFileType* gif, GifByteType* to, int count) {
    auto& source = *static_cast<Source*>(gif->UserData);
    const std::size_t given = std::min(source.rest.size(), std::size_t(count));
    std::copy_n(source.rest.begin(), given, to);
    source.rest = source.rest.subspan(given);
    if (given == std::size_t(count)) return count;
    source.at_end = true;
    if (given > 0 || count != 1) return int(given);
    *to = 0;
    return 1;
}

struct Close {
    void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, Close>;

[[noreturn]] void fail_before_picture(const Source& source, int error) {
    source.at_end ? fail_cut_in_header() : fail_decoding(GifErrorString(error));
    throw InputError("damaged");
}

// Goes on to the first frame; gives its transparent colour.
int find_picture(GifFileType* gif, const Source& source) {
    int transparent = NO_TRANSPARENT_COLOR;
    for (;;) {
        GifRecordType record;
        if (DGifGetRecordType(gif, &record) == GIF_ERROR) fail_before_picture(source, gif->Error);
        if (record == TERMINATE_RECORD_TYPE) throw InputError("without a frame");
        if (record == IMAGE_DESC_RECORD_TYPE) break;
        int code;
        GifByteType* block;
        if (DGifGetExtension(gif, &code, &block) == GIF_ERROR) fail_before_picture(source, gif->Error);
        GraphicsControlBlock control;
        if (block && code == GRAPHICS_EXT_FUNC_CODE && DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
            transparent = control.TransparentColor;
        while (block)
            if (DGifGetExtensionNext(gif, &block) == GIF_ERROR) fail_before_picture(source, gif->Error);
    }
    if (DGifGetImageDesc(gif) == GIF_ERROR) fail_before_picture(source, gif->Error);
    return transparent;
}

void draw_row(const std::vector<GifPixelType>& indices, const ColorMapObject& colours, int transparent,
              std::uint8_t* to) {
    for (const GifPixelType index : indices) {
        if (index != transparent && index < colours.ColorCount) {
            const GifColorType& colour = colours.Colors[index];
            to[0] = colour.Red, to[1] = colour.Green, to[2] = colour.Blue, to[3] = 255;
        }
        to += 4;
    }
}

}  // namespace

Image decode_gif(Bytes bytes, const std::stop_token& stop) {
    Source source{.rest = bytes};
    int error = 0;
    const Gif gif(DGifOpen(&source, read_some, &error));
    if (!gif) fail_before_picture(source, error);
    const int transparent = find_picture(gif.get(), source);

    const GifImageDesc& frame = gif->Image;
    const ColorMapObject* const colours = frame.ColorMap ? frame.ColorMap : gif->SColorMap;
    if (!colours) throw InputError("without colours");
    if (frame.Width <= 0 || frame.Height <= 0) throw InputError("without pixels");
    const int width = std::max(gif->SWidth, frame.Left + frame.Width);
    const int height = std::max(gif->SHeight, frame.Top + frame.Height);
    check_memory(width, height, 4);

    Image image = blank_image(width, height);
    std::vector<GifPixelType> indices(std::size_t(frame.Width));
    struct Pass {
        int first, step;
    };
    constexpr Pass at_once[] = {{0, 1}}, interlaced[] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};
    int rows = 0;
    for (const auto [first, step] :
         frame.Interlace ? std::span<const Pass>(interlaced) : std::span<const Pass>(at_once))
        for (int row = first; row < frame.Height; row += step, ++rows) {
            check_wanted(stop);
            if (DGifGetLine(gif.get(), indices.data(), frame.Width) == GIF_ERROR) {
                if (source.at_end || gif->Error == D_GIF_ERR_EOF_TOO_SOON) fail_cut_short(rows, frame.Height);
                fail_decoding(GifErrorString(gif->Error));
            }
            draw_row(indices, *colours, transparent, image.pixel(frame.Left, frame.Top + row));
        }
    return image;
}

}  // namespace drapeau

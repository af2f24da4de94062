#include "image/file_kind.hpp"

#include <algorithm>
#include <string>

namespace drapeau {

namespace {

using namespace std::string_view_literals;

struct Magic {
    std::size_t at;
    std::string_view bytes;
    FileKind kind;
};

// The first that fits counts.
constexpr Magic magics[] = {
    {0, "\x89PNG\r\n\x1a\n"sv, {"a PNG picture", decode_png}},
    {0, "\xff\xd8\xff"sv, {"a JPEG picture", decode_jpeg}},
    {8, "WEBP"sv, {"a WebP picture", decode_webp}},
    {0, "GIF8"sv, {"a GIF picture", decode_gif}},
    {4, "ftypavi"sv, {"an AVIF picture"}},
    {4, "ftyphe"sv, {"a HEIC picture"}},
    {4, "ftypmif1"sv, {"a HEIC or AVIF picture"}},
    {4, "ftypmsf1"sv, {"a HEIC or AVIF picture"}},
    {4, "ftyp"sv, {"an MP4 or QuickTime film"}},
    {0, "\0\0\0\x0cJXL "sv, {"a JPEG XL picture"}},
    {0, "\xff\x0a"sv, {"a JPEG XL picture"}},
    {0, "\0\0\0\x0cjP  "sv, {"a JPEG 2000 picture"}},
    {0, "II*\0"sv, {"a TIFF picture"}},
    {0, "MM\0*"sv, {"a TIFF picture"}},
    {0, "8BPS"sv, {"a Photoshop picture"}},
    {0, "gimp xcf"sv, {"a GIMP picture"}},
    {0, "\0\0\1\0"sv, {"an icon (ICO)"}},
    {0, "\x1a\x45\xdf\xa3"sv, {"a Matroska or WebM film"}},
    {0, "%PDF-"sv, {"a PDF document"}},
    {0, "%!PS"sv, {"a PostScript document"}},
    {0, "PK\3\4"sv, {"a ZIP archive or an office document"}},
    {0, "\x1f\x8b"sv, {"a gzip archive (or a compressed SVG)"}},
    {0,
     "\x7f"
     "ELF"sv,
     {"a program"}},
    {0, "BM"sv, {"a BMP picture", decode_bmp}},
};

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& letter : lower)
        if (letter >= 'A' && letter <= 'Z') letter = char(letter - 'A' + 'a');
    return lower;
}

bool is_text(std::string_view bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](char byte) {
        const auto value = static_cast<unsigned char>(byte);
        return value < 32 && !(value >= '\t' && value <= '\r');
    });
}

// An HTML page may hold an SVG and the other way round: what comes first counts.
FileKind markup_kind(std::string_view beginning) {
    const std::string text = lower_case(beginning);
    const std::size_t html = std::min(text.find("<html"), text.find("<!doctype html"));
    const std::size_t svg = std::min(text.find("<svg"), text.find("http://www.w3.org/2000/svg"));
    if (svg < html) return {"an SVG picture", decode_svg};
    if (html != text.npos) return {"an HTML page"};
    return {"an XML text"};
}

}  // namespace

FileKind file_kind(Bytes bytes) {
    constexpr std::size_t looked_at = 1 << 16;  // drawing programs begin with long comments and definitions
    std::string_view beginning(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), looked_at));
    for (const Magic& magic : magics)
        if (beginning.size() >= magic.at && beginning.substr(magic.at).starts_with(magic.bytes)) return magic.kind;

    if (!is_text(beginning)) return {"a file of unknown kind"};
    if (beginning.starts_with("\xef\xbb\xbf")) beginning.remove_prefix(3);  // UTF-8's byte order mark
    beginning.remove_prefix(std::min(beginning.find_first_not_of(" \t\r\n\v\f"), beginning.size()));
    return beginning.starts_with('<') ? markup_kind(beginning) : FileKind{"a text"};
}

}  // namespace drapeau

// Image files: what browsers show is read, and what cannot be read is named.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "image_samples.hpp"
#include "io/error.hpp"
#include "scarce_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

int percentage_in(const std::string& message) {
    const std::size_t end = message.find(" % of its rows are there");
    REQUIRE(end != message.npos);
    return std::stoi(message.substr(message.rfind(' ', end - 1) + 1));
}

FileBytes with_behind(FileBytes bytes, std::string_view behind) {
    bytes.insert(bytes.end(), behind.begin(), behind.end());
    return bytes;
}

void put_16(FileBytes& bytes, std::size_t at, unsigned value, bool little_endian) {
    bytes[at + (little_endian ? 0 : 1)] = std::uint8_t(value & 0xff);
    bytes[at + (little_endian ? 1 : 0)] = std::uint8_t(value >> 8);
}

}  // namespace

TEST_CASE("a picture is the same in every format, whatever way it is stored") {
    const std::string exact = GENERATE("quarters.gif", "interlaced.gif", "quarters.bmp");
    const std::string nearly = GENERATE("quarters.jpg", "progressive.jpg", "inks.jpg", "lossy.webp", "animated.webp");
    for (const auto& [name, tolerance] : {std::pair(exact, 0), std::pair(nearly, lossy)}) {
        CAPTURE(name);
        const Image image = decode_image(sample(name));
        CHECK(image.width == 48);
        CHECK(image.height == 32);
        CHECK(has_quarters(image, tolerance));
    }
}

TEST_CASE("an interlaced GIF has its rows in their places") {
    CHECK(decode_image(sample("interlaced.gif")).rgba == decode_image(sample("quarters.gif")).rgba);
}

TEST_CASE("a grey picture without alpha is grey and opaque") {
    const Image image = decode_image(sample("grain.png"));
    const std::uint8_t* const pixel = image.pixel(5, 5);
    CHECK(pixel[0] == pixel[1]);
    CHECK(pixel[1] == pixel[2]);
    CHECK(pixel[3] == 255);
}

TEST_CASE("alpha is kept exactly, and colours are not multiplied by it") {
    const std::string name = GENERATE("alpha.png", "alpha.webp");
    CAPTURE(name);
    const Image image = decode_image(sample(name));
    for (int column = 0; column < 48; ++column) {
        const Rgba left_or_right = column < 24 ? red : green;
        CHECK(is_like(image, column, 0, {left_or_right.red, left_or_right.green, left_or_right.blue, column * 255 / 47},
                      0));
    }
    CHECK(is_like(image, 0, 31, blue, 0));
}

TEST_CASE("a picture without its end marker, or with other data behind it, is whole") {
    // The bytes of end markers: of JPEG two, of GIF the trailer and the empty block before it, of PNG the last chunk.
    const auto [name, marker] =
        GENERATE(std::pair("quarters.jpg", 2), std::pair("progressive.jpg", 2), std::pair("grain.jpg", 2),
                 std::pair("quarters.gif", 2), std::pair("grain.gif", 1), std::pair("alpha.png", 12));
    CAPTURE(name);
    const FileBytes whole = sample(name);
    const Image image = decode_image(whole);
    for (int bytes = 1; bytes <= marker; ++bytes)
        CHECK(decode_image(first(whole, whole.size() - std::size_t(bytes))).rgba == image.rgba);
    CHECK(decode_image(with_behind(whole, "a film of two seconds\xff\xda\xff\x3b")).rgba == image.rgba);
}

TEST_CASE("data behind a WebP or BMP picture changes nothing") {
    const std::string name = GENERATE("lossy.webp", "alpha.webp", "quarters.bmp");
    CAPTURE(name);
    CHECK(decode_image(with_behind(sample(name), "and more")).rgba == decode_image(sample(name)).rgba);
}

TEST_CASE("a picture cut short says how many of its rows are there") {
    const std::string name = GENERATE("grain.png", "grain.jpg", "grain.gif", "grain.webp", "quarters.bmp");
    const FileBytes whole = sample(name);
    int before = 0;
    for (const std::size_t part : {50u, 70u, 90u}) {
        const std::string message = error_of(first(whole, whole.size() * part / 100));
        CAPTURE(name, part, message);
        CHECK(says(message, "cut short"));
        const int percentage = percentage_in(message);
        CHECK(percentage >= before);
        // Headers take up to a quarter of these files, decoders hold back up to a half of WebP's rows.
        CHECK(percentage <= int(part));
        CHECK(percentage >= int(part) - 50);
        before = percentage;
    }
    CHECK(before > 0);
    CHECK(says(error_of(first(whole, 29)), "cut short"));
}

TEST_CASE("a progressive JPEG that ends after its first scan lacks detail, not rows") {
    const FileBytes whole = sample("progressive.jpg");
    // The markers that start scans.
    std::vector<std::size_t> scans;
    for (std::size_t i = 0; i + 1 < whole.size(); ++i)
        if (whole[i] == 0xff && whole[i + 1] == 0xda) scans.push_back(i);
    REQUIRE(scans.size() > 3);
    for (const std::size_t scan : {scans[2], scans[3], scans[3] + 11})
        CHECK(says(error_of(first(whole, scan)), "not in full detail"));
}

TEST_CASE("a JPEG is turned as its EXIF orientation says, in both byte orders") {
    const bool little_endian = GENERATE(false, true);
    const auto [orientation, corners] = GENERATE(table<int, std::array<Rgba, 4>>({
        {0, {red, green, blue, white}},
        {1, {red, green, blue, white}},
        {2, {green, red, white, blue}},
        {3, {white, blue, green, red}},
        {4, {blue, white, red, green}},
        {5, {red, blue, green, white}},
        {6, {blue, red, white, green}},
        {7, {white, green, blue, red}},
        {8, {green, white, red, blue}},
        {9, {red, green, blue, white}},
    }));
    CAPTURE(orientation, little_endian);
    // A segment: marker, length, "Exif", then TIFF: byte order, 42, where the directory is; one entry of it.
    FileBytes exif =
        bytes_of({"\xff\xe1\0\x22"
                  "Exif\0\0MM\0*\0\0\0\x08\0\1\x01\x12\0\3\0\0\0\1\0\0\0\0\0\0\0\0",
                  36});
    if (little_endian) {
        exif[10] = exif[11] = 'I';
        put_16(exif, 12, 42, true);
        put_16(exif, 14, 8, true), put_16(exif, 16, 0, true);
        put_16(exif, 18, 1, true), put_16(exif, 20, 0x0112, true), put_16(exif, 22, 3, true);
        put_16(exif, 24, 1, true), put_16(exif, 26, 0, true);
    }
    put_16(exif, 28, unsigned(orientation), little_endian);
    FileBytes file = sample("quarters.jpg");
    file.insert(file.begin() + 2, exif.begin(), exif.end());

    const Image image = decode_image(file);
    CHECK(image.width == (orientation >= 5 && orientation <= 8 ? 32 : 48));
    CHECK(has_corners(image, corners[0], corners[1], corners[2], corners[3], lossy));

    // Whatever offset or count it states, nothing beyond the segment is read.
    const auto at = GENERATE(std::size_t(14), std::size_t(16), std::size_t(18));
    for (const unsigned value : {0xffffu, 0x8000u, 30u, 1u}) {
        FileBytes hostile = file;
        put_16(hostile, 2 + at, value, little_endian);
        CHECK(decode_image(hostile).rgba.size() == std::size_t(48 * 32 * 4));
    }
}

TEST_CASE("a file is known by its content, not by its name") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.jpg";
    const FileBytes webp = sample("lossy.webp");
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(webp.data()), std::ssize(webp));
    const Image image = load_image(file);
    CHECK(has_quarters(image, lossy));
}

TEST_CASE("a file that is no readable picture is named for what it is") {
    const auto [beginning, name] = GENERATE(table<std::string, std::string>({
        {std::string("\0\0\0\x1c"
                     "ftypavif\0\0\0\0",
                     16),
         "an AVIF picture"},
        {std::string("\0\0\0\x1c"
                     "ftypheic\0\0\0\0",
                     16),
         "a HEIC picture"},
        {std::string("II*\0\x08\0\0\0", 8), "a TIFF picture"},
        {std::string("MM\0*\0\0\0\x08", 8), "a TIFF picture"},
        {std::string("\0\0\1\0\1\0", 6), "an icon"},
        {"8BPS", "a Photoshop picture"},
        {"%PDF-1.7\n", "a PDF document"},
        {"PK\3\4", "a ZIP archive"},
        {"\x1f\x8b\x08", "a gzip archive"},
        {"<!DOCTYPE html><html><svg xmlns=\"http://www.w3.org/2000/svg\"/></html>", "an HTML page"},
        {"\xef\xbb\xbf <?xml version=\"1.0\"?><plist/>", "an XML text"},
        {"version https://git-lfs.github.com/spec/v1\n", "a text"},
        {std::string("\x01\x02\x03\0", 4), "a file of unknown kind"},
    }));
    const std::string message = error_of(bytes_of(beginning));
    CHECK(message.starts_with(name));
    CHECK(says(message, "PNG, JPEG, WebP, SVG, GIF and BMP can"));
}

TEST_CASE("a picture that would take too much memory is refused before it is decoded") {
    // The sizes these files state are raised; of the pixels there are no more than before.
    FileBytes png = bytes_of({"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x40\0\0\0\x40\0\x08\2\0\0\0\x26\xaa\x87\xd3", 33});
    const FileBytes data = bytes_of({"\0\0\0\0IDAT\x35\xaf\x06\x1e", 12});
    png.insert(png.end(), data.begin(), data.end());
    FileBytes gif = sample("quarters.gif");
    put_16(gif, 6, 16384, true), put_16(gif, 8, 16384, true);
    FileBytes jpeg = sample("progressive.jpg");
    const std::string_view start_of_frame("\xff\xc2", 2);
    const auto at = std::size_t(std::search(jpeg.begin(), jpeg.end(), start_of_frame.begin(), start_of_frame.end(),
                                            [](std::uint8_t a, char b) { return a == std::uint8_t(b); }) -
                                jpeg.begin());
    put_16(jpeg, at + 5, 16384, false), put_16(jpeg, at + 7, 16384, false);
    FileBytes bmp = sample("quarters.bmp");
    put_16(bmp, 18, 16384, true), put_16(bmp, 22, 16384, true);
    FileBytes webp = bytes_of({"RIFF\0\x10\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\x3f\0\xff\x3f\0", 30});

    const ScarceMemory memory(1 << 20);
    for (const FileBytes& bomb : {png, gif, jpeg, bmp, webp}) {
        const std::string message = error_of(bomb);
        CHECK(says(message, "16384 x 16384 pixels, which take "));
        CHECK(says(message, "iB to decode; at most 512 MiB"));
    }
}

TEST_CASE("a large JPEG is halved while it is decoded") {
    const FileBytes wide = sample("wide.jpg");  // 12400 x 16 pixels
    const ScarceMemory memory(12400 * 16 * 4 / 4);
    const Image image = decode_image(wide);
    CHECK(image.width == 3100);
    CHECK(image.height == 4);
    CHECK(has_corners(image, red, green, red, green, lossy));
}

TEST_CASE("an image that nobody wants any more is abandoned") {
    const std::string name = GENERATE("alpha.png", "grain.jpg", "progressive.jpg", "inks.jpg", "lossy.webp",
                                      "alpha.webp", "quarters.gif", "interlaced.gif", "quarters.bmp");
    CAPTURE(name);
    std::stop_source source;
    CHECK_NOTHROW(decode_image(sample(name), source.get_token()));
    source.request_stop();
    CHECK_THROWS_AS(decode_image(sample(name), source.get_token()), Abandoned);
}

TEST_CASE("an image has holes where it is more transparent than opaque") {
    Image image = blank_image(3, 2);
    for (std::uint8_t& value : image.rgba) value = 255;
    CHECK(!has_holes(image));
    image.pixel(2, 1)[3] = 128;
    CHECK(!has_holes(image));
    image.pixel(2, 1)[3] = 127;
    CHECK(has_holes(image));
}

TEST_CASE("transparent pixels give an average no colour") {
    Image image = blank_image(2, 2);
    image.rgba = {200, 100, 50, 255, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0};
    CHECK(is_like(shrunk_to(image, 1), 0, 0, {200, 100, 50, 64}, 0));
}

TEST_CASE("too little memory for a picture is one clear message") {
    const std::string name = GENERATE("alpha.png", "quarters.jpg", "lossy.webp", "quarters.gif", "quarters.bmp");
    const std::filesystem::path file = std::filesystem::path(DRAPEAU_TEST_INPUTS) / name;
    const ScarceMemory memory(48 * 32 * 4);
    CHECK(message_of([&] { load_image(file); }) ==
          file.string() + ": not enough memory to load this image; use a smaller one");
}

TEST_CASE("a damaged file of any kind is an image or one message with a reason") {
    const std::string name =
        GENERATE("alpha.png", "grain.png", "quarters.jpg", "progressive.jpg", "inks.jpg", "lossy.webp", "alpha.webp",
                 "animated.webp", "quarters.gif", "interlaced.gif", "quarters.bmp");
    const FileBytes whole = sample(name);
    std::mt19937 random(7);
    const auto below = [&](std::size_t count) { return std::size_t(random() % count); };
    for (int round = 0; round < 1000; ++round) {
        FileBytes damaged = whole;
        // Every other round in the header, where the meaning is.
        const std::size_t range = round % 2 ? damaged.size() : std::min<std::size_t>(64, damaged.size());
        for (std::size_t flips = below(4); flips > 0; --flips) damaged[below(range)] ^= std::uint8_t(1u << below(8));
        if (round % 3 == 0) damaged.resize(1 + below(damaged.size()));
        try {
            const Image image = decode_image(damaged);
            CHECK(image.rgba.size() == std::size_t(image.width) * std::size_t(image.height) * 4);
            CHECK(!image.rgba.empty());
        } catch (const InputError& wrong) {
            const std::string message = wrong.what();
            CAPTURE(name, round, message);
            CHECK(message.size() > 10);
            CHECK(message.find("()") == message.npos);
            CHECK(message.back() != ' ');
            CHECK(message.back() != ':');
        }
    }
}

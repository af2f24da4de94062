// JPEG by libjpeg-turbo. Its warnings tell a picture that lacks data from one that lacks only its end marker.
#include "image/decoders.hpp"

#include "image/exif_orientation.hpp"
#include "image/image_file.hpp"
#include "io/error.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <numeric>
#include <utility>

#include <jpeglib.h>

#include <jerror.h>

namespace drapeau {

namespace {

constexpr int max_scans = 200;  // a file of many empty scans would keep the decoder busy for hours

struct Reading {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf escape;
    std::stop_token stop;
    char reason[JMSG_LENGTH_MAX] = "";
    bool at_end = false;      // libjpeg wanted more than there is
    bool lacks_data = false;  // ... to decode the picture
    int last_scan = 0;        // then: the scan that lacks data,
    std::int64_t rows = 0;    // and the rows that scan has whole
    Image image;

    explicit Reading(const std::stop_token& asked) : stop(asked) {}
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    ~Reading() { jpeg_destroy_decompress(&jpeg); }
};

Reading& reading_of(j_common_ptr jpeg) {
    return *static_cast<Reading*>(jpeg->client_data);
}

void on_error(j_common_ptr jpeg) {
    Reading& reading = reading_of(jpeg);
    jpeg->err->format_message(jpeg, reading.reason);
    std::longjmp(reading.escape, 1);
}

void on_message(j_common_ptr jpeg, int level) {
    if (level >= 0) return;  // not a warning
    Reading& reading = reading_of(jpeg);
    if (jpeg->err->msg_code == JWRN_JPEG_EOF) reading.at_end = true;
    // The arithmetic decoder gives no other warning than that the file ends.
    const bool lacks_data = jpeg->err->msg_code == JWRN_HIT_MARKER || (reading.at_end && reading.jpeg.arith_code);
    if (!lacks_data || reading.lacks_data) return;
    reading.lacks_data = true;
    reading.last_scan = reading.jpeg.input_scan_number;
    const std::int64_t rows = std::int64_t(reading.jpeg.input_iMCU_row) * reading.jpeg.max_v_samp_factor * DCTSIZE;
    reading.rows = std::min<std::int64_t>(rows, reading.jpeg.image_height);
}

void on_progress(j_common_ptr jpeg) {
    Reading& reading = reading_of(jpeg);
    if (reading.stop.stop_requested()) std::longjmp(reading.escape, 1);
    if (reading.jpeg.input_scan_number <= max_scans) return;
    std::snprintf(reading.reason, sizeof reading.reason, "more than %d scans", max_scans);
    std::longjmp(reading.escape, 1);
}

// Errors of libjpeg jump back to setjmp: what they jump over owns nothing.

bool read_header(Reading& reading, Bytes bytes) {
    if (setjmp(reading.escape)) return false;
    jpeg_decompress_struct& jpeg = reading.jpeg;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
    jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xffff);
    jpeg_read_header(&jpeg, TRUE);

    const bool inks = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    jpeg.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
    // Halved while it is decoded, as far as that gives the same size as shrinking afterwards.
    const int side = int(std::max(jpeg.image_width, jpeg.image_height));
    jpeg.scale_num = 1;
    jpeg.scale_denom = unsigned(std::gcd((side - 1) / largest_kept_side + 1, 8));
    jpeg_calc_output_dimensions(&jpeg);
    return true;
}

bool start(Reading& reading) {
    if (setjmp(reading.escape)) return false;
    jpeg_start_decompress(&reading.jpeg);  // reads all scans if there are several
    return true;
}

bool read_rows(Reading& reading) {
    if (setjmp(reading.escape)) return false;
    jpeg_decompress_struct& jpeg = reading.jpeg;
    while (jpeg.output_scanline < jpeg.output_height) {
        check_wanted(reading.stop);
        JSAMPROW row = reading.image.pixel(0, int(jpeg.output_scanline));
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    return true;
}

// Pixels, and with several scans two bytes for every coefficient.
double bytes_per_pixel(const jpeg_decompress_struct& jpeg) {
    const double pixels = double(jpeg.image_width) * jpeg.image_height;
    double bytes = 4.0 * jpeg.output_width * jpeg.output_height;
    for (int i = 0; i < jpeg.num_components && jpeg_has_multiple_scans(const_cast<j_decompress_ptr>(&jpeg)); ++i)
        bytes += 2.0 * DCTSIZE2 * jpeg.comp_info[i].width_in_blocks * jpeg.comp_info[i].height_in_blocks;
    return bytes / pixels;
}

// A progressive file that ends between two scans lacks no data, but precision: bits that no scan gave.
bool lacks_scans(const Reading& reading) {
    const jpeg_decompress_struct& jpeg = reading.jpeg;
    if (!reading.at_end || !jpeg.coef_bits) return false;
    for (int component = 0; component < jpeg.num_components; ++component)
        for (const int bits : jpeg.coef_bits[component])
            if (bits != 0) return true;
    return false;
}

[[noreturn]] void fail_lacking_detail() {
    throw InputError("cut short: all its rows are there, but not in full detail");
}

void check_whole(const Reading& reading) {
    if (lacks_scans(reading) || (reading.lacks_data && reading.last_scan > 1)) fail_lacking_detail();
    if (reading.lacks_data) fail_cut_short(reading.rows, reading.jpeg.image_height);
}

// After an error of libjpeg; at the file's end it takes what a marker lacks for an error of the marker.
[[noreturn]] void fail(const Reading& reading) {
    check_wanted(reading.stop);
    if (!reading.at_end) fail_decoding(reading.reason);
    reading.jpeg.input_scan_number > 1 ? fail_lacking_detail() : fail_cut_in_header();
}

// Adobe's programs store the light that the inks let through, others the ink.
void inks_to_colours(Image& image, bool stored_as_light) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        std::uint8_t* const pixel = &image.rgba[i];
        for (int ink = 0; ink < 4 && !stored_as_light; ++ink) pixel[ink] = std::uint8_t(255 - pixel[ink]);
        for (int ink = 0; ink < 3; ++ink) pixel[ink] = std::uint8_t((pixel[ink] * pixel[3] + 127) / 255);
        pixel[3] = 255;
    }
}

int orientation_of(const jpeg_decompress_struct& jpeg) {
    for (const jpeg_marker_struct* marker = jpeg.marker_list; marker; marker = marker->next)
        if (const int orientation = exif_orientation({marker->data, marker->data_length}); orientation != 1)
            return orientation;
    return 1;
}

}  // namespace

Image decode_jpeg(Bytes bytes, const std::stop_token& stop) {
    Reading reading(stop);
    jpeg_decompress_struct& jpeg = reading.jpeg;
    jpeg.err = jpeg_std_error(&reading.errors);
    jpeg.client_data = &reading;
    reading.errors.error_exit = on_error;
    reading.errors.emit_message = on_message;
    reading.progress.progress_monitor = on_progress;

    if (!read_header(reading, bytes)) fail(reading);
    check_memory(jpeg.image_width, jpeg.image_height, bytes_per_pixel(jpeg));
    jpeg.progress = &reading.progress;
    if (!start(reading)) fail(reading);
    check_whole(reading);
    reading.image = blank_image(int(jpeg.output_width), int(jpeg.output_height));
    if (!read_rows(reading)) fail(reading);
    check_whole(reading);

    if (jpeg.out_color_space == JCS_CMYK) inks_to_colours(reading.image, jpeg.saw_Adobe_marker);
    return turned(shrunk_to(std::move(reading.image), largest_kept_side), orientation_of(jpeg));
}

}  // namespace drapeau

#include "image/decoders.hpp"

#include "image/image_file.hpp"
#include "io/error.hpp"
#include "io/text.hpp"

namespace drapeau {

void check_wanted(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Abandoned();
}

void check_memory(std::int64_t width, std::int64_t height, double bytes_per_pixel) {
    const double bytes = double(width) * double(height) * bytes_per_pixel;
    if (bytes > double(largest_decoding_memory))
        throw InputError(std::to_string(width) + " x " + std::to_string(height) + " pixels, which take " +
                         memory_text(bytes) + " to decode; at most " + memory_text(double(largest_decoding_memory)));
}

void fail_cut_short(std::int64_t rows, std::int64_t height) {
    throw InputError("cut short: " + std::to_string(100 * rows / height) + " % of its rows are there");
}

void fail_cut_in_header() {
    throw InputError("cut short: it ends before its picture begins");
}

void fail_decoding(const char* reason) {
    std::string known = reason ? reason : "";
    known.erase(known.find_last_not_of(" \n") + 1);
    known = one_line(known, 200);
    throw InputError("damaged or unusual: " + (known.empty() ? "it cannot be decoded" : known));
}

}  // namespace drapeau

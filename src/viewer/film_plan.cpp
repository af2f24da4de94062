#include "film_plan.hpp"

#include "film.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace drapeau {

namespace {

constexpr double longest_blend = 1.0;       // s
constexpr double largest_gif = 2147483648;  // bytes of frames: its colours are chosen from all of them at once

[[noreturn]] void refuse(const FilmPlan& plan, const std::string& why) {
    throw InputError(one_line(plan.file.string(), 1000) + ": " + why);
}

// A gif counts in hundredths of a second, and no player shows a picture for a single one.
bool is_gif_rate(double rate) {
    const double hundredths = 100.0 / rate;
    return hundredths >= 2.0 && std::abs(hundredths - std::round(hundredths)) < 1e-9;
}

void check_gif(const FilmPlan& plan) {
    if (!is_gif_rate(plan.rate))
        refuse(plan, "a gif shows each frame for whole hundredths of a second, so at 50, 25, 20 or 10 frames/s, not " +
                         shortest(plan.rate));
    const double bytes = 4.0 * plan.width * plan.height * double(plan.frames());
    if (bytes > largest_gif)
        refuse(plan, "a gif of " + std::to_string(plan.frames()) + " frames of this size would need " +
                         memory_text(bytes) + " of memory; a smaller or shorter one, webm or mp4 needs less");
}

}  // namespace

long long FilmPlan::frames() const {
    return std::max(1LL, std::llround(seconds * rate));
}

double FilmPlan::time_of(long long frame) const {
    return from + double(frame) / rate;
}

long long FilmPlan::blended() const {
    return loop ? std::min(std::llround(longest_blend * rate), frames() / 2) : 0;
}

// w = 3 s^2 - 2 s^3: the motion passes over without a kink. It would reach 1 at the frame after the last, which is the
// first again.
double FilmPlan::share_of_beginning(long long frame) const {
    const long long whole = frame - (frames() - blended());
    if (whole <= 0) return 0.0;
    const double s = double(whole) / double(blended());
    return s * s * (3.0 - 2.0 * s);
}

double usual_film_rate(const std::filesystem::path& file) {
    return ending_of(file) == ".gif" ? 25.0 : 60.0;
}

void check_times(const FilmPlan& plan) {
    if (!(plan.rate >= 1.0 && plan.rate <= max_film_rate))
        throw InputError("a film has from 1 to " + rounded(max_film_rate, 3) + " frames/s, not " + shortest(plan.rate));
    if (!(plan.seconds > 0.0) || !(plan.seconds * plan.rate <= double(max_film_frames)))
        throw InputError("a film has from 1 to " + std::to_string(max_film_frames) + " frames; " +
                         shortest(plan.seconds) + " s at " + shortest(plan.rate) + " frames/s is not that");
    if (!(plan.from >= 0.0 && plan.from <= max_swing_in))
        throw InputError("a film begins from 0 to " + rounded(max_swing_in, 4) + " s after the run, not " +
                         shortest(plan.from) + " s");
    const double before = double(plan.blended()) / plan.rate;
    if (plan.loop && plan.frames() < 4) throw InputError("a film of fewer than 4 frames cannot loop");
    if (plan.loop && plan.from < before)
        throw InputError("a film that loops passes into the " + rounded(before, 3) +
                         " s before its first frame, so it begins that much after the run at the earliest, not " +
                         shortest(plan.from) + " s");
}

void check_film(const FilmPlan& plan) {
    const FilmFormat& format = film_format(plan.file);
    check_times(plan);
    if (plan.transparent && !format.alpha)
        refuse(plan, "films of this format are not transparent; " + transparent_formats() + " are");
    const bool odd = plan.width % 2 != 0 || plan.height % 2 != 0;
    if (odd && format.even && !plan.transparent)
        refuse(plan, "this format needs even sides, such as " + std::to_string(plan.width + plan.width % 2) + "x" +
                         std::to_string(plan.height + plan.height % 2));
    if (ending_of(plan.file) == ".gif") check_gif(plan);
}

}  // namespace drapeau

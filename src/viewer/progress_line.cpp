#include "progress_line.hpp"

#include "io/text.hpp"

#include <cstdio>

#include <unistd.h>

namespace drapeau {

std::string progress_text(const FilmPlan& plan, long long written, double seconds) {
    const long long frames = plan.frames();
    std::string text = one_line(plan.file.string(), 40) + ": " + std::to_string(written) + " of " +
                       counted(std::size_t(frames), "frame") + ", " + std::to_string(100 * written / frames) + " %";
    if (written == frames) return text;
    // The first frames wait for the run to begin and ffmpeg to start.
    if (written > 2) text += ", " + rounded(seconds * double(frames - written) / double(written), 2) + " s left";
    return text;
}

ProgressLine::ProgressLine(const FilmPlan& plan) : plan_(plan), shown_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(long long written) {
    if (!shown_ || written == written_) return;
    written_ = written;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    std::fprintf(stderr, "\r\x1b[K%s", progress_text(plan_, written, passed.count()).c_str());
}

void ProgressLine::end() {
    if (shown_ && written_ >= 0) std::fputc('\n', stderr);
}

}  // namespace drapeau

#include "film.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drapeau {

namespace {

// Even sides, as most codecs want. Unless told, ffmpeg converts by BT.601 and says nothing of it.
constexpr const char* video =
    "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,"
    "format=yuv420p,setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709";
constexpr const char* palette_of_its_own = "fps=25,split[a][b];[a]palettegen[p];[b][p]paletteuse";

const std::vector<std::string> marks{"-color_range",     "tv",    "-colorspace", "bt709",
                                     "-color_primaries", "bt709", "-color_trc",  "bt709"};
const std::vector<std::string> h264{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"};

struct Format {
    std::string ending;
    std::string filter;
    std::vector<std::string> codec;  // options; empty: ffmpeg's choice for the ending
};

const std::vector<Format> formats{{".mp4", video, h264},
                                  {".mov", video, h264},
                                  {".mkv", video, {"-c:v", "libx264", "-crf", "18"}},
                                  {".webm", video, {}},
                                  {".gif", palette_of_its_own, {}}};

const Format& format_of(const std::filesystem::path& file) {
    const auto found =
        std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.ending == ending_of(file); });
    if (found != formats.end()) return *found;
    std::string allowed;
    for (const Format& format : formats)
        allowed += (allowed.empty() ? "" : &format == &formats.back() ? " or " : ", ") + format.ending;
    throw InputError("--film = " + one_line(file.string(), 1000) + ": " + allowed +
                     " is allowed, the ending chooses the format");
}

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};

char unfinished_film[PATH_MAX];

// A film takes minutes: signals do not wait for it, so one that ends the program removes what is not finished.
extern "C" void remove_film_and_end(int signal) {
    unlink(unfinished_film);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// A signal that the program was started to ignore stays ignored.
void replace_handler(void (*from)(int), void (*to)(int)) {
    for (const int signal : ending_signals) {
        const auto before = std::signal(signal, to);
        if (before != from) std::signal(signal, before);
    }
}

}  // namespace

void check_film_name(const std::filesystem::path& file) {
    format_of(file);
}

Film::Film(const std::filesystem::path& file, int width, int height, int frames_per_second)
    : file_(file), output_(file.string()), width_(width), height_(height) {
    const Format& format = format_of(file);
    complaints_ = memfd_create("ffmpeg", MFD_CLOEXEC);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw InputError("--film: no pipe to ffmpeg could be made");
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    std::vector<std::string> words{"ffmpeg",
                                   "-loglevel",
                                   "error",
                                   "-xerror",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "rgba",
                                   "-s",
                                   size,
                                   "-r",
                                   std::to_string(frames_per_second),
                                   "-i",
                                   "pipe:0",
                                   "-vf",
                                   format.filter};
    words.insert(words.end(), format.codec.begin(), format.codec.end());
    if (format.filter == video) words.insert(words.end(), marks.begin(), marks.end());
    words.push_back(output_.path().string());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    if (complaints_ >= 0) posix_spawn_file_actions_adddup2(&actions, complaints_, STDERR_FILENO);
    const int failure = posix_spawnp(&ffmpeg_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    pipe_ = ends[1];
    if (failure == 0) {
        std::snprintf(unfinished_film, sizeof unfinished_film, "%s", output_.path().c_str());
        replace_handler(SIG_DFL, remove_film_and_end);
        return;
    }
    ffmpeg_ = -1;
    close(std::exchange(pipe_, -1));
    if (complaints_ >= 0) close(complaints_);
    throw InputError(std::string("--film needs ffmpeg, which could not be started: ") + std::strerror(failure));
}

Film::~Film() {
    end();
    if (complaints_ >= 0) close(complaints_);
    replace_handler(remove_film_and_end, SIG_DFL);
}

void Film::add(const Image& frame) {
    if (frame.width != width_ || frame.height != height_) return;
    std::size_t written = 0;
    while (written < frame.rgba.size()) {
        const ssize_t count = write(pipe_, frame.rgba.data() + written, frame.rgba.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) fail();
        written += std::size_t(count);
    }
}

// The first line that ffmpeg complained in is the cause, the others what followed from it.
void Film::fail() {
    end();
    std::string said(1000, '\0');
    const ssize_t count = pread(complaints_, said.data(), said.size(), 0);
    said.resize(count > 0 ? std::size_t(count) : 0);
    said.resize(std::min(said.find('\n'), said.size()));
    throw InputError("--film = " + one_line(file_.string(), 1000) + ": ffmpeg could not make it" +
                     (said.empty() ? "" : ": " + one_line(said, 300)));
}

int Film::end() {
    if (pipe_ >= 0) close(std::exchange(pipe_, -1));
    if (ffmpeg_ < 0) return 0;
    int status = 0;
    waitpid(std::exchange(ffmpeg_, -1), &status, 0);
    return status;
}

void Film::finish() {
    if (end() != 0) fail();
    output_.finish();
}

}  // namespace drapeau

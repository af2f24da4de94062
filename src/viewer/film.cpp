#include "film.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/text.hpp"
#include "numbered_name.hpp"

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
const std::string with_alpha =
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,"
    "format=FORMAT,setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709";
constexpr const char* palette_of_its_own = "split[a][b];[a]palettegen[p];[b][p]paletteuse";
constexpr const char* palette_with_alpha =
    "split[a][b];[a]palettegen=reserve_transparent=1[p];[b][p]paletteuse=alpha_threshold=128";

const std::vector<std::string> marks{"-color_range",     "tv",    "-colorspace", "bt709",
                                     "-color_primaries", "bt709", "-color_trc",  "bt709"};
const std::vector<std::string> h264{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"};
const std::vector<std::string> vp9{"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-cpu-used", "4", "-row-mt", "1"};
const std::vector<std::string> prores{"-c:v", "prores_ks", "-profile:v", "4444", "-alpha_bits", "16"};

std::string alpha_in(const std::string& pixels) {
    std::string filter = with_alpha;
    return filter.replace(filter.find("FORMAT"), 6, pixels);
}

const std::vector<FilmFormat>& formats() {
    static const std::vector<FilmFormat> all{
        {.ending = ".mp4", .filter = video, .codec = h264},
        {.ending = ".mov",
         .filter = video,
         .codec = h264,
         .alpha_filter = alpha_in("yuva444p10le"),
         .alpha_codec = prores,
         .alpha = true},
        {.ending = ".mkv", .filter = video, .codec = {"-c:v", "libx264", "-crf", "18"}},
        {.ending = ".webm",
         .filter = video,
         .codec = vp9,
         .alpha_filter = alpha_in("yuva420p"),
         .alpha_codec = vp9,
         .alpha = true},
        {.ending = ".gif",
         .filter = palette_of_its_own,
         .codec = {},
         .alpha_filter = palette_with_alpha,
         .alpha = true,
         .even = false}};
    return all;
}

const FilmFormat pictures{.ending = ".png", .filter = {}, .codec = {}, .alpha = true, .even = false};

const FilmFormat* known_format(const std::filesystem::path& file) {
    const auto& all = formats();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const FilmFormat& f) { return f.ending == ending_of(file); });
    return found != all.end() ? &*found : nullptr;
}

std::string all_endings(const std::string& last_word) {
    std::string allowed;
    for (const FilmFormat& format : formats())
        allowed += (allowed.empty() ? "" : &format == &formats().back() ? last_word : ", ") + format.ending;
    return allowed;
}

std::vector<std::string> command(const FilmSettings& settings, const std::filesystem::path& into) {
    const FilmFormat& format = film_format(settings.file);
    // What a gif has no time for is left out.
    const bool fewer = format.ending == ".gif" && settings.rate > 50.0;
    std::vector<std::string> words{
        "ffmpeg",
        "-loglevel",
        "error",
        "-xerror",
        "-y",
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgba",
        "-s",
        std::to_string(settings.width) + "x" + std::to_string(settings.height),
        "-r",
        shortest(settings.rate),
        "-i",
        "pipe:0",
        "-vf",
        (fewer ? "fps=25," : "") + (settings.transparent ? format.alpha_filter : format.filter)};
    const auto& codec = settings.transparent ? format.alpha_codec : format.codec;
    words.insert(words.end(), codec.begin(), codec.end());
    if (format.ending != ".gif") words.insert(words.end(), marks.begin(), marks.end());
    words.push_back(into.string());
    return words;
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

const FilmFormat& film_format(const std::filesystem::path& file) {
    const std::string name = one_line(file.string(), 1000);
    if (means_sequence(file)) {
        check_numbered(file);
        if (ending_of(file) == ".png") return pictures;
        throw InputError(name + ": a sequence is one of pictures, such as frames-%04d.png");
    }
    if (const FilmFormat* known = known_format(file)) return *known;
    const bool picture = ending_of(file) == ".png";
    throw InputError(name + ": " +
                     (picture ? "one picture; a sequence is named with a number's place, such as frames-%04d.png"
                              : all_endings(", ") + " or frames-%04d.png is allowed, the ending chooses the format"));
}

std::string transparent_formats() {
    std::string allowed;
    for (const FilmFormat& format : formats())
        if (format.alpha) allowed += format.ending + ", ";
    return allowed + "frames-%04d.png";
}

void check_film_name(const std::filesystem::path& file, const std::string& asked_by) {
    if (known_format(file)) return;
    throw InputError(asked_by + " = " + one_line(file.string(), 1000) + ": " + all_endings(" or ") +
                     " is allowed, the ending chooses the format");
}

Film::Film(const FilmSettings& settings) : settings_(settings), output_(settings.file.string()) {
    complaints_ = memfd_create("ffmpeg", MFD_CLOEXEC);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw InputError(name() + ": no pipe to ffmpeg could be made");
    std::vector<std::string> words = command(settings, output_.path());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    if (complaints_ >= 0) posix_spawn_file_actions_adddup2(&actions, complaints_, STDERR_FILENO);
    // A group of its own: Ctrl+C in a terminal is for this program, which removes what ffmpeg leaves.
    posix_spawnattr_t group;
    posix_spawnattr_init(&group);
    posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
    const int failure = posix_spawnp(&ffmpeg_, "ffmpeg", &actions, &group, arguments.data(), environ);
    posix_spawnattr_destroy(&group);
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
    throw InputError((settings_.asked_by.empty() ? "a film" : settings_.asked_by) +
                     " needs ffmpeg, which could not be started: " + std::strerror(failure));
}

Film::~Film() {
    give_up();
    end();
    if (complaints_ >= 0) close(complaints_);
    replace_handler(remove_film_and_end, SIG_DFL);
}

void Film::add(const Image& frame) {
    if (frame.width != settings_.width || frame.height != settings_.height) return;
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
    throw InputError(name() + ": ffmpeg could not make it" + (said.empty() ? "" : ": " + one_line(said, 300)));
}

std::string Film::name() const {
    const std::string file = one_line(settings_.file.string(), 1000);
    return settings_.asked_by.empty() ? file : settings_.asked_by + " = " + file;
}

int Film::end() {
    if (pipe_ >= 0) close(std::exchange(pipe_, -1));
    if (ffmpeg_ < 0) return 0;
    // Until it is waited for, its number is nobody else's.
    siginfo_t ended{};
    while (waitid(P_PID, id_t(ffmpeg_), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
    }
    const std::lock_guard lock(mutex_);
    int status = 0;
    waitpid(std::exchange(ffmpeg_, -1), &status, 0);
    return status;
}

void Film::give_up() {
    const std::lock_guard lock(mutex_);
    if (ffmpeg_ > 0) kill(ffmpeg_, SIGKILL);
}

void Film::finish() {
    if (end() != 0) fail();
    output_.finish();
}

}  // namespace drapeau

#include "scene_watch.hpp"

#include <sys/stat.h>

namespace drapeau {

void SceneWatch::begin(const std::filesystem::path& file) {
    file_ = file;
    accept();
}

void SceneWatch::accept() {
    known_ = last_ = look();
}

std::optional<SceneWatch::Stamp> SceneWatch::look() const {
    struct stat found {};
    if (file_.empty() || stat(file_.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return {};
    return Stamp{.seconds = found.st_mtim.tv_sec,
                 .nanoseconds = found.st_mtim.tv_nsec,
                 .bytes = std::uintmax_t(found.st_size),
                 .inode = found.st_ino,
                 .device = found.st_dev};
}

bool SceneWatch::changed(double now) {
    if (file_.empty() || now - looked_ < pause) return false;
    looked_ = now;
    const auto seen = look();
    const bool is_whole = seen && seen->bytes > 0 && seen == last_;
    last_ = seen;
    if (!is_whole || seen == known_) return false;
    known_ = seen;
    return true;
}

}  // namespace drapeau

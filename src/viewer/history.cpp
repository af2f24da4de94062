#include "history.hpp"

#include "scene_difference.hpp"

#include <utility>

namespace drapeau {

void History::begin(const Entry& now) {
    *this = {};
    now_ = now;
}

void History::keep(std::deque<Entry>& entries, const Entry& entry) {
    entries.push_back(entry);
    if (entries.size() > max_changes) entries.pop_front();
}

void History::observe(const Entry& now, unsigned control) {
    if (control != control_) control_ = 0;
    if (now.scene != now_.scene) {
        if (!control_) keep(past_, now_);
        future_.clear();
        control_ = control;
    }
    now_ = now;
}

void History::amend(const Entry& now) {
    now_ = now;
    if (past_.empty() || past_.back().scene != now.scene) return;
    past_.pop_back();
    control_ = 0;
}

std::optional<History::Entry> History::undo() {
    if (past_.empty()) return {};
    keep(future_, std::exchange(now_, past_.back()));
    past_.pop_back();
    control_ = 0;
    return now_;
}

std::optional<History::Entry> History::redo() {
    if (future_.empty()) return {};
    keep(past_, std::exchange(now_, future_.back()));
    future_.pop_back();
    control_ = 0;
    return now_;
}

std::string History::undone() const {
    return past_.empty() ? "" : difference_between(past_.back().scene, now_.scene);
}

std::string History::redone() const {
    return future_.empty() ? "" : difference_between(now_.scene, future_.back().scene);
}

}  // namespace drapeau

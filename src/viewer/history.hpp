// History: the settings as they were before each change, to go back to and forth again. It looks at the scene once a
// frame and sees by itself what changed, whatever changed it. What is changed while the mouse holds one control is one
// change.
#pragma once

#include "scene/scene.hpp"

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

class History {
public:
    static constexpr std::size_t max_changes = 200;

    /// The settings, and the image on the flag, which the scene only names.
    struct Entry {
        Scene scene;
        std::filesystem::path image;  // empty: none
    };

    /// Forgets all changes: another scene was opened.
    void begin(const Entry& now);

    /// Takes in what is set now. `control`: a number for the control that is held, 0 for none.
    void observe(const Entry& now, unsigned control = 0);

    /// Takes in what followed from the last change by itself, such as a width from an image's proportions, or that it
    /// was refused.
    void amend(const Entry& now);
    /// What is there is only looked at: an earlier moment with its settings.
    void look_at(const Entry& now) { now_ = now; }

    /// The settings before the last change, or after the one that was undone last; nothing if there is none.
    std::optional<Entry> undo();
    std::optional<Entry> redo();

    /// What would be undone or redone: "Wind speed"; empty if there is nothing.
    std::string undone() const;
    std::string redone() const;

private:
    static void keep(std::deque<Entry>& entries, const Entry& entry);

    Entry now_;
    std::deque<Entry> past_, future_;  // the nearest last
    unsigned control_ = 0;             // that is held, and whose change is the last of the past
};

}  // namespace drapeau

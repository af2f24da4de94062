// Actions: everything that a key does, in one table. Key handling, the list of keys and the command palette read it; to
// add an action, add its row in actions.cpp.
#pragma once

#include "app_state.hpp"
#include "input.hpp"

#include <span>
#include <string>
#include <vector>

namespace drapeau {

/// One way to press an action's key; only one of the first three is given.
struct Press {
    Key key = Key::other;  // wherever it stands, whatever else is held
    char32_t typed = 0;    // what it types, whichever key does
    char letter = '\0';    // the letter it stands for
    bool control = false;  // of a letter: with the control key, and with shift or without
    bool shift = false;
};

struct Action {
    std::string does;  // "hide, show the panel"
    std::string key;   // as a person reads it: "Ctrl Z"; "" for what has none
    std::vector<Press> presses;
    void (*run)(AppState& app, Camera& camera);
    std::string together{};  // what neighbours in the table that share a key do, in the list of keys
};

std::span<const Action> actions();

/// The action of a key that types `typed` (0: nothing): what the key is comes first, then what it types, then its
/// letter, so that one press does one thing. Null if there is none.
const Action* action_of(const InputEvent& event, char32_t typed);
/// The action of a character that comes without its key.
const Action* action_of(char32_t typed);

}  // namespace drapeau

// The one way bad input is reported: a single line that names what, where and what is allowed.
// Raised once where it is found, caught once in main (exit status 2) or by the window (a message, the flag untouched).
#pragma once

#include <stdexcept>

namespace drapeau {

struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace drapeau

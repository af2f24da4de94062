// A window manager that died leaves its property _NET_SUPPORTING_WM_CHECK on the root window, naming a window that is
// gone. GLFW 3.3 aborts the program when it starts on such a display.
#pragma once

#include <memory>

namespace drapeau {

/// Removes the property unless the window it names is a window manager's: one that says the same of itself (EWMH,
/// "_NET_SUPPORTING_WM_CHECK"). Does nothing without an X server. Gives the connection, to be kept until there is
/// another: a server whose last client leaves may start anew, and turns away who comes meanwhile.
std::shared_ptr<void> forget_dead_window_manager();

}  // namespace drapeau

// Dropping files on a window as a desktop does: a client that speaks XDND version 5 and hands over text/uri-list.
// Source: Drag-and-Drop Protocol for the X Window System, freedesktop.org.
#pragma once

#include "app.hpp"

#include <string>
#include <vector>

namespace drapeau::window_tests {

/// Drags the files over the window, lets go at `p` (of the window) and waits until it has taken them. Throws, saying
/// what was waited for, where the window does not follow the protocol.
void drop_files(const Screen& screen, const App& app, Point p, const std::vector<std::string>& files);

/// What text/uri-list says of these absolute paths: escaped as in URIs, a line each.
std::string uri_list(const std::vector<std::string>& files);

}  // namespace drapeau::window_tests

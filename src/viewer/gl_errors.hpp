// Counts what OpenGL complains about, through the debug context where there is one, and prints each complaint.
// DRAPEAU_GL_DEBUG=1 in the environment asks for one; DRAPEAU_GL_DEBUG=all prints the driver's notes too, such as those
// on performance.
#pragma once

#include <atomic>

namespace drapeau {

class GlErrors {
public:
    /// With `debug` the driver's own messages are collected as they arise.
    explicit GlErrors(bool debug);
    GlErrors(const GlErrors&) = delete;
    GlErrors& operator=(const GlErrors&) = delete;

    /// Takes what glGetError holds; called once a frame.
    void poll();
    int count() const { return count_; }
    void add(const char* message);

private:
    std::atomic<int> count_ = 0;  // drivers may report from threads of their own
};

}  // namespace drapeau

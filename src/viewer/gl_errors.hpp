// Counts what OpenGL complains about, through the debug context where there is one, and prints each complaint.
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

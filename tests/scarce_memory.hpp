// ScarceMemory: large allocations fail, to try what a program makes of that.
#pragma once

#include <cstddef>

namespace drapeau::testing {

/// While one exists, operator new throws in every thread when asked for at least so many bytes.
class ScarceMemory {
public:
    enum class Thrown { bad_alloc, another_exception, no_exception };

    explicit ScarceMemory(std::size_t fails_from, Thrown thrown = Thrown::bad_alloc);
    ~ScarceMemory();
    ScarceMemory(const ScarceMemory&) = delete;
    ScarceMemory& operator=(const ScarceMemory&) = delete;
};

}  // namespace drapeau::testing

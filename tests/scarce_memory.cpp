#include "scarce_memory.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

namespace drapeau::testing {

namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> fails_from_bytes = never;
std::atomic<ScarceMemory::Thrown> what_is_thrown = ScarceMemory::Thrown::bad_alloc;

void* allocated(std::size_t bytes, std::size_t alignment) {
    if (bytes >= fails_from_bytes) {
        if (what_is_thrown == ScarceMemory::Thrown::another_exception) throw std::runtime_error("another exception");
        if (what_is_thrown == ScarceMemory::Thrown::no_exception) throw 42;
        throw std::bad_alloc();
    }
    // Whole multiples of the alignment, as aligned_alloc wants them, and never none.
    const std::size_t rounded = std::max<std::size_t>(1, (bytes + alignment - 1) / alignment) * alignment;
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

ScarceMemory::ScarceMemory(std::size_t fails_from, Thrown thrown) {
    what_is_thrown = thrown;
    fails_from_bytes = fails_from;
}
ScarceMemory::~ScarceMemory() {
    fails_from_bytes = never;
}

}  // namespace drapeau::testing

void* operator new(std::size_t bytes) {
    return drapeau::testing::allocated(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return drapeau::testing::allocated(bytes,
                                       std::max<std::size_t>(std::size_t(alignment), __STDCPP_DEFAULT_NEW_ALIGNMENT__));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    try {
        return operator new(bytes);
    } catch (...) {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

#include "peaks.hpp"

#include "drapeau/state.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>

#include <unistd.h>

namespace drapeau::bench {
namespace {

/// The shortest of many times, in ns.
template <class Job>
double shortest_ns(int repeats, Job&& job) {
    using clock = std::chrono::steady_clock;
    double shortest = 1e300;
    for (int n = 0; n < repeats; ++n) {
        const auto begin = clock::now();
        job();
        shortest = std::min(shortest, std::chrono::duration<double, std::nano>(clock::now() - begin).count());
    }
    return shortest;
}

/// A value the compiler must have in a register here and cannot know.
template <class V>
DRAPEAU_INLINE void unknown(V& value) {
#if defined(__x86_64__) || defined(__i386__)
    asm volatile("" : "+x"(value));
#else
    asm volatile("" : "+w"(value));
#endif
}

/// Multiply-adds a nanosecond: chains enough to hide the latency of four or five cycles on two units.
template <class Real>
double multiply_adds() {
    using V = Vector<Real>;
    constexpr int chains = 12, rounds = 4000;
    V a[chains], factor = V{} + Real(0.999), addend = V{} + Real(0.001);
    for (auto& chain : a) chain = V{} + Real(1);
    unknown(factor), unknown(addend);
    const double ns = shortest_ns(400, [&] {
        V r0 = a[0], r1 = a[1], r2 = a[2], r3 = a[3], r4 = a[4], r5 = a[5];
        V r6 = a[6], r7 = a[7], r8 = a[8], r9 = a[9], r10 = a[10], r11 = a[11];
        for (int n = 0; n < rounds; ++n) {
            r0 = r0 * factor + addend, r1 = r1 * factor + addend, r2 = r2 * factor + addend;
            r3 = r3 * factor + addend, r4 = r4 * factor + addend, r5 = r5 * factor + addend;
            r6 = r6 * factor + addend, r7 = r7 * factor + addend, r8 = r8 * factor + addend;
            r9 = r9 * factor + addend, r10 = r10 * factor + addend, r11 = r11 * factor + addend;
        }
        unknown(r0), unknown(r1), unknown(r2), unknown(r3), unknown(r4), unknown(r5);
        unknown(r6), unknown(r7), unknown(r8), unknown(r9), unknown(r10), unknown(r11);
    });
    return 1.0 * rounds * chains * Lanes<V>::width / ns;
}

void measure_bandwidth(Level& level, std::size_t working_set) {
    using V = Vector<float>;
    constexpr int width = Lanes<V>::width, unrolled = 8;
    const std::size_t count = working_set / sizeof(float) / (width * unrolled) * (width * unrolled);
    const double bytes = static_cast<double>(count * sizeof(float));
    Array<float> a(count);
    // Small sets are passed over often enough for the clock, all of them often enough to find a quiet moment.
    const int passes = static_cast<int>(std::max(1.0, 100e3 / bytes * 10.0));
    const int repeats = static_cast<int>(std::clamp(400e6 / (bytes * passes), 6.0, 300.0));

    const double load_ns = shortest_ns(repeats, [&] {
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t n = 0; n < count; n += width * unrolled)
                for (int u = 0; u < unrolled; ++u) {
                    V value = Lanes<V>::load(a.data() + n + u * width);
                    unknown(value);
                }
    });
    const double update_ns = shortest_ns(repeats, [&] {
        V one = V{} + 1.0f;
        unknown(one);
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t n = 0; n < count; n += width * unrolled)
                for (int u = 0; u < unrolled; ++u) {
                    float* const at = a.data() + n + u * width;
                    Lanes<V>::store(at, Lanes<V>::load(at) + one);
                }
    });
    const double copy_ns = shortest_ns(repeats, [&] {
        for (int pass = 0; pass < passes; ++pass) {
            std::memcpy(a.data(), a.data() + count / 2, count / 2 * sizeof(float));
            asm volatile("" ::: "memory");
        }
    });
    level.load = bytes * passes / load_ns;
    level.update = 2.0 * bytes * passes / update_ns;
    level.copy = bytes * passes / copy_ns;
}

std::size_t cache_bytes(int name, std::size_t otherwise) {
    const long bytes = sysconf(name);
    return bytes > 0 ? static_cast<std::size_t>(bytes) : otherwise;
}

}  // namespace

std::size_t Peaks::level_of(std::size_t bytes) const {
    std::size_t n = 0;
    while (n + 1 < levels.size() && bytes > levels[n].bytes) ++n;
    return n;
}

Peaks measure_peaks() {
    Peaks peaks{{multiply_adds<float>(), multiply_adds<double>()}, {}};
#if defined(_SC_LEVEL1_DCACHE_SIZE)
    const std::size_t l1 = cache_bytes(_SC_LEVEL1_DCACHE_SIZE, 32u << 10);
    const std::size_t l2 = cache_bytes(_SC_LEVEL2_CACHE_SIZE, 512u << 10);
    const std::size_t l3 = cache_bytes(_SC_LEVEL3_CACHE_SIZE, 16u << 20);
#else
    const std::size_t l1 = 32u << 10, l2 = 512u << 10, l3 = 16u << 20;
#endif
    const std::size_t beyond = std::clamp<std::size_t>(2 * l3, 128u << 20, 256u << 20);
    peaks.levels = {{"L1", l1}, {"L2", l2}, {"L3", l3}, {"memory", ~std::size_t{0}}};
    measure_bandwidth(peaks.levels[0], l1 / 2);
    measure_bandwidth(peaks.levels[1], l2 / 2);
    measure_bandwidth(peaks.levels[2], std::min<std::size_t>(l3 / 2, 16u << 20));
    measure_bandwidth(peaks.levels[3], beyond);
    return peaks;
}

}  // namespace drapeau::bench

// Which instruction sets were compiled in, and which of them this machine can run.
#include "kernels/kernels.hpp"

#include "io/error.hpp"
#include "io/text.hpp"

#include "kernel_targets.hpp"  // made by the build: DRAPEAU_FOR_EACH_TARGET(X) is X(symbol, "name")..., plainest first

#if defined(__x86_64__)
#include <cpuid.h>
#endif
#include <cstdlib>

namespace drapeau {

#define DRAPEAU_DECLARE(symbol, name)               \
    extern const KernelTable<float> float_##symbol; \
    extern const KernelTable<double> double_##symbol;
DRAPEAU_FOR_EACH_TARGET(DRAPEAU_DECLARE)

namespace {

struct Target {
    std::string name;
    const KernelTable<float>* single_precision;
    const KernelTable<double>* double_precision;
};

#define DRAPEAU_LIST(symbol, name) {name, &float_##symbol, &double_##symbol},
const Target targets[] = {DRAPEAU_FOR_EACH_TARGET(DRAPEAU_LIST)};

#if defined(__x86_64__)
/// Bits of cpuid that __builtin_cpu_supports cannot be asked for in every compiler.
bool has_cx16_and_lahf() {
    unsigned a = 0, b = 0, c = 0, d = 0, extended = 0;
    return __get_cpuid(1, &a, &b, &c, &d) && (c >> 13 & 1) && __get_cpuid(0x80000001, &a, &b, &extended, &d) &&
           (extended & 1);
}
bool has_f16c_movbe_and_lzcnt() {
    unsigned a = 0, b = 0, c = 0, d = 0, extended = 0;
    return __get_cpuid(1, &a, &b, &c, &d) && (c >> 29 & 1) && (c >> 22 & 1) &&
           __get_cpuid(0x80000001, &a, &b, &extended, &d) && (extended >> 5 & 1);
}
#endif

/// Whether this machine has every feature that the compiler may use at a level of the x86-64 psABI.
bool runs_here(const std::string& name) {
#if defined(__x86_64__)
    const auto v2 = [] {
        return __builtin_cpu_supports("sse3") && __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.1") &&
               __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt") && has_cx16_and_lahf();
    };
    const auto v3 = [&] {
        return v2() && __builtin_cpu_supports("avx") && __builtin_cpu_supports("avx2") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma") &&
               has_f16c_movbe_and_lzcnt();
    };
    const auto v4 = [&] {
        return v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
    };
    if (name == "x86-64-v2") return v2();
    if (name == "x86-64-v3") return v3();
    if (name == "x86-64-v4") return v4();
#endif
    return !name.empty();
}

const Target& choose() {
    const char* wish = std::getenv("DRAPEAU_TARGET");
    const Target* best = nullptr;
    std::string here, all;
    for (const auto& target : targets) {
        all += (all.empty() ? "" : ", ") + target.name;
        if (!runs_here(target.name)) continue;
        here += (here.empty() ? "" : ", ") + target.name;
        if (!wish || target.name == wish) best = &target;
    }
    if (best) return *best;
    if (here.empty()) throw InputError("this program was built for " + all + ": this machine can run none of them");
    throw InputError("DRAPEAU_TARGET = " + one_line(in_quotes(wish), 60) + ": this program has, for this machine, " +
                     here);
}

}  // namespace

template <>
const Kernels<float>& find_kernels<float>(Method method, bool diagonals, bool damped) {
    return choose().single_precision->of[static_cast<int>(method)][diagonals][damped];
}
template <>
const Kernels<double>& find_kernels<double>(Method method, bool diagonals, bool damped) {
    return choose().double_precision->of[static_cast<int>(method)][diagonals][damped];
}

std::vector<std::string> kernel_targets() {
    std::vector<std::string> names;
    for (const auto& target : targets)
        if (runs_here(target.name)) names.push_back(target.name);
    return names;
}

std::string kernel_target() {
    return choose().name;
}

}  // namespace drapeau

// Which instruction sets were compiled in, and which of them this machine can run.
#include "kernels/kernels.hpp"

#include "error.hpp"
#include "kernel_targets.hpp"  // made by the build: DRAPEAU_FOR_EACH_TARGET(X) is X(symbol, "name")..., plainest first

#include <cstdlib>

namespace drapeau {

#define DRAPEAU_DECLARE(symbol, name)                                 \
    extern const KernelSet<float> float_forward_euler_##symbol;       \
    extern const KernelSet<float> float_semi_implicit_euler_##symbol; \
    extern const KernelSet<double> double_forward_euler_##symbol;     \
    extern const KernelSet<double> double_semi_implicit_euler_##symbol;
DRAPEAU_FOR_EACH_TARGET(DRAPEAU_DECLARE)

namespace {

struct Target {
    std::string name;
    const KernelSet<float>* single_precision[2];   // by Method
    const KernelSet<double>* double_precision[2];  // by Method
};

#define DRAPEAU_LIST(symbol, name)                                         \
    {name,                                                                 \
     {&float_forward_euler_##symbol, &float_semi_implicit_euler_##symbol}, \
     {&double_forward_euler_##symbol, &double_semi_implicit_euler_##symbol}},
const Target targets[] = {DRAPEAU_FOR_EACH_TARGET(DRAPEAU_LIST)};

bool runs_here(const std::string& name) {
#if defined(__x86_64__)
    if (name == "x86-64-v3") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (name == "x86-64-v4")
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#endif
    return !name.empty();
}

const Target& choose() {
    const char* wish = std::getenv("DRAPEAU_TARGET");
    const Target* best = nullptr;
    std::string here;
    for (const auto& target : targets) {
        if (!runs_here(target.name)) continue;
        here += (here.empty() ? "" : ", ") + target.name;
        if (!wish || target.name == wish) best = &target;
    }
    if (!best)
        throw InputError("DRAPEAU_TARGET = \"" + std::string(wish) + "\": this program has, for this machine, " + here);
    return *best;
}

}  // namespace

template <>
const Kernel<float>& find_kernel<float>(Method method, bool diagonals, bool damped) {
    return choose().single_precision[static_cast<int>(method)]->of[diagonals][damped];
}
template <>
const Kernel<double>& find_kernel<double>(Method method, bool diagonals, bool damped) {
    return choose().double_precision[static_cast<int>(method)]->of[diagonals][damped];
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

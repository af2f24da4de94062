// Counting: what a kernel does to a mass, counted by running it on lanes that count.
//
// The file that counts includes the whole core and is compiled without optimisation, which is faster by minutes and
// counts the same. Its functions stand in an instruction-set namespace of their own (isa.hpp), so that the linker takes
// none of them for the programs' own; only plain types cross here.
#pragma once

#include "counted_lane.hpp"

#include "drapeau/methods/list.hpp"

namespace drapeau::bench {

enum class Counted { step, accounted_step, measurement, evaluation };

struct CountedKernels {
    Method method;
    bool in_double, diagonals, damped;
    bool rated;  // drag or friction is compiled in
};

Counts count(Counted what, const CountedKernels& kernels);

}  // namespace drapeau::bench

// Against: this program's speed beside that of another build of it, on a machine that others use too.
//
// The two take turns as child processes: this, other; other, this; and so on. A pair measures the same cases within
// seconds, so that a slow phase of the machine hits both, and only the ratio within a pair is used. The pairs of one
// case are spread over the whole run, so that no single phase decides.
#pragma once

#include <string>

namespace drapeau::bench {

struct AgainstOptions {
    std::string other;     // the other program's file
    std::string filter;    // cases as Google Benchmark selects them; empty: the steps that decide how fast a flag flies
    int pairs = 11;        // per case; more narrow the intervals
    double budget = 0.05;  // s a case and child, and as much for each of its rivals
};

/// Prints, for every case that both programs list, the median over the pairs of this program's time over the other's
/// and the interval that holds it with 95 % confidence; then the geometric mean of the medians. Throws InputError.
void run_against(const AgainstOptions& options);

}  // namespace drapeau::bench

// Judge: runs a case and holds it against the law of extremes: refused before it starts, or reported diverged at a
// definite step with its cause, or finite and as good as it is said to be.
#pragma once

#include "extremes/case.hpp"

#include <string>

namespace drapeau::extremes {

/// misjudged: the ledger, which knows work from samples, called a good run diverged or garbage good, or gave up an
/// automatic step. It must be rare; what fails must not be at all.
enum class Verdict { good, between, not_compared, warned, diverged, refused, failed, misjudged };
inline constexpr const char* verdict_names[] = {"good",     "between", "not compared", "warned of",
                                                "diverged", "refused", "FAILED",       "MISJUDGED"};

struct Judgement {
    Verdict verdict = Verdict::not_compared;
    std::string text;  // what was refused, how it diverged, or which law it breaks
};

/// `work`: about how many mass-steps it may take, the run that it is compared with included.
Judgement judge(const Case& of, double work);

}  // namespace drapeau::extremes

// Subject: what is timed, able to return to its start state and to repeat its work.
#pragma once

#include <cstdint>

namespace drapeau::bench {

class Subject {
public:
    virtual ~Subject() = default;
    virtual void restore() = 0;
    /// Does the work `times` times: as many steps, batches, copies, evaluations.
    virtual void run(int times) = 0;
    /// Of the bits of the result, padding excluded; comparable among subjects of the same work and precision.
    virtual std::uint64_t hash() const = 0;
    /// Of the state (share); NaN if it is not finite.
    virtual double greatest_stretch() const = 0;
    /// Steps taken since the start state, by subjects that take some.
    virtual long long steps() const { return 0; }

    double dt = 0.0;             // s, the step of subjects that take steps
    long long steps_a_time = 1;  // that run(1) takes
};

}  // namespace drapeau::bench

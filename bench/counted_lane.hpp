// A lane of one mass that counts what a kernel does with it: the kernels are templates over their lane type, so the
// counts are those of the very code that is timed.
#pragma once

#include "drapeau/simd.hpp"

#include <bit>

namespace drapeau::bench {

struct Counts {
    double multiplications = 0, additions = 0, divisions = 0;
    double others = 0;             // the bits of the root's guess, selections
    double loads = 0, stores = 0;  // of one Real each
    double watched_loads = 0;      // of those between the addresses below
    const void *watched_from = nullptr, *watched_to = nullptr;

    static Counts& now() {
        static Counts counts;
        return counts;
    }
};

template <class Real>
struct CountedLane {
    using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    typedef Word Words __attribute__((vector_size(sizeof(Real))));

    Real value{};

    CountedLane() = default;
    CountedLane(Real v) : value(v) {}
    /// To bits, where a shift and a subtraction make the guess, and back.
    explicit CountedLane(Words words) : value(std::bit_cast<Real>(words[0])) { Counts::now().others += 2; }
    explicit operator Words() const { return Words{std::bit_cast<Word>(value)}; }

    friend CountedLane operator+(CountedLane a, CountedLane b) { return ++Counts::now().additions, a.value + b.value; }
    friend CountedLane operator-(CountedLane a, CountedLane b) { return ++Counts::now().additions, a.value - b.value; }
    friend CountedLane operator*(CountedLane a, CountedLane b) {
        return ++Counts::now().multiplications, a.value * b.value;
    }
    friend CountedLane operator/(CountedLane a, CountedLane b) { return ++Counts::now().divisions, a.value / b.value; }
    CountedLane operator-() const { return ++Counts::now().additions, -value; }
    /// Lane 0, for sums over the lanes.
    Real operator[](int) const { return value; }
};

}  // namespace drapeau::bench

namespace drapeau {

template <class Scalar>
struct Lanes<bench::CountedLane<Scalar>> {
    using Real = Scalar;
    using V = bench::CountedLane<Scalar>;
    static constexpr int width = 1;

    static V load(const Real* from) {
        auto& counts = bench::Counts::now();
        ++counts.loads;
        if (from >= counts.watched_from && from < counts.watched_to) ++counts.watched_loads;
        return V(*from);
    }
    static void store(Real* to, V value) { ++bench::Counts::now().stores, *to = value.value; }
    static V broadcast(Real value) { return value; }
    static V where_positive(V where, V value) { return ++bench::Counts::now().others, where.value > 0 ? value : V(); }
    static V greater(V a, V b) { return ++bench::Counts::now().others, b.value > a.value ? b : a; }
    static V shifted(V left, V) { return ++bench::Counts::now().others, left; }
};

}  // namespace drapeau

// SIMD: a register full of neighbouring masses handled as one value.
//
// A kernel is written once over a lane type V: float or double (one mass at a time), or one of the compiler's vector
// types (GCC and clang: arithmetic on them is ordinary C++, no intrinsics). Lanes<V> says how V meets memory.
#pragma once

#include "drapeau/isa.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace drapeau {

// Inlined, what sanitizers add takes compilers minutes. With that of addresses a call costs no more than what it saves;
// with that of threads it costs several times as much, and the compiler may choose.
#if defined(__SANITIZE_ADDRESS__)
#define DRAPEAU_INLINE [[gnu::noinline]] inline
#define DRAPEAU_INLINE_LAMBDA __attribute__((noinline))
#elif defined(__SANITIZE_THREAD__)
#define DRAPEAU_INLINE inline
#define DRAPEAU_INLINE_LAMBDA
#else
#define DRAPEAU_INLINE [[gnu::always_inline]] inline
#define DRAPEAU_INLINE_LAMBDA __attribute__((always_inline))
#endif

#if defined(__AVX512F__)
constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
constexpr std::size_t register_bytes = 32;
#else
constexpr std::size_t register_bytes = 16;
#endif

/// Rows are padded to this many bytes, the widest register, so that every row is a whole number of registers.
constexpr std::size_t row_alignment = 64;

template <class Real, std::size_t bytes>
struct VectorOf {
    typedef Real type __attribute__((vector_size(bytes)));
    // May stand at any address that a Real may.
    typedef Real unaligned __attribute__((vector_size(bytes), aligned(sizeof(Real)), may_alias));
};

/// The widest vector of Real that this translation unit is compiled for.
template <class Real, std::size_t bytes = register_bytes>
using Vector = typename VectorOf<Real, bytes>::type;

/// Three components, each a lane value: what a kernel computes with.
template <class V>
struct Vec3 {
    V x, y, z;
};

// Where they are not inlined, these are symbols, and registers are returned in another way for another instruction set.
inline namespace DRAPEAU_ISA {

template <class V>
struct Lanes {
    using Real = std::remove_cvref_t<decltype(std::declval<V>()[0])>;
    using Unaligned = typename VectorOf<Real, sizeof(V)>::unaligned;
    static constexpr int width = sizeof(V) / sizeof(Real);

    DRAPEAU_INLINE static V load(const Real* from) { return *reinterpret_cast<const Unaligned*>(from); }
    DRAPEAU_INLINE static void store(Real* to, V value) { *reinterpret_cast<Unaligned*>(to) = value; }
    DRAPEAU_INLINE static V broadcast(Real value) { return value - V{}; }
    /// where > 0 ? value : 0, lane by lane: a selection, so that a NaN in `value` does not leak through a zero.
    DRAPEAU_INLINE static V where_positive(V where, V value) { return where > V{} ? value : V{}; }
    /// The greater of two, lane by lane; `a` where b is NaN.
    DRAPEAU_INLINE static V greater(V a, V b) { return b > a ? b : a; }
    /// The lanes one place to the left of those of `here`, where `left` is the register to the left of it.
    DRAPEAU_INLINE static V shifted(V left, V here) { return shifted(left, here, std::make_index_sequence<width>()); }

private:
    template <std::size_t... n>
    DRAPEAU_INLINE static V shifted(V left, V here, std::index_sequence<n...>) {
        return __builtin_shufflevector(left, here, (width - 1 + n)...);
    }
};

template <class V>
requires std::is_floating_point_v<V>
struct Lanes<V> {
    using Real = V;
    static constexpr int width = 1;

    DRAPEAU_INLINE static V load(const Real* from) { return *from; }
    DRAPEAU_INLINE static void store(Real* to, V value) { *to = value; }
    DRAPEAU_INLINE static V broadcast(Real value) { return value; }
    DRAPEAU_INLINE static V where_positive(V where, V value) { return where > V{} ? value : V{}; }
    DRAPEAU_INLINE static V greater(V a, V b) { return b > a ? b : a; }
    DRAPEAU_INLINE static V shifted(V left, V) { return left; }
};

/// Lane n of a value, in double.
template <class V>
DRAPEAU_INLINE double lane(const V& value, int n) {
    if constexpr (std::is_floating_point_v<V>)
        return static_cast<double>(value);
    else
        return static_cast<double>(value[n]);
}
/// The sum over the lanes, from the left.
template <class V>
DRAPEAU_INLINE double sum_of(const V& value) {
    double sum = 0.0;
    for (int n = 0; n < Lanes<V>::width; ++n) sum += lane(value, n);
    return sum;
}
template <class V>
DRAPEAU_INLINE double max_of(const V& value) {
    double most = lane(value, 0);
    for (int n = 1; n < Lanes<V>::width; ++n) most = lane(value, n) > most ? lane(value, n) : most;
    return most;
}

/// 1/sqrt(s) for s > 0, to about one unit in the last place of float (two of double), without a division or a square
/// root, which a core can only do every ten cycles or so.
///
/// A first guess y comes from halving the exponent bits; e = 1 - s y^2 then stays within 0.0682. The exact answer is
/// y (1 - e)^(-1/2) = y + y e p(e); p is the polynomial that minimises the greatest relative error over that range
/// (Remez exchange): 2.4e-8 for degree 3, 8.8e-10 for degree 4. In double one Newton step takes that to 1e-18.
template <class V>
DRAPEAU_INLINE V inverse_sqrt(V s) {
    using Real = typename Lanes<V>::Real;
    constexpr bool single = sizeof(Real) == 4;
    using Word = std::conditional_t<single, std::uint32_t, std::uint64_t>;
    constexpr Word magic = single ? Word(0x5f374800u) : Word(0x5fe6e90000000000u);

    V y;
    if constexpr (std::is_floating_point_v<V>) {
        y = std::bit_cast<Real>(magic - (std::bit_cast<Word>(s) >> 1));
    } else {
        using Words = typename VectorOf<Word, sizeof(V)>::type;
        y = (V)(magic - ((Words)s >> 1));
    }
    const V e = Real(1) - (s * y) * y;
    if constexpr (single) {
        const V p = Real(0.499998366) + e * (Real(0.374996900) + e * (Real(0.313925898) + e * Real(0.275146283)));
        return y + (y * e) * p;
    } else {
        const V p =
            0.5000000029248994 +
            e * (0.37499789185208987 + e * (0.3124952794515592 + e * (0.274902585447069 + e * 0.2479434913727876)));
        y = y + (y * e) * p;
        return y + (y * (Real(1) - (s * y) * y)) * Real(0.5);
    }
}

template <class V>
DRAPEAU_INLINE Vec3<V> operator+(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
DRAPEAU_INLINE Vec3<V> operator-(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V, class S>
DRAPEAU_INLINE Vec3<V> operator*(const S& s, const Vec3<V>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class V>
DRAPEAU_INLINE Vec3<V> shifted(const Vec3<V>& left, const Vec3<V>& here) {
    using L = Lanes<V>;
    return {L::shifted(left.x, here.x), L::shifted(left.y, here.y), L::shifted(left.z, here.z)};
}
template <class V>
DRAPEAU_INLINE Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
DRAPEAU_INLINE V dot(const Vec3<V>& a, const Vec3<V>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau

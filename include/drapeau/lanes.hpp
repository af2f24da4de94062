// Lanes: a register full of neighbouring masses handled as one value.
//
// A kernel is written once over a lane type V: float or double (one mass at a time), or one of the compiler's vector
// types (GCC and clang: arithmetic on them is ordinary C++, no intrinsics). Lanes<V> says how V meets memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace drapeau {

#define DRAPEAU_INLINE [[gnu::always_inline]] inline
#define DRAPEAU_INLINE_LAMBDA __attribute__((always_inline))

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
};

/// 1/sqrt(s) for s > 0, to about two units in the last place, without a division or a square root (which a core can
/// do only every ten cycles or so): a first guess from the exponent bits, relative error 3.4e-2, then the third-order
/// correction y <- y + y e (1/2 + 3/8 e), e = 1 - s y^2, which takes an error d to about 5/2 d^3:
/// 1e-4, then 2.5e-12, then below double's rounding.
template <class V>
DRAPEAU_INLINE V inverse_sqrt(V s) {
    using Real = typename Lanes<V>::Real;
    using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    constexpr Word magic = sizeof(Real) == 4 ? Word(0x5f375a86u) : Word(0x5fe6eb50c7b537a9u);
    constexpr int corrections = sizeof(Real) == 4 ? 2 : 3;

    V y;
    if constexpr (std::is_floating_point_v<V>) {
        y = std::bit_cast<Real>(magic - (std::bit_cast<Word>(s) >> 1));
    } else {
        using Words = typename VectorOf<Word, sizeof(V)>::type;
        y = (V)(magic - ((Words)s >> 1));
    }
    for (int n = 0; n < corrections; ++n) {
        const V e = Real(1) - (s * y) * y;
        y = y + (y * e) * (Real(0.5) + Real(0.375) * e);
    }
    return y;
}

/// Three components, each a lane value: what a kernel computes with.
template <class V>
struct Triple {
    V x, y, z;
};

template <class V>
DRAPEAU_INLINE Triple<V> operator+(const Triple<V>& a, const Triple<V>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
DRAPEAU_INLINE Triple<V> operator-(const Triple<V>& a, const Triple<V>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V, class S>
DRAPEAU_INLINE Triple<V> operator*(const S& s, const Triple<V>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class V>
DRAPEAU_INLINE V dot(const Triple<V>& a, const Triple<V>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace drapeau

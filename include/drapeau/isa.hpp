// The instruction set as a namespace: code compiled for one never shares symbols with code compiled for another.
//
// Everything in this core that may become a symbol (a function that is not inlined, a template's instance) stands in
// the inline namespace DRAPEAU_ISA, which is named after what the translation unit is compiled for. Two such units in
// one program, one for AVX2 and one for AVX-512, then keep their own versions, where the linker would otherwise keep
// one of them for both. What passes between units of different instruction sets (field.hpp) stands outside: plain
// aggregates whose functions are always inlined.
#pragma once

#ifndef DRAPEAU_ISA

#define DRAPEAU_ISA_JOIN(a, b, c, d, e, f) isa_##a##b##c##d##e##f
#define DRAPEAU_ISA_NAME(a, b, c, d, e, f) DRAPEAU_ISA_JOIN(a, b, c, d, e, f)

#if defined(__AVX512F__)
#define DRAPEAU_ISA_WIDTH avx512
#elif defined(__AVX2__)
#define DRAPEAU_ISA_WIDTH avx2
#elif defined(__AVX__)
#define DRAPEAU_ISA_WIDTH avx
#else
#define DRAPEAU_ISA_WIDTH base
#endif
#if defined(__FMA__)
#define DRAPEAU_ISA_FMA _fma
#else
#define DRAPEAU_ISA_FMA
#endif
#if defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__) && defined(__AVX512CD__)
#define DRAPEAU_ISA_512 _v4
#else
#define DRAPEAU_ISA_512
#endif
#if defined(__BMI2__)
#define DRAPEAU_ISA_BMI _bmi2
#else
#define DRAPEAU_ISA_BMI
#endif
#if defined(__SSE4_2__)
#define DRAPEAU_ISA_SSE _sse42
#elif defined(__SSSE3__)
#define DRAPEAU_ISA_SSE _ssse3
#else
#define DRAPEAU_ISA_SSE
#endif
#if defined(__AVX512VBMI2__) || defined(__AVX512BF16__) || defined(__AVX512FP16__)
#define DRAPEAU_ISA_LATE _late
#else
#define DRAPEAU_ISA_LATE
#endif

/// Define it yourself where instruction sets differ in what the names above do not tell apart.
#define DRAPEAU_ISA                                                                                         \
    DRAPEAU_ISA_NAME(DRAPEAU_ISA_WIDTH, DRAPEAU_ISA_512, DRAPEAU_ISA_FMA, DRAPEAU_ISA_BMI, DRAPEAU_ISA_SSE, \
                     DRAPEAU_ISA_LATE)

#endif

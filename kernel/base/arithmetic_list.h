// The arithmetics that can be put under a set of formulae, one line each.
#pragma once

#include <cstdint>

#include "kernel/base/error_free.h"
#include "kernel/base/number.h"
#include "kernel/base/machine.h"
#include "kernel/base/environment.h"

// X(name, type, summary)
#define AXISCERT_ARITHMETICS(X)                                                                      \
  X(plain, Plain, "one rounding an operation, to nearest")                                           \
  X(fma, FusedProducts, "dot and cross products with fused multiply-add")                            \
  X(kahan, KahanProducts, "cross by Kahan's difference of two products, dot by his sum and one fma") \
  X(ftz, SubnormalsFlushed, "subnormal results and operands are zero (FTZ and DAZ)")                 \
  X(up, Upward, "every operation rounded toward +infinity")                                          \
  X(down, Downward, "every operation rounded toward -infinity")                                      \
  X(chop, TowardZero, "every operation rounded toward zero")                                         \
  X(spu, SpuSingle, "the article's machine: chopped, flushed, saturating, no infinity or NaN")       \
  X(dot_yz_x, DotFromTheEnd, "dot products as x + (y + z)")                                          \
  X(dot_xz_y, DotOuterFirst, "dot products as (x + z) + y")                                          \
  X(rr_ee, RadiusLast, "rr (e e) for (rr e) e")                                                      \
  X(compensated, CompensatedProducts, "dot and cross products as if in twice the precision")         \
  X(exact_translation, TranslationKept, "A - P with its rounding error, carried to first order")     \
  X(prescaled, PrescaledQuery,                                                                       \
    "translated, then scaled by the power of two that brings the greatest number to [1, 2)")         \
  X(in_double, InDouble, "binary32 queries, computed in binary64")                                   \
  X(world_double, WorldDouble, "binary64 queries, translated in binary64, rounded, computed in binary32")

namespace axiscert {

namespace arithmetic {

// The members of an arithmetic, with the values that most of them have.
struct Plain {
  template <class Base>
  using Number = Base;
  template <class Base>  // the same over a base with an unbounded exponent
  using Unbounded = Base;
  template <class Real>  // the base of `Number` for queries in Real
  using BaseOf = Real;
  static constexpr Rounding rounding = Rounding::nearest;            // the processor's mode
  static constexpr Rounding unbounded_rounding = Rounding::nearest;  // the mode of Unbounded's base
  static constexpr bool flush = false;
  static constexpr bool prescaled = false;
  static constexpr bool in_binary32 = true, in_binary64 = true;
  static constexpr bool exposes_sides = true;  // the sides fit the query's precision and the formulae's scale
  // Results without range faults raise neither the overflow nor the underflow flag.
  static constexpr bool flags_tell_range = true;
};

#define AXISCERT_NUMBER(name, type) \
  struct name : Plain {             \
    template <class Base>           \
    using Number = type;            \
    template <class Base>           \
    using Unbounded = Number<Base>; \
  }
AXISCERT_NUMBER(FusedProducts, FusedNumber<Base>);
AXISCERT_NUMBER(KahanProducts, Kahan<Base>);
AXISCERT_NUMBER(CompensatedProducts, CompensatedNumber<Base>);
AXISCERT_NUMBER(RadiusLast, SquareFirst<Base>);
AXISCERT_NUMBER(TranslationKept, ExactTranslation<Base>);
template <class Base>
using YZFirst = DotOrder<Base, FirstPair::y_and_z>;
template <class Base>
using XZFirst = DotOrder<Base, FirstPair::x_and_z>;
AXISCERT_NUMBER(DotFromTheEnd, YZFirst<Base>);
AXISCERT_NUMBER(DotOuterFirst, XZFirst<Base>);
#undef AXISCERT_NUMBER

struct SubnormalsFlushed : Plain {
  static constexpr bool flush = true;
  static constexpr bool flags_tell_range = false;  // a subnormal operand becomes zero without a flag
};
struct Upward : Plain {
  static constexpr Rounding rounding = Rounding::upward, unbounded_rounding = rounding;
};
struct Downward : Plain {
  static constexpr Rounding rounding = Rounding::downward, unbounded_rounding = rounding;
};
struct TowardZero : Plain {
  static constexpr Rounding rounding = Rounding::toward_zero, unbounded_rounding = rounding;
};
struct SpuSingle : Plain {
  static constexpr Rounding unbounded_rounding = Rounding::toward_zero;
  template <class Base>
  using Number = Spu;
  template <class Base>
  using Unbounded = Base;
  static constexpr bool in_binary64 = false;
  static constexpr bool flags_tell_range = false;
};
struct PrescaledQuery : Plain {
  static constexpr bool prescaled = true;
  static constexpr bool exposes_sides = false;
};
struct InDouble : Plain {
  template <class Real>
  using BaseOf = double;
  static constexpr bool in_binary64 = false;
  static constexpr bool exposes_sides = false;
};
struct WorldDouble : Plain {
  template <class Base>
  using Number = LargeWorld<Base, float>;
  static constexpr bool in_binary32 = false;
};

}  // namespace arithmetic

enum class Arithmetic : std::uint8_t {
#define AXISCERT_NAME(name, type, summary) name,
  AXISCERT_ARITHMETICS(AXISCERT_NAME)
#undef AXISCERT_NAME
};
template <>
inline constexpr std::size_t enum_count<Arithmetic> = 0
#define AXISCERT_ONE(name, type, summary) +1
    AXISCERT_ARITHMETICS(AXISCERT_ONE)
#undef AXISCERT_ONE
    ;

template <Arithmetic a>
struct ArithmeticTypeOf;
#define AXISCERT_TYPE(name, type_, summary)   \
  template <>                                 \
  struct ArithmeticTypeOf<Arithmetic::name> { \
    using type = arithmetic::type_;           \
  };
AXISCERT_ARITHMETICS(AXISCERT_TYPE)
#undef AXISCERT_TYPE
template <Arithmetic a>
using ArithmeticType = typename ArithmeticTypeOf<a>::type;

}  // namespace axiscert

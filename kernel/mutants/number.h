// A number type that does one operation of a set of formulae wrongly, and the others rightly.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "kernel/base/number.h"
#include "kernel/mutants/operations.h"

namespace axiscert::mutants {

// Faults of a single operation. X(name, description for the reader)
#define AXISCERT_OPERATION_FAULTS(X)                                      \
  X(operator, "- for +, + for - and for *")                               \
  X(sign, "the result negated")                                           \
  X(swap, "the operands of a difference exchanged")                       \
  X(left, "the left operand alone: a term or a factor dropped")           \
  X(right, "the right operand alone")                                     \
  X(index_left, "the next coordinate for the left operand")               \
  X(index_right, "the next coordinate for the right operand")             \
  X(vertex_left, "the same coordinate of the next vertex on the left")    \
  X(vertex_right, "the same coordinate of the next vertex on the right")  \
  X(fma, "a sum contracted with the product in it: one rounding for two") \
  X(float, "the result rounded to binary32")                              \
  X(value, "a value with a fault of a magnitude (mutant.h)")

enum class OperationFault : std::uint8_t {
#define AXISCERT_NAME(name, what) name##_,
  AXISCERT_OPERATION_FAULTS(AXISCERT_NAME)
#undef AXISCERT_NAME
      none
};

// Several queries at once, which share the cost of looking for the faulty operation. The operations are not inlined:
// inlined, the formulae take minutes to compile.
template <class Real>
struct Lanes {
  static constexpr std::size_t width = 64 / sizeof(Real);
  std::array<Real, width> at;

  template <class Each>
  AXISCERT_INLINE static Lanes of(Each&& each) {
    Lanes result;
    for (std::size_t i = 0; i < width; ++i) result.at[i] = each(i);
    return result;
  }
  [[gnu::noinline]] friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return of([&](std::size_t i) { return a.at[i] + b.at[i]; });
  }
  [[gnu::noinline]] friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return of([&](std::size_t i) { return a.at[i] - b.at[i]; });
  }
  [[gnu::noinline]] friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return of([&](std::size_t i) { return a.at[i] * b.at[i]; });
  }
  AXISCERT_INLINE static Lanes constant(double x) {
    return of([&](std::size_t) { return static_cast<Real>(x); });
  }
  friend Lanes operator-(const Lanes& a) {
    return of([&](std::size_t i) { return -a.at[i]; });
  }
  friend Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
    return of([&](std::size_t i) { return std::fma(a.at[i], b.at[i], c.at[i]); });
  }
  friend Lanes in_binary32(const Lanes& a) {
    return of([&](std::size_t i) { return static_cast<Real>(static_cast<float>(a.at[i])); });
  }
};

// The faulty operation, and an input, or an operation computed before it, whose operands and result the fault needs.
struct OperationSite {
  OperationFault fault = OperationFault::none;
  Key at = 0, kept = 0;
  bool product_is_left = true;  // for fma: which operand is the product
};

// `Base` does the arithmetic: Lanes, or an exact ring. Each thread has its own site.
template <class Base>
class MutatedNumber {
 public:
  Base value;
  Key key = 0;

  MutatedNumber() = default;
  MutatedNumber(const Base& computed, Key of) : value(computed), key(of) {}
  explicit MutatedNumber(double zero) : value(Base::constant(zero)), key(zero_key) {}  // the formulae's own zero

  struct Site : OperationSite {
    Base kept_value{}, kept_left{}, kept_right{};
    std::function<Base(const Base&)> replaced;  // for a value
  };
  static Site& site() {
    static thread_local Site here;
    return here;
  }
  // The fault that the formulae have from now on in this thread, over these inputs.
  static Site& plant(const OperationSite& fault, std::span<const MutatedNumber> inputs) {
    Site& here = site();
    static_cast<OperationSite&>(here) = fault;
    for (const MutatedNumber& input : inputs) {
      if (input.key == fault.kept) here.kept_value = input.value;  // no operation makes it
    }
    return here;
  }

  AXISCERT_INLINE friend MutatedNumber operator+(const MutatedNumber& a, const MutatedNumber& b) {
    return checked<Operator::plus>(a, b, a.value + b.value);
  }
  AXISCERT_INLINE friend MutatedNumber operator-(const MutatedNumber& a, const MutatedNumber& b) {
    return checked<Operator::minus>(a, b, a.value - b.value);
  }
  AXISCERT_INLINE friend MutatedNumber operator*(const MutatedNumber& a, const MutatedNumber& b) {
    return checked<Operator::times>(a, b, a.value * b.value);
  }

 private:
  template <Operator op>
  AXISCERT_INLINE static MutatedNumber checked(const MutatedNumber& a, const MutatedNumber& b, const Base& right) {
    MutatedNumber result{right, key_of(op, a.key, b.key)};
    Site& here = site();
    if (result.key == here.kept) [[unlikely]]
      keep(here, a.value, b.value, right);
    if (result.key == here.at) [[unlikely]]
      result.value = wrong(here, op, a.value, b.value, right);
    return result;
  }
  [[gnu::noinline]] static void keep(Site& here, const Base& a, const Base& b, const Base& result) {
    here.kept_value = result;
    here.kept_left = a;
    here.kept_right = b;
  }
  static Base done(Operator op, const Base& a, const Base& b) {
    return op == Operator::plus ? a + b : op == Operator::minus ? a - b : a * b;
  }
  [[gnu::noinline]] static Base wrong(const Site& here, Operator op, const Base& a, const Base& b, const Base& right) {
    using enum OperationFault;
    switch (here.fault) {
      case operator_:
        return op == Operator::plus ? a - b : a + b;
      case sign_:
        return -right;
      case swap_:
        return b - a;
      case left_:
        return a;
      case right_:
        return b;
      case index_left_:
      case vertex_left_:
        return done(op, here.kept_value, b);
      case index_right_:
      case vertex_right_:
        return done(op, a, here.kept_value);
      case fma_:
        if (!here.product_is_left) {
          const Base& factor = here.kept_left;
          return fused(op == Operator::minus ? Base(-factor) : factor, here.kept_right, a);
        }
        return fused(here.kept_left, here.kept_right, op == Operator::minus ? Base(-b) : b);
      case float_:
        return in_binary32(right);
      case value_:
        return here.replaced(right);
      case none:
        break;
    }
    return right;
  }
};

}  // namespace axiscert::mutants

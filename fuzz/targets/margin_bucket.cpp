#include "fuzz/targets/margin_bucket.h"

#include <algorithm>

namespace axiscert::fuzzing {
namespace {

// floor(log2|x|) of a dyadic x that is not zero: its denominator is a power of two.
long exponent(const Rational& x) {
  return static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
         static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

}  // namespace

std::size_t margin_bucket(const BinaryNumber& lhs, const BinaryNumber& rhs) {
  const Rational l = rational(lhs), r = rational(rhs), margin = l - r, scale = abs(l) + abs(r);
  if (margin == 0) return tie_bucket;
  return static_cast<std::size_t>(std::clamp(exponent(scale) - exponent(margin), 0L, static_cast<long>(most_bucket)));
}

std::size_t margin_counter(Precision precision, Comparison which, const BinaryNumber& lhs, const BinaryNumber& rhs,
                           SignKind kind) {
  std::size_t counter = index_of(precision) * comparison_count + index_of(which);
  counter = counter * margin_bucket_count + margin_bucket(lhs, rhs);
  counter = counter * 2 + (lhs > rhs ? 1 : 0);
  return counter * sign_kind_count + index_of(kind);
}

}  // namespace axiscert::fuzzing

#include "proofs/forward_error.h"

#include <cmath>
#include <vector>

namespace axiscert::proofs {
namespace {

// Bounds for a step: the magnitude of its exact value is at most `size`, and its computed value differs from that by at
// most `error`.
struct Reach {
  double size = 0, error = 0;
};

}  // namespace

std::array<double, comparison_count> forward_error(const Recording& recording, int digits, int least_exponent) {
  // Rounding to nearest: |rnd(x) - x| <= max(u |x|, half the least number).
  const double u = std::ldexp(1.0, -digits), half_least = std::ldexp(0.5, least_exponent);
  const auto rounded = [&](Reach exact) {
    return Reach{exact.size, exact.error + u * (exact.size + exact.error) + half_least};
  };
  const auto product = [](Reach a, Reach b) {
    return Reach{a.size * b.size, a.size * b.error + a.error * b.size + a.error * b.error};
  };
  const auto sum = [](Reach a, Reach b) { return Reach{a.size + b.size, a.error + b.error}; };

  const auto& steps = recording.program.steps();
  std::vector<Reach> reach(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto operand = [&](std::size_t k) { return reach[steps[i].operands[k]]; };
    switch (steps[i].operation) {
      case Operation::input:
        reach[i] = {steps[i].name[0] == 'P' ? 0.0 : 1.0, 0};
        break;
      case Operation::zero:
        break;
      case Operation::negate:
        reach[i] = operand(0);
        break;
      case Operation::add:
      case Operation::subtract: {
        const Reach a = operand(0), b = operand(1);
        // Adding or subtracting an exact zero is exact: the translation by P = 0.
        const bool unchanged = b.size + b.error == 0;
        reach[i] = unchanged ? a : rounded(sum(a, b));
        break;
      }
      case Operation::multiply:
        reach[i] = rounded(product(operand(0), operand(1)));
        break;
      case Operation::fused:
        reach[i] = rounded(sum(product(operand(0), operand(1)), operand(2)));
        break;
    }
  }
  // So far there are only sums and products of non-negative doubles, fewer than 2^10 in a row: each changes the result
  // by less than 2^-52 of it, all of them by less than 2^-40.
  std::array<double, comparison_count> bounds;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    bounds[k] = (reach[recording.lhs[k]].error + reach[recording.rhs[k]].error) * (1 + 0x1p-40);
  }
  return bounds;
}

}  // namespace axiscert::proofs

#include "proofs/program.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace axiscert::proofs {
std::size_t Program::input(std::string name) {
  steps_.push_back({Operation::input, {}, std::move(name)});
  return steps_.size() - 1;
}

std::size_t Program::step(Operation operation, std::array<std::size_t, 3> operands) {
  const auto same = [&](const Step& s) { return s.operation == operation && s.operands == operands; };
  const auto found = std::find_if(steps_.begin(), steps_.end(), same);
  const auto index = static_cast<std::size_t>(found - steps_.begin());
  if (found == steps_.end()) steps_.push_back({operation, operands, {}});
  return index;
}

void Program::name(std::size_t step, const std::string& name) {
  if (steps_[step].name.empty()) steps_[step].name = name;
}

std::size_t Program::named(const std::string& name) const {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (steps_[i].name == name) return i;
  }
  throw std::logic_error("the recorded program has no " + name);
}

std::vector<std::size_t> Program::needed_by(const std::vector<std::size_t>& results) const {
  std::vector<bool> needed(steps_.size());
  for (const std::size_t result : results) needed[result] = true;
  for (std::size_t i = steps_.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (std::size_t k = 0; k < operand_count(steps_[i].operation); ++k) needed[steps_[i].operands[k]] = true;
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (needed[i]) order.push_back(i);
  }
  return order;
}

std::string identifier(Comparison which) {
  std::string name(info(which).name);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

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

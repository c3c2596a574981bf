// Scenes in another unit of length, and the units in which formulae of a degree neither overflow nor underflow.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "fuzz/diagnosis/scenes.h"
#include "kernel/ask.h"

namespace axiscert::diagnosis {

// The numbers with those of `columns` times 2^exponent; empty where one of them is not exactly that.
template <class Real>
std::optional<Numbers<Real>> times_exactly(Numbers<Real> numbers, const std::vector<std::size_t>& columns,
                                           int exponent) {
  for (const std::size_t k : columns) {
    const Real scaled = std::ldexp(numbers[k], exponent);
    if (!std::isfinite(scaled) || std::ldexp(scaled, -exponent) != numbers[k]) return std::nullopt;
    numbers[k] = scaled;
  }
  return numbers;
}

// Columns whose numbers may all be multiplied by one power of two without another answer.
struct Scaling {
  std::vector<std::size_t> columns;
  // The degree up to which right formulae have these numbers, and stay in range.
  int most_degree;
};
// All that has a length: places, lengths and displacements (in_unit).
Scaling unit_of_length(const Kernel& kernel);
// Each quaternion: four numbers of a direction, which has any length but 0.
std::vector<Scaling> quaternions(const Kernel& kernel);

// The query in another unit of length, exactly, or nothing.
template <class Real>
std::optional<Numbers<Real>> exact_in_unit(const Kernel& kernel, const Numbers<Real>& numbers, int exponent) {
  return times_exactly(numbers, unit_of_length(kernel).columns, exponent);
}

// The powers of two times which formulae of a degree keep a query's numbers in range, by what the built-in forms of the
// predicate compute of it.
struct UnitRange {
  // log2 of sizes, which are |side|^(1 / degree): of the least, and of the greatest side or number.
  double least_size, greatest_size;
  int degree_of_forms;  // the greatest of a side

  // Nothing overflows, and no side gets near the subnormal numbers.
  template <class Real>
  bool holds(int exponent, int degree) const {
    using Limits = std::numeric_limits<Real>;
    constexpr int bits_of_sums = 8, bits_kept = 4;
    return degree * (least_size + exponent) >= Limits::min_exponent + bits_kept &&
           degree * (greatest_size + exponent) <= Limits::max_exponent - bits_of_sums;
  }
};

// The built-in forms of a kernel's predicate and entry that show their sides.
template <class Real>
class SidesOfForms {
 public:
  explicit SidesOfForms(const Kernel& of) {
    for (const Kernel& kernel : kernels()) {
      if (kernel.predicate != of.predicate || kernel.entry != of.entry || !kernel.has(precision_of<Real>)) continue;
      if (kernel.exposes != Exposure::sides || !kernel.file.empty()) continue;
      Implementation<Real> form = kernel.on<Real>(scalar_target);
      if (form.explain) forms_.push_back(std::move(form));
    }
  }
  bool empty() const { return forms_.empty(); }

  // Empty where a side of a form is not the same significand at twice the size: it has left the range already.
  std::optional<UnitRange> range(const Numbers<Real>& query, const Scaling& scaling) const {
    const auto doubled = times_exactly(query, scaling.columns, 1);
    if (!doubled) return std::nullopt;
    UnitRange range{std::numeric_limits<double>::infinity(), greatest_of(query, scaling), 0};
    // The greater side of a comparison: the other is nothing beside it where it is lost.
    const auto add = [&](const Sides& one, const Sides& two) {
      if (!same_significand(one.lhs, two.lhs) || !same_significand(one.rhs, two.rhs)) return false;
      const bool is_left = std::abs(one.lhs) >= std::abs(one.rhs);
      const Real greater = is_left ? one.lhs : one.rhs;
      if (greater == 0) return true;
      const int degree = std::ilogb(is_left ? two.lhs : two.rhs) - std::ilogb(greater);
      if (degree <= 0) return true;  // a quotient, or of another part of the query
      const double size = std::log2(std::abs(static_cast<double>(greater))) / degree;
      range.least_size = std::min(range.least_size, size);
      range.greatest_size = std::max(range.greatest_size, size);
      range.degree_of_forms = std::max(range.degree_of_forms, degree);
      return true;
    };
    if (!for_each_comparison(query, *doubled, add) || range.degree_of_forms == 0) return std::nullopt;
    return range;
  }

  // Whether every side of every form has the same significand for both queries: then no form leaves the range.
  bool commute(const Numbers<Real>& one, const Numbers<Real>& other) const {
    return for_each_comparison(one, other, [](const Sides& x, const Sides& y) {
      return same_significand(x.lhs, y.lhs) && same_significand(x.rhs, y.rhs);
    });
  }

 private:
  struct Sides {
    Real lhs, rhs;
  };
  static bool same_significand(Real x, Real y) {
    int of_x, of_y;
    return std::isfinite(x) && std::isfinite(y) && std::frexp(x, &of_x) == std::frexp(y, &of_y);
  }
  static double greatest_of(const Numbers<Real>& query, const Scaling& scaling) {
    double greatest = 0;
    for (const std::size_t k : scaling.columns) greatest = std::max(greatest, std::abs(static_cast<double>(query[k])));
    return std::log2(2 * greatest);  // of a difference of two
  }

  template <class Keep>
  bool for_each_comparison(const Numbers<Real>& one, const Numbers<Real>& other, Keep keep) const {
    QueryBatch<Real> batch(2, one.size());
    batch.push_back(one);
    batch.push_back(other);
    Reply<Real> reply;
    for (const Implementation<Real>& form : forms_) {
      axiscert::ask(form, batch.columns(), reply);
      const auto &lhs = reply.answers.lhs, &rhs = reply.answers.rhs;
      for (std::size_t k = 0; k < lhs.size(); ++k) {
        if (!keep(Sides{lhs[k][0], rhs[k][0]}, Sides{lhs[k][1], rhs[k][1]})) return false;
      }
    }
    return true;
  }

  std::vector<Implementation<Real>> forms_;
};

}  // namespace axiscert::diagnosis

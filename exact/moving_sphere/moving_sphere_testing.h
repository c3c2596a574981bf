// For the tests of the moving sphere: queries by hand and at random, oracles with a planted fault, and rows of the
// tables of docs/moving.md.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "exact/judge/oracles_of.h"
#include "exact/moving_sphere/first_contact.h"
#include "exact/moving_sphere/trait.h"
#include "exact/numbers/floating.h"
#include "kernel/ask.h"

namespace axiscert::moving_sphere {

// The motion from (0, 0, 3) by `d` past the triangle (0,0,0) (4,0,0) (0,4,0).
inline MovingQuery<double> at_the_corner(const portable::Vec3<double>& p, const portable::Vec3<double>& d, double r) {
  return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, d, r};
}

// Small integers, degenerate queries among them.
inline MovingQuery<double> small_query(std::mt19937_64& random, int bound) {
  const auto whole = [&] {
    return static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(2 * bound + 1)) - bound);
  };
  const auto point = [&] {
    const double x = whole(), y = whole(), z = whole();
    return portable::Vec3<double>{x, y, z};
  };
  MovingQuery<double> q;
  for (portable::Vec3<double>* v : {&q.a, &q.b, &q.c, &q.p, &q.d}) *v = point();
  q.r = static_cast<double>(random() % static_cast<unsigned>(4 * bound + 1)) / 2;
  return q;
}

// Faults of the twenty axes: one comparison with its sides exchanged, or one axis that never separates.
struct PlantedAxes : Twenty {
  inline static std::size_t exchanged = comparison_names.size();  // none
  inline static std::string_view dropped = "";
  template <class T, class Sink>
  static void comparisons(const MovingSphere::Problem<T>& q, Sink& sink) {
    const T zero(0.0);
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) {
      if (clause_name(i) == dropped && is_radius(i)) sink(i, zero, zero);
      else if (i == exchanged) sink(i, rhs, lhs);
      else sink(i, lhs, rhs);
    };
    Twenty::comparisons<T>(q, planted);
  }
};
struct WithPlantedAxes : MovingSphereTrait {
  using AllFormulae = FormulaeList<PlantedAxes>;
};

// A bound that should be closed: touching is no contact.
struct WithOpenBound : MovingSphereTrait {
  static Truth geometric_truth(const Numbers<double>& numbers) {
    const Truth right = MovingSphereTrait::geometric_truth(numbers);
    return right.touching ? Truth{Verdict::separated, false} : right;
  }
};

// For tests whose numbers stand in docs/moving.md or another page: the kernels' answers beside the exact ones, and rows
// of a table.

// The answers of one kernel to a batch, in scalar form.
template <class Real>
class KernelAnswers {
 public:
  KernelAnswers(std::string_view id, const QueryBatch<Real>& batch) {
    ask(find_kernel("moving-sphere/" + std::string(id)).on<Real>(scalar_target), batch.columns(), reply_);
  }
  bool is_contact(std::size_t i) const { return reply_.verdicts[i] == Verdict::contact; }
  bool has_time() const { return !reply_.answers.measures.empty(); }
  double time(std::size_t i) const { return static_cast<double>(reply_.answers.measures[0][i]); }

 private:
  Reply<Real> reply_;
};

inline MovingQuery<double> exactly(const Numbers<float>& q) {
  return MovingSphere::problem<double>([&](std::size_t k) { return static_cast<double>(q[k]); });
}
inline MovingQuery<double> exactly(const Numbers<double>& q) {
  return MovingSphere::problem<double>([&](std::size_t k) { return q[k]; });
}

// The time to about 2^-50 of itself: rest - sqrt(square) as a quotient, in which nothing cancels.
inline double value_of(const RootTime& t) {
  const Rational product = t.rest * t.rest - t.square;
  const double sum = t.rest.get_d() + std::sqrt(t.square.get_d());
  return sum == 0 ? 0 : product.get_d() / sum;
}

inline std::string table_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row;
}

// Each row has to stand in docs/moving.md, as a line of its own.
inline void expect_in_the_document(const std::vector<std::string>& rows) {
  const std::string page = "docs/moving.md";
  std::ifstream file(SOURCE_FOLDER "/" + page);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  for (const std::string& row : rows) {
    EXPECT_NE(std::find(lines.begin(), lines.end(), row), lines.end()) << page << " has to have the line\n" << row;
  }
}

}  // namespace axiscert::moving_sphere

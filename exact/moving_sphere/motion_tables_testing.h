// For tests whose numbers stand in docs/moving.md or another page: the kernels' answers beside the exact ones, and rows
// of a table.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "exact/moving_sphere/first_contact.h"
#include "exact/numbers/floating.h"
#include "kernel/ask.h"

namespace axiscert::moving_sphere {

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

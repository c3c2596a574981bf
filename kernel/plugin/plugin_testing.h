// Parts that the tests of plug-ins and of programs share: a batch of queries, and what became of it.
#pragma once

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::plugin_testing {

inline constexpr std::size_t wrong_query = 700;  // of the batch: the one that the crashing and the hanging stop at

// Spheres about the origin and triangles a unit away, so that half of them touch; one sphere is enormous.
inline const QueryBatch<float>& queries() {
  static const QueryBatch<float> batch = [] {
    QueryBatch<float> all(1021, coordinate_count);  // no multiple of a vector's lanes
    std::mt19937 random(7);
    const auto uniform = [&] { return static_cast<float>(random()) * 0x1p-31f - 1; };
    for (std::size_t i = 0; i < 1021; ++i) {
      const auto vertex = [&] { return Vec3<float>{uniform() + 1.5f, uniform(), uniform()}; };
      const float r = i == wrong_query ? 1e30f : 0.5f + 0.4f * uniform();
      all.push_back(Query<float>{vertex(), vertex(), vertex(), {0, 0, 0}, r});
    }
    return all;
  }();
  return batch;
}

struct SeenAnswers {
  std::vector<Verdict> verdicts;
  std::vector<Finding> findings;
  std::uint64_t asked_again = 0;
};

// The kernel's answers to the batch, and what its supervisor found.
inline SeenAnswers supervised(const Kernel& kernel) {
  SeenAnswers seen;
  seen.verdicts.resize(queries().size());
  Answers<float> answers;
  answers.resize(queries().size(), comparison_count);
  Watched watched;
  kernel.on<float>(scalar_target).supervised(queries().columns(), seen.verdicts.data(), answers, watched);
  seen.findings = std::move(watched.findings);
  seen.asked_again = watched.asked_again;
  return seen;
}

inline std::vector<Verdict> right_verdicts() {
  std::vector<Verdict> verdicts(queries().size());
  find_kernel("nonstrict").on<float>(scalar_target).verdicts(queries().columns(), verdicts.data());
  return verdicts;
}

inline std::size_t unanswered(const SeenAnswers& seen) {
  return static_cast<std::size_t>(std::count(seen.verdicts.begin(), seen.verdicts.end(), Verdict::unanswered));
}

// All but the given queries are answered, and as a right kernel answers them.
inline void expect_right_but(const SeenAnswers& seen, std::initializer_list<std::size_t> without_answer) {
  std::vector<Verdict> expected = right_verdicts();
  for (const std::size_t i : without_answer) expected[i] = Verdict::unanswered;
  EXPECT_EQ(seen.verdicts, expected);
}

inline Finding only_finding(const SeenAnswers& seen) {
  EXPECT_EQ(seen.findings.size(), 1u);
  for (const Finding& finding : seen.findings) {
    SCOPED_TRACE(fmt::format("{} at {}: {}", name(finding.kind), finding.index, finding.detail));
    EXPECT_LT(finding.index, queries().size());
  }
  return seen.findings.empty() ? Finding{} : seen.findings.front();
}

}  // namespace axiscert::plugin_testing

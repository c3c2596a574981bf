// The loss of b^2 - a c by distance: ordinary queries in binary32 from further and further away, against the exact
// answer. The table of docs/moving.md, and what it says of the times.
#include <gtest/gtest.h>

#include <random>

#include "exact/moving_sphere/moving_sphere_testing.h"

namespace axiscert::moving_sphere {
namespace {

// Uniform in [-bound, bound), with the 24 bits of a float.
float uniform_float(std::mt19937_64& random, float bound) {
  return (static_cast<float>(random() >> 40) * 0x1p-23f - 1) * bound;
}

// Triangle and radius of about 1, centre in [-R, R]^3, and D towards a point near the triangle and up to half as far
// again.
MovingQuery<float> aimed_query(std::mt19937_64& random, float distance) {
  const auto point = [&](float bound) {
    const float x = uniform_float(random, bound), y = uniform_float(random, bound), z = uniform_float(random, bound);
    return portable::Vec3<float>{x, y, z};
  };
  MovingQuery<float> q;
  for (auto* corner : {&q.a, &q.b, &q.c}) *corner = point(1);
  q.p = point(distance);
  const portable::Vec3<float> aim = point(2);
  q.d = (aim - q.p) * (1.25f + uniform_float(random, 0.25f));
  q.r = 0.75f + uniform_float(random, 0.25f);
  return q;
}

struct RoundingCounts {
  int missed = 0, phantoms = 0, late = 0;
  std::vector<double> ulps;
  double median() {
    std::nth_element(ulps.begin(), ulps.begin() + static_cast<std::ptrdiff_t>(ulps.size() / 2), ulps.end());
    return ulps[ulps.size() / 2];
  }
};

double ulps_apart(double t, double exact_time) {
  const auto near = static_cast<float>(exact_time);
  const double ulp = static_cast<double>(std::nextafter(near, 2.0f)) - static_cast<double>(near);
  return std::fabs(t - exact_time) / ulp;
}

RoundingCounts counted(std::string_view id, const QueryBatch<float>& batch,
                       const std::vector<std::optional<FirstContact>>& truths) {
  const KernelAnswers<float> kernel(id, batch);
  RoundingCounts counts;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (!truths[i]) counts.phantoms += kernel.is_contact(i);
    else if (!kernel.is_contact(i)) ++counts.missed;
    else if (kernel.has_time()) {
      counts.ulps.push_back(ulps_apart(kernel.time(i), value_of(truths[i]->time)));
      counts.late += compare(truths[i]->time, Rational(kernel.time(i))) < 0;
    }
  }
  return counts;
}

TEST(RoundingByDistanceLong, IsThatOfTheDocument) {
  constexpr std::uint64_t seed = 20261123;
  constexpr int queries = 30000 / TRIAL_DIVISOR;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::vector<std::string> verdicts;
  for (const int distance : {16, 256, 1024, 4096}) {
    std::mt19937_64 random(seed + static_cast<std::uint64_t>(distance));
    QueryBatch<float> batch(queries, 16);
    std::vector<std::optional<FirstContact>> truths;
    int contacts = 0;
    for (int i = 0; i < queries; ++i) {
      batch.push_back(aimed_query(random, static_cast<float>(distance)));
      truths.push_back(first_contact(exactly(batch[static_cast<std::size_t>(i)])));
      contacts += truths.back().has_value();
    }
    std::vector<std::string> verdict = {std::to_string(distance), std::to_string(contacts)};
    for (const std::string_view id : {"rounded", "rounded-quotient", "rounded-products", "gated", "twenty-nonstrict"}) {
      RoundingCounts counts = counted(id, batch, truths);
      verdict.push_back(fmt::format("{} / {}", counts.missed, counts.phantoms));
      if (counts.ulps.empty()) continue;
      const double off = counts.median();
      if (distance == 4096 && (id == "rounded" || id == "rounded-quotient")) {
        EXPECT_GT(off, 1000) << id << ": ulps of its time in the median";
        EXPECT_GT(counts.missed, contacts / 50) << "b^2 - a c loses contacts";
      }
      if (id == "rounded-products" || id == "gated") {
        EXPECT_LT(off, 1) << id << " at " << distance << ": ulps of its time in the median";
        EXPECT_LE(counts.missed, 2) << "of " << contacts;
      }
      if (id == "gated") {
        EXPECT_NEAR(counts.late / static_cast<double>(counts.ulps.size()), 0.5, 0.1) << "as often late as early";
      }
    }
    verdicts.push_back(table_row(verdict));
  }
  if (TRIAL_DIVISOR != 1) return;
  expect_in_the_document(verdicts);
}

}  // namespace
}  // namespace axiscert::moving_sphere

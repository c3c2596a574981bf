// The faults of each form of sweep over the reals, by class of query: binary64 on small integers, where hardly
// anything is rounded. The table of docs/moving.md.
#include <gtest/gtest.h>

#include "exact/moving_sphere/moving_sphere_testing.h"

namespace axiscert::moving_sphere {
namespace {

enum class QueryClass : std::uint8_t { general, parallel, touching, start, point, no_area, no_motion };
constexpr std::size_t class_count = 7;

struct ClassedQuery {
  QueryClass its_class;
  std::optional<FirstContact> contact;
};

// The last of these that a query is: `start` begins in contact, `touching` grazes or touches at the end.
QueryClass class_of(const MovingQuery<double>& q, const std::optional<FirstContact>& contact) {
  const auto normal = cross(q.b - q.a, q.c - q.a);
  if (dot(q.d, q.d) == 0) return QueryClass::no_motion;
  if (dot(normal, normal) == 0) return QueryClass::no_area;
  if (q.r == 0) return QueryClass::point;
  if (contact && contact->start != Start::clear) return QueryClass::start;
  if (contact && cmp(least_distance(q).squared, Rational(Rational(q.r) * Rational(q.r))) == 0)
    return QueryClass::touching;
  if (dot(q.d, normal) == 0) return QueryClass::parallel;
  return QueryClass::general;
}

// Small integers, and of sixteen queries two without area, one without motion, one of a point, and two that move
// parallel to the plane.
MovingQuery<double> lattice_query(std::mt19937_64& random, int i) {
  MovingQuery<double> q = small_query(random, 2 + i % 3);
  const auto small = [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); };
  const double one = small(), other = small();
  q.d = q.d * static_cast<double>(1 + i % 4);
  q.r = std::min(q.r, 3.0);
  switch (i % 16) {
    case 0:
    case 1:
      q.c = q.a + (q.b - q.a) * one;
      break;
    case 2:
      q.d = portable::Vec3<double>{0, 0, 0};
      break;
    case 3:
      q.r = 0;
      break;
    case 4:
    case 5:
      q.d = (q.b - q.a) * one + (q.c - q.a) * other;
      break;
    default:
      break;
  }
  return q;
}

struct FaultCounts {
  int missed = 0, late = 0, early = 0, phantoms = 0;
  std::string text() const {
    std::string found;
    for (const auto& [count, name] :
         {std::pair{missed, "missed"}, {late, "late"}, {early, "early"}, {phantoms, "phantom"}}) {
      if (count > 0) found += fmt::format("{}{} {}", found.empty() ? "" : ", ", count, name);
    }
    return found.empty() ? "0" : found;
  }
};

// A time further than this from the exact one is no rounding: times here are of the order of 1, in binary64.
const Rational noticeable(1, 1 << 20);

void count_query(const KernelAnswers<double>& kernel, std::size_t i, const ClassedQuery& truth, FaultCounts& counts) {
  if (!truth.contact) {
    counts.phantoms += kernel.is_contact(i);
  } else if (!kernel.is_contact(i)) {
    ++counts.missed;
  } else if (kernel.has_time() && std::isfinite(kernel.time(i))) {
    const Rational t(kernel.time(i));
    counts.late += compare(truth.contact->time, t - noticeable) < 0;
    counts.early += compare(truth.contact->time, t + noticeable) > 0;
  }
}

TEST(FaultTable, IsThatOfTheDocument) {
  constexpr std::uint64_t seed = 20261123;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  constexpr int queries = 12000;
  std::mt19937_64 random(seed);
  QueryBatch<double> batch(queries, 16);
  std::vector<ClassedQuery> truths;
  std::array<int, class_count> contacts{};
  for (int i = 0; i < queries; ++i) {
    const MovingQuery<double> q = lattice_query(random, i);
    batch.push_back(q);
    std::optional<FirstContact> contact = first_contact(q);
    const QueryClass its_class = class_of(q, contact);
    contacts[static_cast<std::size_t>(its_class)] += contact.has_value();
    truths.push_back({its_class, std::move(contact)});
  }

  std::vector<std::string> head = {"contacts"};
  for (const int count : contacts) head.push_back(std::to_string(count));
  std::vector<std::string> rows = {table_row(head)};
  for (const std::string_view id : {"twenty", "twenty-nonstrict", "gated", "walk", "rounded", "fauerby", "physx4",
                                    "physx5", "segment", "advance", "advance-by-length"}) {
    const KernelAnswers<double> kernel(id, batch);
    std::array<FaultCounts, class_count> counts;
    for (std::size_t i = 0; i < truths.size(); ++i) {
      count_query(kernel, i, truths[i], counts[static_cast<std::size_t>(truths[i].its_class)]);
    }
    std::vector<std::string> cells = {fmt::format("`{}`", id)};
    for (const FaultCounts& count : counts) cells.push_back(count.text());
    rows.push_back(table_row(cells));
  }
  expect_in_the_document(rows);
}

}  // namespace
}  // namespace axiscert::moving_sphere

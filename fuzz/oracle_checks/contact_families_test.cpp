// The numbers of contacts over every family and a mesh, within their bounds of the exact ones.
#include <gtest/gtest.h>

#include "exact/sphere_triangle/certified_contact_truth.h"
#include "fuzz/queries/source.h"
#include "kernel/include/axiscert/contact.hpp"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Families whose queries take the truth long are asked a part, as a run asks them.
template <class Real>
void expect_within_bounds(const Source& source, std::size_t size, axiscert_question question) {
  QueryBatch<Real> batch(size, coordinate_count);
  source.fill(7, 0, size, batch);
  std::array<const Real*, coordinate_count> columns;
  std::copy_n(batch.columns().column.begin(), coordinate_count, columns.begin());
  const auto all = testing_support::contacts_said<Real>(columns, size, question);
  for (std::size_t i = 0; i < size; ++i) {
    std::array<double, 13> q;
    for (std::size_t k = 0; k < 13; ++k) q[k] = columns[k][i];
    const testing_support::ContactSaid& said = all[i];
    ASSERT_EQ(testing_support::what_is_wrong<Real>(q, question == AXISCERT_OPEN_SPHERE, said), "")
        << source.name() << ", query " << i << ", question " << question << ": " << testing::PrintToString(q);
  }
}
void expect_within_bounds(std::size_t size) {
  const auto both = [size](const Source& source, std::size_t divisor) {
    expect_within_bounds<float>(source, size / divisor, AXISCERT_CLOSED_SPHERE);
    expect_within_bounds<double>(source, size / divisor, AXISCERT_CLOSED_SPHERE);
    expect_within_bounds<float>(source, size / divisor / 4, AXISCERT_OPEN_SPHERE);
    expect_within_bounds<double>(source, size / divisor / 4, AXISCERT_OPEN_SPHERE);
  };
  for (const Family* family : all_families_of(sphere_triangle_predicate())) {
    both(*family_source(*family), family->cost > 1 ? 16 : 1);
  }
  both(*mesh_source(TEST_MODELS "/OBJ/spider.obj", sphere_triangle_predicate()), 1);
}

// A third way: the rationals and CGAL by which the judge goes.
template <class Real>
void expect_the_judges_place(std::size_t size) {
  for (const Family* family : all_families_of(sphere_triangle_predicate())) {
    const std::size_t asked = size / (family->cost > 1 ? 16 : 1);
    QueryBatch<Real> batch(asked, coordinate_count);
    family_source(*family)->fill(8, 0, asked, batch);
    std::array<const Real*, coordinate_count> columns;
    std::copy_n(batch.columns().column.begin(), coordinate_count, columns.begin());
    const auto all = testing_support::contacts_said<Real>(columns, asked, AXISCERT_CLOSED_SPHERE);
    for (std::size_t i = 0; i < asked; ++i) {
      std::array<double, 13> q;
      for (std::size_t k = 0; k < 13; ++k) q[k] = columns[k][i];
      ASSERT_EQ(testing_support::what_is_wrong_for_the_judge(q, all[i]), "")
          << family->name << ", query " << i << ": " << testing::PrintToString(q);
    }
  }
}

TEST(ContactFamilies, WithinTheirBounds) { expect_within_bounds(4096 / TRIAL_DIVISOR); }
TEST(ContactFamiliesLong, WithinTheirBounds) { expect_within_bounds((std::size_t{1} << 20) / TRIAL_DIVISOR); }

TEST(ContactFamiliesLong, PartAndVerdictAreTheJudges) {
  expect_the_judges_place<float>(10000 / TRIAL_DIVISOR);
  expect_the_judges_place<double>(10000 / TRIAL_DIVISOR);
}

}  // namespace
}  // namespace axiscert

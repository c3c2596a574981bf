// Proved bounds compared with the errors that a search attains: a greater error would refute the proof or its
// interpretation.
#include "fuzz/search/proved.h"

#include <gtest/gtest.h>

#include "fuzz/queries/family.h"
#include "fuzz/search/search.h"

namespace axiscert {
namespace {

TEST(Proved, NowhereDoesASearchExceedIt) {
  for (const char* id : {"published", "reduced", "published+fma", "reduced+fma"}) {
    SearchPlan plan;
    plan.kernel = &find_kernel(id);
    for (std::size_t k = 0; k < comparison_count; ++k) plan.comparisons.push_back(k);
    for (const char* name : {"general", "sliver"}) plan.sources.push_back(family_source(find_family(name)));
    plan.evaluations = 1'000'000;
    plan.target = resolve_target("auto");
    const SearchResult result = search(plan, {}, false, [](const SearchProgress&) {});
    std::size_t errors = 0;
    for (const Find& find : result.finds) {
      if (find.aim.goal != Goal::error) continue;
      const auto proved = proved_error(*plan.kernel, plan.precision, find.aim.which);
      ASSERT_TRUE(proved) << id;
      EXPECT_LE(find.value, *proved) << id << " " << comparisons[find.aim.which].name;
      ++errors;
    }
    EXPECT_GT(errors, 0u) << id;
  }
}

// Other forms, and arithmetics that round differently, have other errors.
TEST(Proved, OnlyOfTheProgramsThatWereRecorded) {
  for (const char* id : {"reduced-along", "published+kahan", "ladder-0", "published+up"}) {
    EXPECT_FALSE(proved_error(find_kernel(id), Precision::binary32, index_of(Comparison::plane_radius))) << id;
  }
  EXPECT_EQ(proved_error(find_kernel("published"), Precision::binary64, index_of(Comparison::vertex_a_radius))->value(),
            8);
}

}  // namespace
}  // namespace axiscert

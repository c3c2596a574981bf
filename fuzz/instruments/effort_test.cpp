// The efforts: smaller where a query costs more, and as docs/certify.md has them.
#include "fuzz/instruments/effort.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

TEST(Effort, AsksFewerWhereAQueryCostsMore) {
  for (const Effort effort : enumerators<Effort>) {
    EXPECT_EQ(parse_effort(effort_names[effort]), effort);
    const EffortSize first = size_of(effort, sphere_triangle_predicate(), false);
    if (effort != Effort::smoke) {
      EXPECT_LT(size_of(effort, sphere_triangle_predicate(), true).trials, first.trials);
    }
    EXPECT_LT(size_of(effort, find_predicate("box-box"), false).trials, first.trials);
    EXPECT_LT(trials_of(effort, *family_source(find_family("bits")), false),
              trials_of(effort, *family_source(find_family("general")), false));
  }
  EXPECT_LT(size_of(Effort::quick, sphere_triangle_predicate(), false).trials,
            size_of(Effort::standard, sphere_triangle_predicate(), false).trials);
  EXPECT_THROW(parse_effort("quickly"), Error);
}

// Fewer right answers than that are no evidence: no level could be met.
TEST(Effort, AsksEveryFamilyEnoughToBeEvidence) {
  constexpr std::uint64_t enough = 59;
  for (const Predicate* predicate : predicates()) {
    for (const Family* family : families_of(*predicate, 0)) {
      const std::uint64_t trials = trials_of(Effort::smoke, *family_source(*family), true);
      const Oracles& oracles = oracles_of(*predicate);
      std::uint64_t valid = 0;
      for (std::uint64_t i = 0; i < trials; ++i) {
        const Numbers<float> query = family_source(*family)->make<float>(1, i);
        valid += oracles.truth(query).verdict != Verdict::invalid;
      }
      EXPECT_GE(valid, enough) << family->name;
    }
  }
}

TEST(Effort, HasTheNumbersOfItsDocument) {
  const std::string page = read_bytes(SOURCE_FOLDER "/docs/certify.md");
  const auto power = [](std::uint64_t number) {
    int exponent = 0;
    while (std::uint64_t{1} << exponent < number) ++exponent;
    EXPECT_EQ(std::uint64_t{1} << exponent, number);
    return fmt::format("2^{}", exponent);
  };
  for (const Effort effort : enumerators<Effort>) {
    const EffortSize size = size_of(effort, sphere_triangle_predicate(), false);
    const std::string row =
        fmt::format("| `{}` | {} | {} | {} | one in {}, on {} queries |", effort_names[effort], power(size.trials),
                    power(size.evaluations), power(size.probes), power(size.mutant_stride), power(size.mutant_trials));
    EXPECT_NE(page.find(row), page.npos) << row;
  }
}

}  // namespace
}  // namespace axiscert

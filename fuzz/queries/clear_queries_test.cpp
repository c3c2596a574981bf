// The clear queries of every family: the oracles have the clear verdict, and so have the right forms among the built-in
// kernels. That is checked here, and is no part of what makes a query clear.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "exact/judge/oracles.h"
#include "exact/judge/rough_number.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/ask.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

constexpr std::size_t queries_of_a_family = 128;

// Forms that are right over the reals, as far as their inputs go, by predicate; ids that end with one of these.
constexpr std::string_view right_forms[] = {"published",
                                            "nonstrict",
                                            "reduced",
                                            "ladder-0",
                                            "minkowski",
                                            "segments",
                                            "eigen",
                                            "packed-nonstrict",
                                            "moving-sphere/twenty-nonstrict",
                                            "moving-sphere/gated",
                                            "moving-sphere/rounded-quotient",
                                            "moving-sphere/ends-twenty-nonstrict",
                                            "moving-sphere/ends-gated",
                                            "capsule-triangle/twenty-nonstrict",
                                            "box-box/projected",
                                            "box-box/textbook",
                                            "box-box/cofactor",
                                            "box-box/textbook-early",
                                            "box-box/projected-turned",
                                            "box-box/textbook-turned",
                                            "box-box/cofactor-turned",
                                            "box-box/homogeneous",
                                            "box-box/intervals-minmax",
                                            "box-box/projected-minmax",
                                            "box-box/textbook-minmax",
                                            "box-box/cofactor-minmax",
                                            "box-box/projected-mixed",
                                            "box-box/textbook-mixed",
                                            "box-box/cofactor-mixed",
                                            "box-triangle/textbook",
                                            "box-triangle/akenine-moller",
                                            "box-triangle/thirteen",
                                            "box-triangle/textbook-minmax",
                                            "box-triangle/thirteen-minmax",
                                            "box-triangle/textbook-oriented",
                                            "box-triangle/thirteen-oriented",
                                            "box-triangle/textbook-turned",
                                            "box-triangle/thirteen-turned"};

struct ClearCounts {
  std::uint64_t clear = 0, contact = 0;
};

template <class Real>
ClearCounts ask_about(const Family& family, const std::vector<const Kernel*>& forms) {
  ClearCounts counts;
  const Oracles& oracles = oracles_of(family.predicate(), family.entry);
  QueryBatch<Real> batch(queries_of_a_family, family.column_count());
  batch.resize(queries_of_a_family);
  family.fill(7, 0, batch.mutable_columns());
  std::vector<Reply<Real>> replies(forms.size());
  for (std::size_t k = 0; k < forms.size(); ++k) {
    Implementation<Real> implementation = forms[k]->on<Real>(scalar_target);
    ask(implementation, batch.columns(), replies[k]);
  }
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> q = batch[i];
    const std::optional<Verdict> clear = oracles.clear_verdict(q);
    if (!clear) continue;
    ++counts.clear;
    counts.contact += *clear == Verdict::contact;
    const Truth truth = oracles.truth(q);
    EXPECT_EQ(truth.verdict, *clear) << family.name << " " << name(precision_of<Real>) << " " << i;
    EXPECT_FALSE(truth.touching) << family.name << " " << i;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      EXPECT_EQ(replies[k].verdicts[i], *clear)
          << forms[k]->id << " on " << family.name << " " << name(precision_of<Real>) << " " << i;
    }
  }
  return counts;
}

class ClearQueriesOf : public testing::TestWithParam<const Predicate*> {};

TEST_P(ClearQueriesOf, HaveTheExactVerdictAndThatOfRightForms) {
  std::string table;
  ClearCounts all;
  for (const Family* family : families_of(*GetParam())) {
    std::vector<const Kernel*> forms;
    for (const std::string_view id : right_forms) {
      const Kernel& kernel = find_kernel(id);
      if (kernel.predicate == GetParam() && kernel.entry == family->entry) forms.push_back(&kernel);
    }
    ASSERT_FALSE(forms.empty()) << family->name;
    const ClearCounts in32 = ask_about<float>(*family, forms), in64 = ask_about<double>(*family, forms);
    table += fmt::format("{:<28} {:>4} {:>4} of {}\n", family->name, in32.clear, in64.clear, queries_of_a_family);
    all.clear += in32.clear + in64.clear;
    all.contact += in32.contact + in64.contact;
  }
  RecordProperty("clear", static_cast<int>(all.clear));
  EXPECT_GT(all.contact, 100u) << table;
  EXPECT_GT(all.clear - all.contact, 100u) << table;
}
INSTANTIATE_TEST_SUITE_P(Predicates, ClearQueriesOf, testing::ValuesIn(predicates().begin(), predicates().end()),
                         [](const auto& tested) {
                           std::string name(tested.param->id);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// A verdict that is wrong by less than the bound is not seen, and by more it is.
TEST(RoughNumber, IsCertainBeyondItsBoundAlone) {
  using Rough = RoughNumber<float>;
  const Rough one(1.0), near(1.0 + 0x1p-20), far(1.0 + 0x1p-17);
  const Rough square = one * one;
  EXPECT_EQ(square.error(), 16 * 0x1p-24 + rough_least<float>);
  EXPECT_FALSE(is_certain(near, square));
  EXPECT_TRUE(is_certain(far, square));
  EXPECT_TRUE(is_certain(Rough(0.0) * near, Rough(0.0)));  // both are exact
  EXPECT_FALSE(is_certain(Rough(0x1p127) * Rough(2.0), one));
  EXPECT_FALSE(is_certain(Rough(0x1p-100) * Rough(0x1p-60), Rough(0.0)));
  EXPECT_FALSE(is_certain(one / (near - one * near), one));
}

}  // namespace
}  // namespace axiscert

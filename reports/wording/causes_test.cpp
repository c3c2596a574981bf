// The order in which a cause is said: slacks, absolute numbers and classes.
#include "reports/wording/causes.h"

#include <gtest/gtest.h>

namespace axiscert {
namespace {

// A class, and slacks on `shown` of 1000 queries; none where it is 0.
KernelRecord kernel_with(SlackSide side, std::uint64_t shown) {
  KernelRecord kernel;
  CauseRecord& cause = kernel.cause.emplace();
  cause.is_known = true;
  cause.phrase = "spheres nearest to edge bc";
  cause.wrong = cause.of = 10;
  SlacksRecord& slacks = kernel.slack.emplace();
  slacks.bracketed = 1000;
  if (shown == 0) return kernel;
  SlackRecord& slack = slacks.found.emplace_back();
  slack.side = side;
  slack.size = 0.5;
  slack.shown = slack.looked_at = shown;
  slack.where = Name("beside edge bc");
  return kernel;
}
// In a family of images, of whose bases the number explains some.
KernelRecord with_number(KernelRecord kernel, const char* family, std::uint64_t bases, std::uint64_t explains) {
  FamilyRecord record;
  ImageChangesRecord& scale = record.invariance.emplace()[ImageKind::scale];
  scale.wrong.emplace().where_small = {bases, {{Name("r"), 1, 0.01, 0.01, explains}}};
  kernel.families.put(family) = record;
  return kernel;
}

const std::string class_text = "wrong on 10 of 10 spheres nearest to edge bc; right elsewhere (0 of 0)",
                  number = "as if an absolute number near 0.01 (squared 0.0001) were compared with r";
std::string slack(const char* side, int shown) {
  return "a slack: contact comes too " + std::string(side) + " by 0.5, an absolute length, on " +
         std::to_string(shown) + " of " + std::to_string(shown) + " queries beside edge bc";
}

TEST(CauseSentence, ASlackOfManyQueriesIsFirst) {
  EXPECT_EQ(cause_sentence(kernel_with(SlackSide::late, 250)), slack("late", 250) + "; " + class_text);
  EXPECT_EQ(cause_sentence(with_number(kernel_with(SlackSide::early, 250), "units", 16, 16)),
            slack("early", 250) + "; " + number + "; " + class_text);
}
TEST(CauseSentence, ALateSlackOfFewQueriesIsLast) {
  EXPECT_EQ(cause_sentence(kernel_with(SlackSide::late, 249)), class_text + "; " + slack("late", 249));
  EXPECT_EQ(cause_sentence(kernel_with(SlackSide::early, 249)), slack("early", 249) + "; " + class_text);
  EXPECT_EQ(cause_sentence(with_number(kernel_with(SlackSide::early, 249), "units", 16, 16)),
            number + "; " + slack("early", 249) + "; " + class_text);
}
TEST(CauseSentence, ANumberExplainsNearlyAllBasesOfEachFamily) {
  const KernelRecord none = kernel_with(SlackSide::early, 0);
  EXPECT_EQ(cause_sentence(with_number(none, "units", 100, 95)), number + "; " + class_text);
  EXPECT_EQ(cause_sentence(with_number(none, "units", 100, 94)), class_text);
  EXPECT_EQ(cause_sentence(with_number(none, "units", 15, 15)), class_text);
  EXPECT_EQ(cause_sentence(with_number(with_number(none, "units", 100, 100), "spans", 50, 40)), class_text);
}

TEST(CauseSentence, ANumberThatMayAsWellBeTheRangeIsNotSaid) {
  KernelRecord kernel = with_number(kernel_with(SlackSide::early, 0), "units", 100, 100);
  ImageChangesRecord& scale = (*kernel.families.put("units").invariance)[ImageKind::scale];
  scale.range.emplace(PowerRangeRecord{-30, 30});
  scale.wrong->by_size = {{-19, 5}, {16, 5}};
  EXPECT_EQ(cause_sentence(kernel), class_text);
  scale.wrong->by_size = {{-5, 5}};
  EXPECT_EQ(cause_sentence(kernel), number + "; " + class_text);
}
TEST(CauseSentence, WhereNoClassIsTheCauseAxesAre) {
  KernelRecord kernel = kernel_with(SlackSide::early, 0);
  kernel.cause->is_known = false;
  const std::string none =
      "no class explains its 0 wrong verdicts on clear queries; the best, spheres nearest to edge "
      "bc, has 0 of them; ";
  FamilyRecord& family = kernel.families.put("general");
  EXPECT_EQ(cause_sentence(kernel),
            none + "a kernel that shows its comparisons is told which of them decide (docs/plugins.md)");
  auto& axes = family.axes.emplace();
  axes.put("a0b1").decisive = 10;
  axes.put("a0b2").decisive = 1000;
  axes.put("a1b0").decisive = 2000;
  EXPECT_EQ(cause_sentence(kernel), none + "axes that decide wrongly: a1b0 2,000, a0b2 1,000");
}

}  // namespace
}  // namespace axiscert

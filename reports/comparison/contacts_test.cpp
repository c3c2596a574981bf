// The first contacts of two runs of a predicate of motions against each other.
#include "reports/comparison/compare.h"
#include "reports/comparison/show.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/motion_run.h"

namespace axiscert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

RunComparison compared(const Json& before, const Json& after) {
  return compare_records(motions(before), motions(after), {});
}

// Those that are not unchanged, as "time.late worse".
std::vector<std::string> changed_cells(const RunComparison& comparison) {
  std::vector<std::string> all;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.change != Change::unchanged) all.push_back(cell.before.name() + " " + std::string(name(cell.change)));
  }
  return all;
}

TEST(CompareContacts, OneLateTimeMoreIsWorseAndOneLessIsBetter) {
  const Json five = contacts(5, 0.25, 0), nine = contacts(9, 0.25, 0);
  EXPECT_EQ(answer(compared(five, five)), "no change");
  const RunComparison worse = compared(five, nine);
  EXPECT_THAT(changed_cells(worse), ElementsAre("time.late worse"));
  EXPECT_EQ(worse.alarms(), 1u);
  EXPECT_FALSE(worse.passes());
  const RunComparison better = compared(nine, five);
  EXPECT_THAT(changed_cells(better), ElementsAre("time.late better"));
  EXPECT_TRUE(better.passes());
  const std::string text = markdown_of(motions(five), motions(nine), worse);
  EXPECT_THAT(text, HasSubstr("5 of 900"));
  EXPECT_THAT(text, HasSubstr("9 of 900"));
  const Json json = data_of(motions(five), motions(nine), worse);
  for (const Json& cell : json["cells"]) {
    if (cell["place"] != "time" || cell["figure"] != "late") continue;
    EXPECT_EQ(cell["old"], 5);
    EXPECT_EQ(cell["new"], 9);
    EXPECT_EQ(cell["new_queries"], 900);
    EXPECT_EQ(cell["witnesses"], Json::array({"late"}));
  }
}

TEST(CompareContacts, ATunnelADepthOfItAndATimeThatIsNotGivenAreCells) {
  EXPECT_THAT(changed_cells(compared(contacts(5, 0.25, 0), contacts(5, 0.5, 0))),
              ElementsAre("time.deepest_tunnel worse"));
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 0), contacts(5, 0, 0.5))),
              ElementsAre("missed.deepest_tunnel new"));
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 1), contacts(5, 0, 0))),
              ElementsAre("missed.through fixed", "missed.deepest_tunnel fixed"));
  Json none = contacts(5, 0, 0);
  none["time"]["none"] = 2;
  none["time"]["best"] = 793;
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 0), none)), ElementsAre("time.none new"));
}

TEST(CompareContacts, OnOtherQueriesOnlyWhatChanceDoesNotExplain) {
  const auto with_other_seed = [](std::uint64_t late, double tunnel) {
    Json record = motions(contacts(late, tunnel, 0));
    record["plan"]["seed"] = 2;
    return compare_records(motions(contacts(5, 0.25, 0)), record, {});
  };
  EXPECT_THAT(changed_cells(with_other_seed(9, 0.75)), IsEmpty());
  const RunComparison worse = with_other_seed(90, 0.75);
  EXPECT_THAT(changed_cells(worse), ElementsAre("time.late worse"));
  EXPECT_THAT(markdown_of(motions(contacts(5, 0.25, 0)), motions(contacts(90, 0.75, 0)), worse),
              Not(HasSubstr("deepest_tunnel")));
}

TEST(CompareContacts, MeasuresThatOnlyOneRunGivesAreSaid) {
  Json with = motions(contacts(5, 0.25, 0)), without = with;
  without["kernels"][0]["measures"] = Json::array();
  for (Json& family : without["kernels"][0]["families"]) family["motion"]["time"] = nullptr;
  const RunComparison lost = compare_records(with, without, {}), gained = compare_records(without, with, {});
  EXPECT_FALSE(lost.passes());
  EXPECT_THAT(answer(lost), testing::StartsWith("NOT COMPARED: <script> binary32: 'time' of first contacts: it gives "
                                                "that in OLD and not in NEW; "));
  EXPECT_TRUE(gained.passes());
  EXPECT_THAT(answer(gained),
              testing::StartsWith("no change; only in NEW: <script> binary32: 'time' of first contacts; "));
  EXPECT_THAT(markdown_of(with, without, lost), HasSubstr("tangent: first contacts"));
}

TEST(CompareContacts, AnotherPredicateHasNone) {
  for (const Cell& cell : cells_of(edited(stored_record()))) EXPECT_FALSE(cell.is_of_contacts()) << cell.name();
}

}  // namespace
}  // namespace axiscert

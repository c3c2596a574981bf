// Stretches: every unit occurs once, in turn; the plan alone determines the result; a repetition reveals a fault of one
// target.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/campaign/stretch_testing.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Tallies of real units: the same bytes in whatever order they were merged, and a round trip.

namespace {

// Tallies of many small units, with flips of every kind and leaders that tie, but no findings.
std::vector<Tally> real_tallies() {
  const Plan plan =
      small_plan({"published", "first-publication"}, {"tangent", "sliver", "tie", "repeated", "scale"}, 1);
  std::vector<Tally> tallies;
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : plan.questions.precisions) {
      for (std::uint64_t unit = 0; unit < 3; ++unit) {
        const UnitResult done = run_unit(plan, *source, precision, unit, 1200 / TRIAL_DIVISOR);
        tallies.insert(tallies.end(), done.tallies.begin(), done.tallies.end());
      }
    }
  }
  return tallies;
}

const std::vector<Tally>& tallies() {
  static const std::vector<Tally> made = [] {
    std::vector<Tally> all = real_tallies();
    // Findings come from plug-ins only.
    for (std::size_t i = 0; i < all.size(); ++i) {
      count_finding(all[i], static_cast<FindingKind>(i % finding_kind_count), i / 2, "of " + std::to_string(i));
    }
    return all;
  }();
  return made;
}

TEST(TallyCode, BytesGiveTheTallyAgain) {
  for (const Tally& tally : tallies()) {
    const std::string bytes = encode(tally);
    EXPECT_EQ(encode(decode_tally(bytes, sphere_triangle_predicate())), bytes);
  }
}

TEST(TallyCode, MergingIsCommutative) {
  const auto& all = tallies();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    Tally ab = all[i], ba = all[i + 1];
    ab.merge(all[i + 1]);
    ba.merge(all[i]);
    EXPECT_EQ(encode(ab), encode(ba)) << i;
  }
}

TEST(TallyCode, MergingIsAssociative) {
  const auto& all = tallies();
  for (std::size_t i = 0; i + 2 < all.size(); ++i) {
    Tally left = all[i], right = all[i + 1], whole = all[i];
    left.merge(all[i + 1]);
    left.merge(all[i + 2]);
    right.merge(all[i + 2]);
    whole.merge(right);
    EXPECT_EQ(encode(left), encode(whole)) << i;
  }
}

// Any order, any grouping, and a round trip through bytes for any of the parts.
TEST(TallyCode, EveryTreeOfMergesGivesTheSameBytes) {
  constexpr std::uint64_t seed = 20261121;
  std::mt19937_64 random(seed);
  std::string expected;
  for (int tree = 0; tree < 60; ++tree) {
    std::vector<Tally> parts = tallies();
    while (parts.size() > 1) {
      std::swap(parts[random() % parts.size()], parts.back());
      Tally last = random() % 2 == 0 ? parts.back() : decode_tally(encode(parts.back()), sphere_triangle_predicate());
      parts.pop_back();
      parts[random() % parts.size()].merge(last);
    }
    if (expected.empty()) expected = encode(parts[0]);
    ASSERT_EQ(encode(parts[0]), expected) << "tree " << tree << " of seed " << seed;
  }
}

TEST(TallyCode, OtherBytesAreRefused) {
  const std::string bytes = encode(tallies()[0]);
  EXPECT_THROW(decode_tally(bytes.substr(0, bytes.size() / 2), sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_tally("", sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_tally(encode(Costs{}), sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_costs(bytes), Error);
}

// Families of very different sizes, with short last units and an empty family among them.
Plan uneven_plan() {
  Plan plan = small_plan({"published"}, {"general", "tangent", "sliver", "tie", "bits"}, 0);
  plan.questions.trials = [](const Source& source, Precision precision) -> std::uint64_t {
    const std::map<std::string, std::uint64_t> sizes = {{"general", 10 * unit_size},
                                                        {"tangent", 3 * unit_size + 1},
                                                        {"sliver", 5},
                                                        {"tie", 0},
                                                        {"bits", 7 * unit_size - 1}};
    return sizes.at(source.name()) + (precision == Precision::binary64 ? 2 * unit_size : 0);
  };
  return plan;
}

TEST(Stretches, HoldEveryUnitOfThePlanOnce) {
  const Plan plan = uneven_plan();
  for (const std::uint64_t units_each : {1u, 2u, 3u, 4u, 100u}) {
    const Stretches stretches(plan.questions, units_each);
    std::map<std::size_t, std::uint64_t> next_unit, queries;
    for (std::uint64_t number = 0; number < stretches.count(); ++number) {
      const Stretch s = stretches.at(number);
      EXPECT_EQ(s.first_unit, next_unit[s.cell]) << units_each << ", " << number;
      EXPECT_GT(s.queries, 0u);
      EXPECT_LE(s.units(), units_each);
      next_unit[s.cell] += s.units();
      queries[s.cell] += s.queries;
    }
    const CampaignResult whole = planned(plan.questions);
    for (std::size_t cell = 0; cell < whole.cells.size(); ++cell) {
      EXPECT_EQ(queries[cell], whole.cells[cell].queries) << units_each << ", " << cell;
    }
  }
}

TEST(Stretches, EachCellHasItsTurn) {
  const Stretches stretches(uneven_plan().questions, 1);
  std::map<std::size_t, int> first_numbers;
  for (std::uint64_t number = 0; number < 9; ++number) ++first_numbers[stretches.at(number).cell];
  EXPECT_EQ(first_numbers.size(), 9u) << "tie in binary32 is empty";
}

TEST(Stretches, AreFewInTheLargestPlan) {
  Plan plan = uneven_plan();
  for (const std::uint64_t trials : {std::uint64_t{1}, std::uint64_t{1'000'000'000'000}, std::uint64_t{1} << 59}) {
    plan.questions.trials = [=](const Source&, Precision) { return trials; };
    const Stretches stretches(plan.questions, Stretches::default_units_each(plan.questions));
    EXPECT_LE(stretches.count(), Stretches::most);
    EXPECT_EQ(stretches.queries(), 10 * trials);
    const Stretch last = stretches.at(stretches.count() - 1);
    EXPECT_EQ(last.first_unit * unit_size + last.queries, trials);
  }
  EXPECT_THROW(Stretches(plan.questions, 1), Error);
}

TEST(Stretches, AreNamedByTheirUnits) {
  const Stretches stretches(uneven_plan().questions, 2);
  EXPECT_EQ(stretches.text(0), "general binary64, units 0 to 1");
  EXPECT_EQ(stretches.text({0, 1, 2, 9}, 20),
            "general binary64: units 0 to 3; tangent binary64: units 0 to 1; sliver binary64: units 0 to 1");
  EXPECT_EQ(stretches.text({0, 1, 2}, 1), "general binary64: units 0 to 1 and 2 more parts");
}

// The results of earlier units that a unit is given save work and change nothing.
TEST(Stretch, IsItsUnitsMerged) {
  Plan plan = small_plan({"published", "nonstrict"}, {"sliver"}, 2 * unit_size + 100);
  plan.questions.precisions = {Precision::binary32};
  const Stretches stretches(plan.questions, 3);
  ASSERT_EQ(stretches.count(), 1u);
  const Entry entry = run_stretch(plan, stretches, 0);
  for (std::size_t k = 0; k < plan.answerers.kernels.size(); ++k) {
    Tally merged = empty_tally(sphere_triangle_predicate());
    for (std::uint64_t unit = 3; unit-- > 0;) {
      merged.merge(run_unit(plan, *plan.questions.sources[0], Precision::binary32, unit, unit == 2 ? 100 : unit_size)
                       .tallies[k]);
    }
    EXPECT_EQ(encode(merged), entry.tallies[k]) << plan.answerers.kernels[k]->id;
  }
  const Entry again = decode_entry(encode(entry));
  EXPECT_EQ(again.tallies, entry.tallies);
  EXPECT_EQ(again.costs, entry.costs);
}

TEST(Stretch, OfAnotherPredicateHasTheCountsOfItsComparisons) {
  Plan plan = small_plan({"moving-sphere/twenty", "moving-sphere/rounded"}, {"moving-sphere/approach"}, 200);
  plan.questions.precisions = {Precision::binary32};
  const Entry entry = run_stretch(plan, Stretches(plan.questions, 1), 0);
  const UnitResult unit = run_unit(plan, *plan.questions.sources[0], Precision::binary32, 0, 200);
  for (std::size_t k = 0; k < plan.answerers.kernels.size(); ++k) {
    const Tally tally = decode_tally(entry.tallies[k], plan.questions.predicate());
    EXPECT_EQ(tally.comparisons.size(), 61u) << plan.answerers.kernels[k]->id;
    EXPECT_EQ(encode(tally), encode(unit.tallies[k])) << plan.answerers.kernels[k]->id;
    EXPECT_EQ(tally.trials, 200u) << plan.answerers.kernels[k]->id;
  }
}

// Planted: every 1000th answer is inverted, on the scalar target only.
template <class Real>
void wrong_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  scalar_implementation<Formulae::published, Strictness::strict, Real>().verdicts(batch, out);
  for (std::size_t i = 0; i < batch.size; i += 1000) {
    out[i] = out[i] == Verdict::contact ? Verdict::separated : Verdict::contact;
  }
}

TEST(Stretch, OfAnotherPredicateHasAsManyTalliesAsThatHasClauses) {
  for (const auto& [kernel, family] : {std::pair("moving-sphere/twenty", "moving-sphere/lattice"),
                                       std::pair("box-box/projected", "box-box/lattice")}) {
    Plan plan = small_plan({kernel}, {family}, 40);
    const Stretches stretches(plan.questions, 1);
    for (std::uint64_t number = 0; number < stretches.count(); ++number) {
      const Stretch stretch = stretches.at(number);
      const UnitResult unit =
          run_unit(plan, *plan.questions.sources[stretch.source], stretch.precision, 0, stretch.queries);
      EXPECT_EQ(run_stretch(plan, stretches, number).tallies.front(), encode(unit.tallies.front())) << kernel;
    }
    GatheredStretches gathered(plan.questions, plan.answerers.kernels.size(), stretches);
    gathered.add(run_stretch(plan, stretches, 0));
  }
}

TEST(Recheck, AFaultOfOneTargetIsToldWithUnitAndKernel) {
  const Kernel& right = find_kernel("closest-point");
  Kernel kernel = right;
  kernel.id = "planted";
  kernel.formulae.clear();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  kernel.binary32 = [](std::string_view target) {
    if (target == scalar_target) return Implementation<float>{wrong_verdicts<float>};
    return Implementation<float>{scalar_implementation<Formulae::published, Strictness::strict, float>().verdicts};
  };
  Plan plan = small_plan({"published"}, {"tangent"}, 3000 / TRIAL_DIVISOR);
  plan.answerers.kernels.push_back(&kernel);
  plan.questions.precisions = {Precision::binary32};
  ASSERT_NE(plan.running.target, scalar_target);
  Plan other = plan;
  other.running.target = scalar_target;
  const Stretches stretches(plan.questions, 1);
  Recheck recheck(plan.answerers.kernels, stretches, {0});
  recheck.add_first(run_stretch(plan, stretches, 0));
  recheck.add_again(run_stretch(plan, stretches, 0));
  EXPECT_TRUE(recheck.differences().empty());
  recheck.add_again(run_stretch(other, stretches, 0));
  ASSERT_EQ(recheck.differences().size(), 1u) << "and not of the kernel published";
  EXPECT_EQ(recheck.differences()[0].find("kernel planted on tangent binary32, unit 0: "), 0u)
      << recheck.differences()[0];
}

TEST(Recheck, ASampleIsPartOfTheWholeAndNeverEmpty) {
  const std::vector<std::uint64_t> numbers = {2, 3, 5, 7, 11, 13, 17, 19};
  EXPECT_EQ(sample_of(numbers, 1, 1), numbers);
  EXPECT_EQ(sample_of(numbers, 1e-9, 1).size(), 1u);
  EXPECT_EQ(sample_of(numbers, 0.5, 1).size(), 4u);
  EXPECT_TRUE(sample_of({}, 0.5, 1).empty());
}

TEST(Gathered, KnowsWhatIsMissingAndWhatWasLost) {
  const Plan plan = small_plan({"published"}, {"general"}, 100);
  const Stretches stretches(plan.questions, 1);
  GatheredStretches gathered(plan.questions, plan.answerers.kernels.size(), stretches);
  const std::string done = encode(run_stretch(plan, stretches, 1));
  for (const std::string& content : {begun_note(0), begun_note(0), begun_note(1), done}) gathered.replay(content);
  EXPECT_EQ(gathered.missing(), std::vector<std::uint64_t>{0});
  EXPECT_EQ(gathered.lost_units(), 2u) << "begun twice, and never finished";
  EXPECT_THROW(gathered.replay(done), Error) << "twice";
  EXPECT_THROW(gathered.replay(begun_note(2)), Error) << "not of the plan";
  EXPECT_FALSE(std::move(gathered).take().complete);
}

}  // namespace

}  // namespace axiscert

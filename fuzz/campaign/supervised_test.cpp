// A supervised kernel, as foreign code is, in a campaign: its faults, unanswered queries, convention and limits.
#include "fuzz/campaign/supervised_testing.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/diagnosis/beside_runs.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

const std::atomic<bool> uncancelled = false;

Plan plan_of(std::vector<const Kernel*> kernels, const std::string& family, std::uint64_t trials) {
  Plan plan;
  plan.answerers.kernels = std::move(kernels);
  plan.questions.sources = {family_source(find_family(family))};
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [trials](const Source&, Precision) { return trials; };
  plan.running.target = std::string(scalar_target);
  return plan;
}

std::vector<Tally> tallies_of(const Plan& plan) {
  return run_campaign(plan, uncancelled, [](const Progress&) {}).cells[0].tallies;
}

const FindingTally& of(const Tally& tally, FindingKind kind) { return tally.findings[kind]; }

void no_fault(const Query<double>&, std::size_t, Verdict&, std::vector<Finding>&) {}

// Crashes on the sixth query of each batch of 1024.
void crash_on_the_sixth(const Query<double>&, std::size_t i, Verdict& verdict, std::vector<Finding>& findings) {
  if (i != 5) return;
  verdict = Verdict::unanswered;
  findings.push_back({FindingKind::crash, i, "signal 11"});
}

TEST(Supervised, FindingsHaveTheirPlaceInTheSource) {
  const Kernel kernel = supervised_kernel("plugin:crashes.so", crash_on_the_sixth);
  const Tally tally = tallies_of(plan_of({&kernel}, "general", 3000))[0];
  EXPECT_EQ(of(tally, FindingKind::crash).count, 3u);
  EXPECT_EQ(of(tally, FindingKind::crash).first, 5u);
  EXPECT_EQ(of(tally, FindingKind::crash).detail, "signal 11");
  EXPECT_EQ(of(tally, FindingKind::hang).count, 0u);
  EXPECT_EQ(tally.verdict.unanswered, 3u);
}

TEST(Supervised, TheFirstFindingIsKeptInAnyOrderOfMerging) {
  Tally early = empty_tally(sphere_triangle_predicate()), late = empty_tally(sphere_triangle_predicate());
  count_finding(early, FindingKind::hang, 7, "early");
  count_finding(late, FindingKind::hang, 70000, "late");
  count_finding(late, FindingKind::crash, 70001, "other");
  Tally forward = early, backward = late;
  forward.merge(late);
  backward.merge(early);
  for (const Tally* tally : {&forward, &backward}) {
    EXPECT_EQ(of(*tally, FindingKind::hang).count, 2u);
    EXPECT_EQ(of(*tally, FindingKind::hang).first, 7u);
    EXPECT_EQ(of(*tally, FindingKind::hang).detail, "early");
    EXPECT_EQ(of(*tally, FindingKind::crash).detail, "other");
  }
}

// A query without an answer enters no flip, error or critical radius, whatever the arrays contain.
TEST(Supervised, NoAnswerIsNoFlipAndIsNotMeasured) {
  const Kernel silent = supervised_kernel(
      "silent", [](const auto&, auto, Verdict& verdict, auto&) { verdict = Verdict::unanswered; }, "first-publication");
  const Kernel speaking = supervised_kernel("speaking", no_fault, "first-publication");
  const auto tallies = tallies_of(plan_of({&silent, &speaking}, "tangent", 2000));
  EXPECT_EQ(tallies[0].verdict.unanswered, 2000u);
  EXPECT_EQ(tallies[0].verdict.false_separation + tallies[0].verdict.false_contact, 0u);
  EXPECT_EQ(tallies[0].critical_radius.errors_ulps.size() + tallies[0].critical_radius.unanswered, 0u);
  std::uint64_t flips = 0;
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const ComparisonTally& comparison = tallies[0].comparisons[i];
    EXPECT_EQ(comparison.false_separation + comparison.missed_separation, 0u);
    EXPECT_EQ(comparison.largest_error.candidates().size(), 0u);
    flips += tallies[1].comparisons[i].false_separation + tallies[1].comparisons[i].missed_separation;
  }
  EXPECT_GT(flips, 0u) << "the same kernel, answering";
  EXPECT_GT(tallies[1].critical_radius.errors_ulps.size(), 0u);
}

TEST(Supervised, ASearchForACriticalRadiusThatGetsNoAnswerIsCounted) {
  const Kernel kernel = black_box("huge", [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (q.r > 0x1p100) verdict = Verdict::unanswered;
  });
  const Tally tally = tallies_of(plan_of({&kernel}, "general", 1024))[0];
  EXPECT_EQ(tally.verdict.unanswered, 0u);
  EXPECT_EQ(tally.critical_radius.unanswered, 1024 / critical_radius_stride);
  EXPECT_EQ(tally.critical_radius.unbounded, 0u) << "no answer is not `separated`";
}

TEST(Supervised, ASearchForACriticalRadiusThatIsNotDecidedIsCounted) {
  for (const Verdict said : {Verdict::undecided, Verdict::invalid}) {
    const Kernel kernel = black_box("huge", [said](const Query<double>& q, auto, Verdict& verdict, auto&) {
      if (q.r > 0x1p100) verdict = said;
    });
    const CriticalRadiusTally radii = tallies_of(plan_of({&kernel}, "general", 1024))[0].critical_radius;
    EXPECT_EQ(said == Verdict::undecided ? radii.undecided : radii.invalid, 1024 / critical_radius_stride);
    EXPECT_EQ(radii.errors_ulps.size() + radii.unbounded + radii.unanswered, 0u) << "it is no change of verdict";
  }
}

// The process lasts for one unit: no answer depends on which units a thread did before.
TEST(Supervised, AKernelIsBegunOnceAUnit) {
  std::atomic<int> begun = 0;
  Kernel kernel = black_box("counted", no_fault);
  kernel.binary32 = [&begun, inner = kernel.binary32](std::string_view target) {
    ++begun;
    return inner(target);
  };
  tallies_of(plan_of({&kernel}, "nonfinite", 2 * unit_size + 10));
  EXPECT_EQ(begun, 3);
}

std::string fingerprint(const Tally& t) {
  std::string text = fmt::format("{} {} {} {}", t.trials, t.verdict.unanswered, t.verdict.outside_limits->trials,
                                 t.verdict.outside_limits->deepest);
  for (const FindingTally& f : t.findings) text += fmt::format(" {} {} {}", f.count, f.first, f.detail);
  for (const auto& first : t.verdict.first_by_link)
    text += fmt::format(" {}", first.position ? std::int64_t(*first.position) : -1);
  return text;
}

TEST(Supervised, ThreadsChangeNothing) {
  Kernel kernel = supervised_kernel(
      "many", [](const Query<double>& q, std::size_t i, Verdict& verdict, std::vector<Finding>& findings) {
        if (q.r < 0.1) findings.push_back({FindingKind::environment, i, fmt::format("radius {}", q.r)});
        if (q.r > 0.9) verdict = Verdict::unanswered;
      });
  kernel.limits.greatest_coordinate = 0.5;
  Plan plan = plan_of({&kernel}, "nonfinite", 2 * unit_size);
  const std::string one = fingerprint(tallies_of(plan)[0]);
  plan.running.threads = 2;
  EXPECT_EQ(fingerprint(tallies_of(plan)[0]), one);
}

// Over small integers `minkowski` is right, and says contact when the sphere touches.
TEST(Supervised, TouchingIsHeldAgainstTheConvention) {
  Kernel contact = black_box("contact", no_fault);
  Kernel separated = black_box("separated", [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (is_valid(q) && distance_order(q) == 0) verdict = Verdict::separated;
  });
  const auto wrong = [&](TouchingPolicy convention) {
    contact.touching = separated.touching = convention;
    const auto tallies = tallies_of(plan_of({&contact, &separated}, "lattice", 2000));
    EXPECT_GT(tallies[0].truth.touching, 0u);
    std::vector<std::uint64_t> of_touching;
    for (const Tally& t : tallies) {
      EXPECT_EQ(t.verdict.false_separation + t.verdict.false_contact, t.verdict.touching_flips);
      EXPECT_EQ(t.verdict.touching_links[Link::unattributed], t.verdict.touching_flips);
      EXPECT_FALSE(t.verdict.first_by_link[Link::unattributed].position) << "touching is apart";
      of_touching.push_back(t.verdict.touching_flips == 0 ? 0 : t.verdict.touching_flips == t.truth.touching ? 1 : 2);
    }
    return of_touching;
  };
  EXPECT_EQ(wrong(TouchingPolicy::contact), (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(wrong(TouchingPolicy::separated), (std::vector<std::uint64_t>{1, 0}));
  EXPECT_EQ(wrong(TouchingPolicy::either), (std::vector<std::uint64_t>{0, 0}));
}

// `scale` takes the published test out of range; the same kernel with limits that exclude those queries is right on the
// rest.
TEST(Supervised, OutsideItsLimitsNothingElseIsCounted) {
  const Kernel unlimited = supervised_kernel("unlimited", no_fault);
  Kernel limited = unlimited;
  limited.limits = {.least_coordinate = 0x1p-15, .greatest_coordinate = 0x1p15};
  const auto tallies = tallies_of(plan_of({&unlimited, &limited}, "scale", 4000));
  const VerdictTally &all = tallies[0].verdict, &inside = tallies[1].verdict;
  const OutsideTally& outside = *inside.outside_limits;
  EXPECT_EQ(all.outside_limits->trials, 0u);
  EXPECT_GT(outside.trials, 0u);
  EXPECT_LT(outside.trials, tallies[1].trials);
  EXPECT_EQ(tallies[1].trials, tallies[0].trials);
  EXPECT_EQ(tallies[1].truth.separated, tallies[0].truth.separated) << "the truth is counted of all";
  EXPECT_GT(outside.false_contact, 0u);
  EXPECT_EQ(inside.false_contact + outside.false_contact, all.false_contact);
  EXPECT_EQ(inside.false_separation + outside.false_separation, all.false_separation);
  EXPECT_EQ(std::max({outside.deepest, inside.deepest_false_contact.best(), inside.deepest_false_separation.best()}),
            std::max(all.deepest_false_contact.best(), all.deepest_false_separation.best()));
  std::uint64_t range_events = 0, flips = 0, all_flips = 0;
  for (std::size_t i = 0; i < comparison_count; ++i) {
    range_events += *tallies[1].comparisons[i].range_events;
    flips += tallies[1].comparisons[i].false_separation + tallies[1].comparisons[i].missed_separation;
    all_flips += tallies[0].comparisons[i].false_separation + tallies[0].comparisons[i].missed_separation;
  }
  EXPECT_EQ(range_events, 0u);
  EXPECT_LT(flips, all_flips);
  EXPECT_LT(tallies[1].critical_radius.errors_ulps.size(), tallies[0].critical_radius.errors_ulps.size());
}

TEST(Supervised, InvalidQueriesAreNotOutside) {
  Kernel kernel =
      black_box("limited", [](const auto&, auto, Verdict& verdict, auto&) { verdict = Verdict::unanswered; });
  kernel.limits.greatest_coordinate = 1;
  const Tally tally = tallies_of(plan_of({&kernel}, "nonfinite", 500))[0];
  EXPECT_EQ(tally.truth.invalid + tally.verdict.outside_limits->trials + tally.verdict.unanswered, 500u);
  EXPECT_EQ(tally.verdict.outside_limits->unanswered, tally.verdict.outside_limits->trials);
  EXPECT_GT(tally.truth.invalid, 0u);
}

// A slip in the formulae is found by the first query that shows it.
TEST(Supervised, TheFirstWrongVerdictOfALink) {
  const Kernel kernel = supervised_kernel("slip", no_fault, "first-publication");
  Plan plan = plan_of({&kernel}, "general", 5000);
  const Tally all = tallies_of(plan)[0];
  const auto first = all.verdict.first_by_link[Link::specification].position;
  ASSERT_TRUE(first);
  plan.questions.trials = [&](const Source&, Precision) { return *first; };
  EXPECT_FALSE(tallies_of(plan)[0].verdict.first_by_link[Link::specification].position);
  plan.questions.trials = [&](const Source&, Precision) { return *first + 1; };
  EXPECT_EQ(tallies_of(plan)[0].verdict.first_by_link[Link::specification].position, first);
}

// Says contact for separated and separated for contact, on the queries of its share: 1 is all.
Plant exchanging(int of_twenty) {
  return [of_twenty](const Query<double>& q, std::size_t i, Verdict& verdict, std::vector<Finding>&) {
    if (static_cast<int>(i % 20) >= of_twenty || q.r < 0) return;
    verdict = verdict == Verdict::contact ? Verdict::separated : Verdict::contact;
  };
}

TEST(Supervised, ExchangedVerdictsAreOneFindingOfAUnit) {
  const Kernel exchanged = black_box("exchanged", exchanging(20)), nearly = black_box("nearly", exchanging(18)),
               right = black_box("right", no_fault);
  const auto tallies = tallies_of(plan_of({&exchanged, &nearly, &right}, "general", 3000));
  EXPECT_EQ(of(tallies[0], FindingKind::exchanged).count, 1u);
  EXPECT_EQ(of(tallies[0], FindingKind::exchanged).first, 0u);
  EXPECT_NE(of(tallies[0], FindingKind::exchanged).detail.find("its verdicts are exchanged: it says contact (0)"),
            std::string::npos);
  EXPECT_EQ(of(tallies[1], FindingKind::exchanged).count, 0u);
  EXPECT_EQ(of(tallies[2], FindingKind::exchanged).count, 0u);
}

TEST(Supervised, ExchangedVerdictsAreSeenAtFirst) {
  EXPECT_NE(first_look(black_box("exchanged", exchanging(20))).find("its verdicts are exchanged"), std::string::npos);
  EXPECT_EQ(first_look(black_box("nearly", exchanging(18))), "");
  EXPECT_EQ(first_look(black_box("right", no_fault)), "");
}

TEST(Supervised, WhatHasNoAnswerIsSeenAtFirst) {
  EXPECT_EQ(first_look(supervised_kernel("crashes", crash_on_the_sixth)),
            "it leaves 1 of 251 queries in binary32 without an answer: crash: signal 11");
}

TEST(Supervised, AKernelThatCouldNotBeLoadedIsNotAsked) {
  const Kernel broken = unloadable_kernel("plugin:broken.so", "no such symbol");
  const auto tallies = tallies_of(plan_of({&broken, &find_kernel("published")}, "general", 100));
  EXPECT_EQ(tallies[0].trials, 0u);
  EXPECT_EQ(tallies[1].trials, 100u);
}

}  // namespace
}  // namespace axiscert

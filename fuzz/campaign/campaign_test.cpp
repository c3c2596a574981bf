// The campaign: the same tallies on any number of threads and any target; planted kernels are detected by their link.
#include "fuzz/campaign/campaign.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <immintrin.h>

#include "kernel/sphere_triangle/forms/contracted.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

const std::atomic<bool> never = false;

Plan plan_of(std::vector<const Kernel*> kernels, std::vector<std::string> names, std::uint64_t trials) {
  Plan plan;
  plan.answerers.kernels = std::move(kernels);
  for (const std::string& name : names) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.questions.trials = [trials](const Source&, Precision) { return trials; };
  plan.running.target = resolve_target("auto");
  return plan;
}

CampaignResult run(const Plan& plan) {
  return run_campaign(plan, never, [](const Progress&) {});
}

LinkCounts links(const CampaignResult& result, std::size_t kernel) {
  LinkCounts sum{};
  for (const CellResult& cell : result.cells) {
    for (const Link link : enumerators<Link>) sum[link] += cell.tallies[kernel].verdict.links[link];
  }
  return sum;
}

// Planted: every pair of neighbouring lanes exchanged.
template <class Real>
void swapped_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  scalar_implementation<Formulae::published, Strictness::strict, Real>().verdicts(batch, out);
  for (std::size_t i = 0; i + 1 < batch.size; i += 2) std::swap(out[i], out[i + 1]);
}
template <class Real>
void swapped_explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  scalar_implementation<Formulae::published, Strictness::strict, Real>().explain(batch, out);
  for (std::size_t i = 0; i + 1 < batch.size; i += 2) {
    std::swap(out.bits[i], out.bits[i + 1]);
    for (std::size_t k = 0; k < comparison_count; ++k) {
      std::swap(out.lhs[k][i], out.lhs[k][i + 1]);
      std::swap(out.rhs[k][i], out.rhs[k][i + 1]);
    }
  }
}

// Planted: subnormal results and operands become zero, as with the flags that engines set.
class FlushGuard {
 public:
  FlushGuard() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~FlushGuard() { _mm_setcsr(before_); }

 private:
  unsigned before_;
};
template <class Real>
void flushed_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  const FlushGuard mode;
  scalar_implementation<Formulae::published, Strictness::strict, Real>().verdicts(batch, out);
}
template <class Real>
void flushed_explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  const FlushGuard mode;
  scalar_implementation<Formulae::published, Strictness::strict, Real>().explain(batch, out);
}

// Planted: x y + z fused wherever a compiler could.
template <class Real>
void contracted_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  Answers<Real> answers;
  answers.resize(batch.size, comparison_count);
  contracted_explain(batch, answers);
  for (std::size_t i = 0; i < batch.size; ++i) out[i] = verdict_of(axes_of(answers.bits[i]));
}

Kernel planted(const char* id, Implementation<float> binary32, Implementation<double> binary64) {
  Kernel kernel;
  kernel.id = id;
  kernel.summary = "planted";
  kernel.predicate = &sphere_triangle_predicate();
  kernel.formulae = "published";
  kernel.binary32 = [=](std::string_view) { return binary32; };
  kernel.binary64 = [=](std::string_view) { return binary64; };
  return kernel;
}

#define AXISCERT_PLANT(name)                                                                   \
  const Kernel name##_kernel = planted(#name, {name##_verdicts<float>, name##_explain<float>}, \
                                       {name##_verdicts<double>, name##_explain<double>})
AXISCERT_PLANT(swapped);
AXISCERT_PLANT(flushed);
AXISCERT_PLANT(contracted);

void expect_implementation_links(const Kernel& planted, const std::string& family) {
  const auto result = run(plan_of({&planted, &find_kernel("published")}, {family}, 20000 / TRIAL_DIVISOR));
  EXPECT_GT(links(result, 0)[Link::implementation], 0u) << planted.id << " on " << family;
  EXPECT_EQ(links(result, 1)[Link::implementation], 0u) << "the built-in kernel on " << family;
}

TEST(PlantedKernel, ASwappedLaneIsAnImplementationFault) { expect_implementation_links(swapped_kernel, "general"); }
TEST(PlantedKernel, AContractedKernelIsAnImplementationFault) {
  expect_implementation_links(contracted_kernel, "repeated");
}
TEST(PlantedKernel, AFlushedKernelIsAnImplementationFault) { expect_implementation_links(flushed_kernel, "scale"); }

// The filters' decisions are compared with exact arithmetic on a sample: a faulty filter is detected.
void expect_caught(FilterFault fault, std::vector<std::string> families, Precision precision) {
  Plan plan = plan_of({&find_kernel("published")}, std::move(families), 40000);
  plan.questions.precisions = {precision};
  plan.judging.planted = fault;
  EXPECT_THROW(run(plan), OracleDisagreement) << name(precision);
}
TEST(PlantedFilter, ABoundTooSmallIsCaught) {
  expect_caught(FilterFault::small_bound, {"collinear", "sliver", "needle"}, Precision::binary32);
}
TEST(PlantedFilter, ASignExchangedIsCaught) {
  expect_caught(FilterFault::swapped_sign, {"general"}, Precision::binary32);
  expect_caught(FilterFault::swapped_sign, {"general"}, Precision::binary64);
}
TEST(PlantedFilter, UnderflowLeftOutIsCaught) {
  expect_caught(FilterFault::no_underflow_guard, {"scale", "subnormal", "bits"}, Precision::binary64);
}
TEST(PlantedFilter, ARoundingModeLeftChangedIsCaught) {
  Plan plan = plan_of({&find_kernel("published")}, {"general"}, 1000);
  plan.judging.planted = FilterFault::rounding_mode;
  EXPECT_THROW(run(plan), HarnessFault);
}

std::string fingerprint(const CampaignResult& result) {
  std::string text;
  const auto put = [&](auto... values) { ((text += fmt::format("{} ", values)), ...); };
  for (const CellResult& cell : result.cells) {
    put(cell.source, static_cast<int>(cell.precision), cell.units_done);
    for (const Tally& t : cell.tallies) {
      put(t.trials, t.truth.separated, t.truth.touching, t.verdict.false_separation, t.verdict.false_contact);
      for (const auto& c : t.verdict.deepest_false_contact.candidates()) put(c.rank, c.position);
      for (const auto& [name, c] : t.comparisons) {
        put(c.false_separation, c.missed_separation, c.decisive, c.ties, *c.range_events);
        for (const auto& leader : c.largest_error.candidates()) put(leader.rank.text(), leader.position);
      }
    }
  }
  return text;
}

// A kernel that adds a constant to each side, as production code does, has errors of any size and infinite sides: the
// filter must not pass over any of these wrongly.
template <class Real>
void shifted_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  scalar_implementation<Formulae::published, Strictness::strict, Real>().verdicts(batch, out);
}
template <class Real>
void shifted_explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  scalar_implementation<Formulae::published, Strictness::strict, Real>().explain(batch, out);
  for (auto& column : out.lhs) {
    for (Real& lhs : column) lhs += sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12);
  }
}
AXISCERT_PLANT(shifted);
TEST(Campaign, ErrorsOfAnySizeAreThoseOfExactArithmetic) {
  Kernel kernel = shifted_kernel;
  kernel.is_reference = false;
  Plan plan = plan_of({&kernel}, {"scale", "subnormal", "sliver"}, 3000 / TRIAL_DIVISOR);
  const std::string filtered = fingerprint(run(plan));
  plan.judging.exact_only = true;
  EXPECT_EQ(filtered, fingerprint(run(plan)));
}

TEST(Campaign, ThreadsAndTargetsChangeNothing) {
  Plan plan = plan_of({&find_kernel("published")}, {"general", "tangent"}, unit_size + 1000);  // a unit and a short one
  plan.questions.precisions = {Precision::binary32};
  const std::string one = fingerprint(run(plan));
  plan.running.threads = 2;
  EXPECT_EQ(fingerprint(run(plan)), one) << "2 threads";
  plan.questions.sources.push_back(family_source(find_family("scale")));
  plan.questions.trials = [](const Source&, Precision) { return 3000 / TRIAL_DIVISOR; };
  const std::string reference = fingerprint(run(plan));
  for (const std::string& target : available_targets()) {
    plan.running.target = target;
    EXPECT_EQ(fingerprint(run(plan)), reference) << target;
  }
}

TEST(Campaign, StopsWhenInterruptedAndSaysSo) {
  std::atomic<bool> stop = false;
  Plan plan = plan_of({&find_kernel("published")}, {"general"}, 5 * unit_size);
  plan.questions.precisions = {Precision::binary32};
  const auto result = run_campaign(plan, stop, [&](const Progress& p) { stop = p.units_done >= 2; });
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.cells[0].units_done, 2u);
  EXPECT_EQ(result.cells[0].tallies[0].trials, 2 * unit_size);
}

// The number of queries that a tally keeps by position.
std::size_t candidates_in(const Tally& tally) {
  const VerdictTally& v = tally.verdict;
  std::size_t sum = v.deepest_false_separation.candidates().size() + v.deepest_false_contact.candidates().size();
  for (const auto& leaders : v.deepest_by_link) sum += leaders.candidates().size();
  for (const auto& [name, c] : tally.comparisons) {
    sum += c.largest_error.candidates().size();
    sum += c.false_witness.candidates().size() + c.missed_witness.candidates().size();
  }
  return sum;
}

// Units before and after the last query whose critical radius is found.
TEST(Campaign, ATallyDoesNotGrowWithTheTrials) {
  static_assert(critical_radius_queries % unit_size == 0);
  constexpr std::uint64_t beyond = critical_radius_queries / unit_size, size = 4 * critical_radius_stride;
  constexpr std::size_t most_candidates = 3 + 3 + link_count + 3 * comparison_count;
  const Plan plan = plan_of({&find_kernel("first-publication")}, {"tangent"}, size);
  const auto unit = [&](std::uint64_t number) {
    return run_unit(plan, *plan.questions.sources[0], Precision::binary32, number, size).tallies[0];
  };
  Tally all = unit(beyond - 1);
  EXPECT_EQ(all.critical_radius.errors_ulps.size() + all.critical_radius.unbounded, size / critical_radius_stride);
  const std::size_t radii = all.critical_radius.errors_ulps.size();
  constexpr std::uint64_t units = 20;
  for (std::uint64_t i = 0; i < units; ++i) all.merge(unit(beyond + i));
  EXPECT_EQ(all.trials, (1 + units) * size);
  EXPECT_EQ(all.critical_radius.errors_ulps.size(), radii);
  EXPECT_GT(all.verdict.false_contact + all.verdict.false_separation, most_candidates) << "enough to keep";
  EXPECT_LE(candidates_in(all), most_candidates);
}

TEST(Leaders, KeepTheGreatestThenTheEarliestInAnyOrder) {
  const std::vector<Candidate<double>> all = {{1, 9}, {3, 5}, {3, 2}, {2, 1}, {3, 7}};
  Leaders<double> forward(3), backward(3), halves(3), half(3);
  for (const auto& c : all) forward.offer(c);
  for (auto c = all.rbegin(); c != all.rend(); ++c) backward.offer(*c);
  for (std::size_t i = 0; i < all.size(); ++i) (i % 2 ? half : halves).offer(all[i]);
  halves.merge(half);
  for (const Leaders<double>* leaders : {&forward, &backward, &halves}) {
    ASSERT_EQ(leaders->candidates().size(), 3u);
    EXPECT_EQ(leaders->candidates()[0].position, 2u);
    EXPECT_EQ(leaders->candidates()[1].position, 5u);
    EXPECT_EQ(leaders->candidates()[2].position, 7u);
  }
}

}  // namespace
}  // namespace axiscert

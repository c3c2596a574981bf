// The mutants have the faults that they name, and the harness detects them, except those argued to be equivalent.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "exact/numbers/surd.h"
#include "fuzz/instruments/mutation.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"
#include "fuzz/record/tally.h"
#include "kernel/base/error.h"
#include "kernel/mutants/forms.h"
#include "kernel/mutants/mutant.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t mutants_seed = 7;
const std::atomic<bool> not_interrupted = false;

MutationPlan mutation_plan_of(std::string_view base, std::vector<const mutants::Mutant*> mutants,
                              std::uint64_t trials) {
  MutationPlan plan{
      std::move(mutants), std::string(base), {}, {Precision::binary32, Precision::binary64}, trials, mutants_seed, 2};
  for (const Family* family : families_of(*find_kernel(base).predicate, 0)) plan.families.push_back(family);
  return plan;
}
MutationResult run(const MutationPlan& plan) {
  return run_mutation(plan, not_interrupted, [](const Progress&) {});
}
std::vector<const mutants::Mutant*> every(std::string_view base, std::size_t stride) {
  std::vector<const mutants::Mutant*> sample;
  const auto all = mutants::mutants_of(base);
  for (std::size_t i = stride / 2; i < all.size(); i += stride) sample.push_back(&all[i]);
  return sample;
}

template <class Real>
void expect_base_bits(std::string_view base) {
  mutants::Mutant none;
  none.id = base;
  const Kernel& kernel = find_kernel(base);
  const Implementation<Real> right = kernel.on<Real>(scalar_target);
  for (const Family* family : families_of(*kernel.predicate, kernel.entry)) {
    // Not a multiple of the number of lanes.
    QueryBatch<Real> batch(100, kernel.predicate->entries.front().columns.size());
    batch.resize(100);
    family->fill(mutants_seed, 0, batch.mutable_columns());
    std::array<ComparisonBits, 100> bits;
    mutants::mutant_bits(none, batch.columns(), bits.data());
    Answers<Real> expected;
    expected.resize(batch.size(), kernel.predicate->comparisons.size());
    right.explain(batch.columns(), expected);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_EQ(bits[i], expected.bits[i]) << base << ' ' << family->name << ' ' << i << " seed " << mutants_seed;
    }
  }
}

TEST(Mutants, WithoutAFaultTheyAreTheirBaseBitForBit) {
  for (const std::string_view base : mutants::bases) {
    expect_base_bits<float>(base);
    expect_base_bits<double>(base);
  }
}

TEST(Mutants, NamesAreStableAndEachIsFound) {
  std::set<std::string> names;
  for (const std::string_view base : mutants::bases) {
    const auto all = mutants::mutants_of(base);
    EXPECT_GE(all.size(), 100u);
    for (const mutants::Mutant& m : all) {
      EXPECT_TRUE(names.insert(m.id).second) << m.id;
      EXPECT_EQ(&mutants::find_mutant(m.id), &m);
      EXPECT_EQ(find_kernel(m.id).id, m.id);
    }
  }
  // Names that a reader has seen in a report keep their meaning.
  EXPECT_EQ(mutants::find_mutant("nonstrict~swap:21").where, "21: #17 - #20");
  EXPECT_EQ(mutants::find_mutant("nonstrict~sign:28").where, "28: #23 + #27");
  EXPECT_EQ(mutants::find_mutant("reduced-nonstrict~drop:edge_ab").where, "edge_ab");
  EXPECT_EQ(mutants::find_mutant("moving-sphere/twenty-nonstrict~drop:sweep.edge_ab").where, "sweep.edge_ab");
  EXPECT_THROW(mutants::find_mutant("nonstrict~swap:1000"), Error);
  EXPECT_THROW(mutants::find_mutant("published~swap:17"), Error);
  EXPECT_THROW(find_kernel("nonstrict~nosuch:1"), Error);
}

// Every 29th mutant of each base of sphere-triangle: all are caught; those that round as the base does are also caught
// by their claim of formulae alone.
TEST(Mutation, ASampleIsCaughtByBitsAndFaultsOfLogicByFormulaeAlone) {
  for (const std::string_view base : {mutants::bases[0], mutants::bases[1]}) {
    const MutationResult result = run(mutation_plan_of(base, every(base, 29), 4000));
    std::size_t soon = 0;
    for (const MutantResult& r : result.mutants) {
      if (equivalent_mutants().contains(r.mutant->id)) continue;
      EXPECT_TRUE(r.by_bits) << r.mutant->id << ' ' << name(r.precision) << " seed " << mutants_seed;
      EXPECT_FALSE(r.same_bits) << r.mutant->id;
      soon += r.by_bits && r.by_bits->queries <= 10'000;
      const auto& fault = r.mutant->fault;
      const bool only_rounds = fault == "fma" || fault == "float" || fault == "flush" || fault == "ftz" ||
                               fault == "epsilon" || fault == "slack" || fault == "small-area" || fault == "strictness";
      const bool rounds_otherwise = fault == "fma" || fault == "float";
      EXPECT_TRUE(only_rounds || r.by_formulae) << r.mutant->id << ' ' << name(r.precision) << " seed " << mutants_seed;
      EXPECT_FALSE(rounds_otherwise && r.by_formulae) << r.mutant->id << ' ' << name(r.precision);
    }
    EXPECT_GT(2 * soon, result.mutants.size());
  }
}

TEST(Mutation, DoesNotDependOnThreads) {
  MutationPlan plan = mutation_plan_of("nonstrict", every("nonstrict", 97), 1000);
  const MutationResult two = run(plan);
  plan.threads = 1;
  const MutationResult one = run(plan);
  EXPECT_EQ(one.judged, (std::set{Precision::binary32, Precision::binary64}));
  ASSERT_EQ(one.mutants.size(), two.mutants.size());
  for (std::size_t i = 0; i < one.mutants.size(); ++i) {
    const auto &a = one.mutants[i].by_bits, &b = two.mutants[i].by_bits;
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(std::tuple(a->family, a->position, a->queries, a->depth),
              std::tuple(b->family, b->position, b->queries, b->depth));
  }
}

// A campaign over the same queries finds the fault at the same position: a catch is a query that `run --require logic`
// reports.
TEST(Mutation, ACampaignCatchesItAtTheSameQuery) {
  for (const char* id : {"nonstrict~swap:21", "nonstrict~fma:41", "nonstrict~lane:3", "nonstrict~tail:8",
                         "reduced-nonstrict~strictness:plane.radius"}) {
    const mutants::Mutant& mutant = mutants::find_mutant(id);
    for (const char* family : {"tangent", "lattice"}) {
      MutationPlan plan = mutation_plan_of(id, {&mutant}, 5000);
      plan.base = std::string(id).substr(0, std::string(id).find('~'));
      plan.families = {&find_family(family)};
      plan.precisions = {Precision::binary32};
      const std::optional<Catch> found = run(plan).mutants.front().by_bits;
      Plan campaign;
      campaign.questions.seed = mutants_seed;
      campaign.answerers.kernels = {&find_kernel(id)};
      campaign.questions.sources = {family_source(find_family(family))};
      campaign.questions.precisions = plan.precisions;
      campaign.questions.trials = [](const Source&, Precision) { return 5000; };
      campaign.running.target = std::string(scalar_target);
      const CampaignResult judged = run_campaign(campaign, not_interrupted, [](const Progress&) {});
      const auto& first = judged.cells[0].tallies[0].verdict.first_by_link[Link::implementation].position;
      ASSERT_EQ(found.has_value(), first.has_value()) << id << ' ' << family;
      EXPECT_EQ(found ? found->position : 0, first.value_or(0)) << id << ' ' << family;
    }
  }
}

TEST(Mutation, KernelsThatAreRightAreNeverFlagged) {
  const MutationPlan plan = mutation_plan_of("nonstrict", {}, 0);
  const std::vector<Control> controls = run_controls(plan, 40, not_interrupted);
  EXPECT_GE(controls.size(), 60u);
  for (const Control& c : controls)
    EXPECT_EQ(c.flagged, 0u) << c.id << ' ' << name(c.precision) << " seed " << mutants_seed;
}

// A ring in which a contraction changes nothing.
struct ExactNumber {
  BinaryNumber value;
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) { return {a.value + b.value}; }
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return {a.value - b.value}; }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) { return {a.value * b.value}; }
  friend ExactNumber operator-(const ExactNumber& a) { return {-a.value}; }
  friend ExactNumber fused(const ExactNumber& a, const ExactNumber& b, const ExactNumber& c) { return a * b + c; }
  friend ExactNumber in_binary32(const ExactNumber& a) { return a; }
  static ExactNumber constant(double x) { return {BinaryNumber(x)}; }
};

// The sides of all comparisons with the fault at a site.
template <class Form>
std::vector<BinaryNumber> exact_sides(const std::vector<double>& v, const mutants::OperationSite& operation) {
  using N = mutants::MutatedNumber<ExactNumber>;
  std::array<N, Form::columns> in;
  for (std::size_t k = 0; k < in.size(); ++k) in[k] = N({BinaryNumber(v[k])}, mutants::input_key(k));
  N::plant(operation, in);
  std::vector<BinaryNumber> sides;
  Form::comparisons(in, N(0.0), [&](std::size_t, const N& lhs, const N& rhs) {
    sides.push_back(lhs.value.value);
    sides.push_back(rhs.value.value);
  });
  return sides;
}

// Two different polynomials of degree 12 or less agree at a random point of integers below 2^40 in magnitude with a
// probability of at most 12 / 2^40 (Schwartz and Zippel); so the sides of an equivalent mutant are those of its base.
TEST(EquivalentMutants, HaveTheSidesOfTheirBaseInExactArithmetic) {
  const auto differs_in = [&]<class Form>(const mutants::Mutant& m, Form) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      Stream random(StreamName(mutants_seed, name_hash("equivalent"), 1, Precision::binary64), i);
      std::vector<double> v(Form::columns);
      for (double& x : v)
        x = static_cast<double>(static_cast<std::int64_t>(random.bits() >> 23) - (std::int64_t{1} << 40));
      if (exact_sides<Form>(v, m.operation) != exact_sides<Form>(v, {})) return true;
    }
    return false;
  };
  const auto differs = [&](const mutants::Mutant& m) {
    return mutants::with_form(mutants::base_of(m), [&](auto form) { return differs_in(m, form); });
  };
  for (const auto& [name, reason] : equivalent_mutants()) EXPECT_FALSE(differs(mutants::find_mutant(name))) << name;
  // The check detects a fault that is not equivalent.
  EXPECT_TRUE(differs(mutants::find_mutant("nonstrict~sign:27")));
  EXPECT_TRUE(differs(mutants::find_mutant("moving-sphere/twenty-nonstrict~operator:27")));
}

TEST(EquivalentMutants, AreNeverCaughtAndAnswerTheSameBits) {
  for (const std::string_view base : mutants::bases) {
    std::vector<const mutants::Mutant*> listed;
    for (const auto& [name, reason] : equivalent_mutants()) {
      if (name.starts_with(std::string(base) + "~")) listed.push_back(&mutants::find_mutant(name));
    }
    if (listed.empty()) continue;
    for (const MutantResult& r : run(mutation_plan_of(base, listed, 3000)).mutants) {
      EXPECT_FALSE(r.by_bits) << r.mutant->id << " seed " << mutants_seed;
      EXPECT_TRUE(r.same_bits) << r.mutant->id << " seed " << mutants_seed;
    }
  }
}

TEST(EquivalentMutants, AFileThatIsWrongIsRefusedWithItsLine) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_equivalent_mutants(text, "list.txt");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("# a comment\n\nnonstrict~sign:28: squared\n"), "");
  EXPECT_NE(message("nonstrict~sign:28\n").find("list.txt:1: no reason"), std::string::npos);
  EXPECT_NE(message("#\nnonstrict~nosuch:28: why\n").find("list.txt:2: unknown mutant"), std::string::npos);
  const std::string twice = "nonstrict~sign:28: why\n";
  EXPECT_NE(message(twice + twice).find("appears twice"), std::string::npos);
}

}  // namespace

// Mutants with a fault of a value have the fault that they name, in every magnitude.

namespace {

constexpr std::uint64_t value_seed = 7;

// The bits of a mutant on the first queries of every family.
template <class Real>
std::vector<ComparisonBits> bits_everywhere(const mutants::Mutant& mutant, bool takes_radius = false, Real least = 0) {
  std::vector<ComparisonBits> all;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    QueryBatch<Real> batch(100, coordinate_count);
    batch.resize(100);
    family->fill(value_seed, 0, batch.mutable_columns());
    if (takes_radius) {
      Real* radius = batch.mutable_columns().column[coordinate_count - 1];
      for (std::size_t i = 0; i < batch.size(); ++i) radius[i] = radius[i] < least ? least : radius[i];
    }
    std::array<ComparisonBits, 100> bits;
    mutants::mutant_bits(mutant, batch.columns(), bits.data());
    all.insert(all.end(), bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(batch.size()));
  }
  return all;
}

TEST(ValueMutants, HaveTheFaultThatTheyName) {
  mutants::Mutant none;
  // The queries here are of the static predicate; others ask the mutants of motions.
  for (const std::string_view base : {"nonstrict", "reduced-nonstrict"}) {
    none.id = base;
    const std::string of(std::string(base) + "~");
    const auto bits = [&](const std::string& id) { return bits_everywhere<float>(mutants::find_mutant(of + id)); };
    // A radius below 0.25 is 0.25.
    EXPECT_EQ(bits("clamp:r:0.25"), bits_everywhere<float>(none, true, 0.25f)) << base << " seed " << value_seed;
    EXPECT_NE(bits("clamp:r:0.25"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
    // The early answer on a small area is there in two forms.
    EXPECT_EQ(bits("early-contact:v:1e-10"), bits("small-area:contact")) << base << " seed " << value_seed;
    EXPECT_EQ(bits("early-separated:v:1e-10"), bits("small-area:separated")) << base << " seed " << value_seed;
    // One side plus a millionth is the fault of a comparison that needs less.
    EXPECT_EQ(bits("plus:edge_ab.radius:1e-06"), bits("slack:edge_ab.radius")) << base << " seed " << value_seed;
    // Half an ulp of itself is lost, two are not.
    EXPECT_EQ(bits("plus-relative:rr:1e-08"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
    EXPECT_NE(bits("plus-relative:rr:1e-06"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
  }
}

TEST(ValueMutants, AreEachThereInEveryMagnitude) {
  const auto all = mutants::value_mutants_of("nonstrict", mutants::default_magnitudes);
  std::set<std::string> ids;
  for (const mutants::Mutant* m : all) {
    EXPECT_TRUE(ids.insert(m->id).second) << m->id;
    EXPECT_EQ(&mutants::find_mutant(m->id), m) << m->id;
    EXPECT_NE(bits_everywhere<double>(*m).size(), 0u);
  }
  EXPECT_EQ(all.size(), 7u * (7 * 12 + 6));
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:r:0"), Error);
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:r:1e-2x"), Error);
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:verdict:0.1"), Error);
  EXPECT_THROW(mutants::value_mutants_of("nonstrict", std::array{-1.0}), Error);
}

}  // namespace

// Mutants of the twenty axes: named by what they change, and caught by the families of moving-sphere.

namespace {

constexpr std::uint64_t motion_mutants_seed = 7;
constexpr std::string_view twenty = mutants::bases[2];
const std::atomic<bool> goes_on = false;

MutationPlan motion_mutants(std::size_t stride, std::uint64_t trials, std::string_view fault = "") {
  MutationPlan plan{{},     std::string(twenty), {}, {Precision::binary32, Precision::binary64},
                    trials, motion_mutants_seed, 2};
  std::size_t i = stride / 2;
  for (const mutants::Mutant& m : mutants::mutants_of(twenty)) {
    if (!fault.empty() && m.fault != fault) continue;
    if (i++ % stride == 0) plan.mutants.push_back(&m);
  }
  plan.families = families_of(*find_kernel(twenty).predicate, 0);
  return plan;
}

TEST(MotionMutants, AreOfEveryOperationComparisonAndAxis) {
  const auto all = mutants::mutants_of(twenty);
  const auto count = [&](std::string_view fault) {
    return std::count_if(all.begin(), all.end(), [&](const mutants::Mutant& m) { return m.fault == fault; });
  };
  EXPECT_EQ(count("strictness"), 61);
  EXPECT_EQ(count("reverse"), 61);
  EXPECT_EQ(count("drop"), 20);
  EXPECT_GE(count("operator"), 300);
  EXPECT_EQ(mutants::find_mutant(std::string(twenty) + "~operator:0").where, "0: ax - px");
  EXPECT_EQ(mutants::kernel_of(all.front()).predicate, &find_predicate("moving-sphere"));
  EXPECT_THROW(mutants::mutants_of("moving-sphere/twenty"), Error) << "strict sides are wrong over the reals";
}

// Every 149th: all are caught; those that round as the base does by their claim of formulae alone too.
TEST(MotionMutants, ASampleIsCaught) {
  const MutationResult result = run_mutation(motion_mutants(149, 1500), goes_on, {});
  EXPECT_GE(result.mutants.size(), 30u);
  for (const MutantResult& r : result.mutants) {
    if (equivalent_mutants().contains(r.mutant->id)) continue;
    EXPECT_TRUE(r.by_bits) << r.mutant->id << ' ' << r.mutant->where << ' ' << name(r.precision) << " seed "
                           << motion_mutants_seed;
  }
}

TEST(MotionMutants, AKernelThatIsRightIsNeverFlagged) {
  for (const Control& c : run_controls(motion_mutants(1, 0, "none"), 8, goes_on))
    EXPECT_EQ(c.flagged, 0u) << c.id << ' ' << name(c.precision) << " seed " << motion_mutants_seed;
}

}  // namespace

}  // namespace axiscert

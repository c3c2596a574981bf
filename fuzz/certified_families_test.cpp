// The certified predicate over every family and a mesh, judged as any kernel is: on each instruction set, and with each
// floating-point mode that a caller can have set. The conservative one against its promise, and the filters that are
// proved never to be wrong against theirs.
#include <gtest/gtest.h>

#include "fuzz/unit.h"
#include "kernel/certified.h"
#include "kernel/environment.h"

namespace axiscert {
namespace {

std::vector<SourcePtr> all_sources() {
  std::vector<SourcePtr> sources;
  for (const Family* family : families()) sources.push_back(family_source(*family));
  sources.push_back(mesh_source(TEST_MODELS "/OBJ/spider.obj"));
  return sources;
}

// Runs visit(tally, where) for each kernel and `size` queries of every source in both precisions.
template <class Visit>
void for_each_tally(const std::vector<const Kernel*>& kernels, const std::string& target, std::uint64_t size,
                    Visit&& visit) {
  Plan plan;
  plan.kernels = kernels;
  plan.sources = all_sources();
  plan.target = target;
  for (const SourcePtr& source : plan.sources) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      std::vector<Tally> all(kernels.size());
      for (std::uint64_t unit = 0; unit * unit_size < size; ++unit) {
        const std::uint64_t count = std::min(unit_size, size - unit * unit_size);
        std::vector<Standing> standings;
        for (const Tally& tally : all) standings.push_back(standing_of(tally));
        const auto found = run_unit(plan, *source, precision, unit, count, standings).tallies;
        for (std::size_t k = 0; k < all.size(); ++k) all[k].merge(found[k]);
      }
      for (std::size_t k = 0; k < all.size(); ++k) {
        ASSERT_EQ(all[k].trials, size);
        visit(all[k], kernels[k]->id + " on " + target + ", " + source->name() + ", " + std::string(name(precision)));
      }
    }
  }
}

void expect_exact(const Kernel& kernel, const std::string& target, std::uint64_t size) {
  for_each_tally({&kernel}, target, size, [](const Tally& tally, const std::string& where) {
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.false_contact, 0u) << where;
    EXPECT_EQ(tally.verdict.undecided + tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
  });
}

void expect_conservative(const Kernel& kernel, const std::string& target, std::uint64_t size) {
  for_each_tally({&kernel}, target, size, [](const Tally& tally, const std::string& where) {
    const double promised = where.ends_with("binary32") ? AXISCERT_PHANTOM_DEPTH_F32 : AXISCERT_PHANTOM_DEPTH_F64;
    EXPECT_EQ(tally.verdict.false_separation, 0u) << where;
    EXPECT_EQ(tally.verdict.undecided + tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
    EXPECT_LE(tally.verdict.deepest_false_contact.best(), promised) << where;
  });
}

// They decline, and of ordinary queries few.
void expect_never_wrong(const std::string& target, std::uint64_t size) {
  const std::vector<const Kernel*> filters = {&find_kernel("certified-filter"),
                                              &find_kernel("certified-filter-published")};
  for_each_tally(filters, target, size, [&](const Tally& tally, const std::string& where) {
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.false_contact, 0u) << where;
    EXPECT_EQ(tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
    if (where.starts_with("certified-filter on ") && where.find(", general,") != where.npos) {
      EXPECT_LT(tally.verdict.undecided, size / 100) << where;
    }
  });
}

// The kernel as an engine calls it that has set these modes.
Kernel called_in(const Kernel& kernel, Rounding rounding, bool flush) {
  Kernel called = kernel;
  const auto wrapped = [=](auto implementation) {
    const auto verdicts = implementation.verdicts;
    implementation.verdicts = [=](const auto& batch, Verdict* out) {
      const FloatingEnvironment callers(rounding, flush);
      verdicts(batch, out);
    };
    return implementation;
  };
  called.binary32 = [=, &kernel](std::string_view target) { return wrapped(kernel.binary32(target)); };
  called.binary64 = [=, &kernel](std::string_view target) { return wrapped(kernel.binary64(target)); };
  return called;
}

void expect_exact_in_every_mode(std::uint64_t size) {
  for (const Rounding rounding : {Rounding::nearest, Rounding::upward, Rounding::downward, Rounding::toward_zero}) {
    for (const bool flush : {false, true}) {
      SCOPED_TRACE(testing::Message() << "rounding " << static_cast<int>(rounding) << (flush ? ", flushed" : ""));
      expect_exact(called_in(find_kernel("certified"), rounding, flush), available_targets().front(), size);
    }
  }
}

constexpr std::uint64_t few = 2048 / TRIAL_DIVISOR, many = 8 * unit_size / TRIAL_DIVISOR;

TEST(CertifiedFamilies, ExactOnEveryInstructionSet) {
  for (const std::string& target : available_targets()) expect_exact(find_kernel("certified"), target, few);
}
TEST(CertifiedFamilies, ExactInEveryFloatingPointMode) { expect_exact_in_every_mode(few / 4); }
TEST(CertifiedFamilies, ConservativeAsPromised) {
  for (const std::string& target : available_targets()) expect_conservative(find_kernel("conservative"), target, few);
}
TEST(CertifiedFamilies, FiltersAreNeverWrong) {
  for (const std::string& target : available_targets()) expect_never_wrong(target, few / 2);
  expect_never_wrong(available_targets().front(), 2 * few);
}

TEST(CertifiedFamiliesLong, ExactOnEveryInstructionSet) {
  for (const std::string& target : available_targets()) expect_exact(find_kernel("certified"), target, many);
}
TEST(CertifiedFamiliesLong, ExactInEveryFloatingPointMode) { expect_exact_in_every_mode(many); }
TEST(CertifiedFamiliesLong, ConservativeAsPromised) {
  expect_conservative(find_kernel("conservative"), available_targets().front(), many);
}
// 10^8 queries in each precision.
TEST(CertifiedFamiliesLong, FiltersAreNeverWrong) {
  expect_never_wrong(available_targets().front(), 100'000'000 / all_sources().size() / TRIAL_DIVISOR + 1);
}

}  // namespace
}  // namespace axiscert

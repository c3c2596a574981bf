// The certified predicate over every family and a mesh, judged like any kernel: on each instruction set, and with each
// floating-point mode that a caller can have set; and about the open sphere, which no kernel is. The conservative one
// is checked against its promise, and so are the filters whose program is proved never to be wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/campaign.h"
#include "kernel/base/environment.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/registry/called.h"
#include "kernel/sphere_triangle/certified_kernels.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

std::vector<SourcePtr> all_sources() {
  std::vector<SourcePtr> sources;
  for (const Family* family : families_of(sphere_triangle_predicate())) sources.push_back(family_source(*family));
  sources.push_back(mesh_source(TEST_MODELS "/OBJ/spider.obj", sphere_triangle_predicate()));
  return sources;
}

// Runs visit(tally, where) for each kernel and `size` queries of every source in both precisions. All kernels are asked
// the same queries, since the truth costs more than most kernels.
template <class Visit>
void for_each_tally(const std::vector<std::string>& ids, std::uint64_t size, Visit&& visit) {
  Plan plan;
  for (const std::string& id : ids) plan.answerers.kernels.push_back(&find_kernel(id));
  plan.questions.sources = all_sources();
  plan.running.target = available_targets().front();
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : {Precision::binary32, Precision::binary64}) {
      std::vector<Tally> all(ids.size(), empty_tally(sphere_triangle_predicate()));
      for (std::uint64_t unit = 0; unit * unit_size < size; ++unit) {
        const std::uint64_t count = std::min(unit_size, size - unit * unit_size);
        std::vector<StandingLeaders> standings;
        for (const Tally& tally : all) standings.push_back(standing_of(tally));
        const auto found = run_unit(plan, *source, precision, unit, count, standings).tallies;
        for (std::size_t k = 0; k < all.size(); ++k) all[k].merge(found[k]);
      }
      for (std::size_t k = 0; k < all.size(); ++k) {
        ASSERT_EQ(all[k].trials, size);
        visit(all[k], ids[k] + ", " + source->name() + ", " + std::string(name(precision)));
      }
    }
  }
}

void expect_exact(const std::vector<std::string>& ids, std::uint64_t size) {
  for_each_tally(ids, size, [](const Tally& tally, const std::string& where) {
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.false_contact, 0u) << where;
    EXPECT_EQ(tally.verdict.undecided + tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
  });
}

void expect_conservative(const std::vector<std::string>& ids, std::uint64_t size) {
  for_each_tally(ids, size, [](const Tally& tally, const std::string& where) {
    const double promised = where.ends_with("binary32") ? AXISCERT_PHANTOM_DEPTH_F32 : AXISCERT_PHANTOM_DEPTH_F64;
    EXPECT_EQ(tally.verdict.false_separation, 0u) << where;
    EXPECT_EQ(tally.verdict.undecided + tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
    EXPECT_LE(tally.verdict.deepest_false_contact.best(), promised) << where;
  });
}

// The filters may decline, but decline few ordinary queries.
void expect_never_wrong(const std::vector<std::string>& ids, std::uint64_t size) {
  for_each_tally(ids, size, [&](const Tally& tally, const std::string& where) {
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.false_contact, 0u) << where;
    EXPECT_EQ(tally.verdict.invalid + tally.verdict.unanswered, 0u) << where;
    if (!where.starts_with("certified-filter-published") && where.find(", general,") != where.npos) {
      EXPECT_LT(tally.verdict.undecided, size / 100) << where;
    }
  });
}

// An open sphere touches what is nearer than r, by CGAL's distance: on each instruction set and, the first of `size`
// queries of every source, in each floating-point mode, through the library's steps and by integers alone.
template <class Real>
void expect_exact_of_the_open_sphere(const Source& source, std::size_t size, std::size_t size_in_modes,
                                     std::array<int, 4>& counts) {
  QueryBatch<Real> batch(size, coordinate_count);
  source.fill(1, 0, size, batch);
  const QueryColumns<Real> columns = batch.columns();
  std::vector<int> expected;
  for (std::size_t i = 0; i < size; ++i) {
    const auto q = query_from(batch[i]);
    const int order = is_valid(q) ? distance_order(q) : 2;
    expected.push_back(order == 2 ? AXISCERT_INVALID : order < 0 ? AXISCERT_CONTACT : AXISCERT_SEPARATED);
    ++counts[static_cast<std::size_t>(order + 1)];
  }
  const auto expect = [&](const auto& found, std::size_t asked, const std::string& how) {
    for (std::size_t i = 0; i < asked; ++i) {
      ASSERT_EQ(static_cast<int>(found[i]), expected[i]) << source.name() << ", query " << i << ", " << how;
    }
  };
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(size);
    certified_implementation<Real>(target, certified::Question::open_sphere).verdicts(columns, found.data());
    expect(found, size, target);
  }
  std::array<const Real*, coordinate_count> pointers;
  std::copy_n(columns.column.begin(), coordinate_count, pointers.begin());
  for (const axiscert_question question : {AXISCERT_OPEN_SPHERE, AXISCERT_OPEN_EXACT_ONLY}) {
    std::vector<std::uint8_t> found(size);
    for (std::size_t mode = 0; mode < 8; ++mode) {
      const std::size_t asked = mode == 0 ? size : size_in_modes;
      {
        const FloatingEnvironment callers(static_cast<Rounding>(mode % 4), mode >= 4);
        certified::pairs(pointers, asked, question, {found.data(), nullptr, nullptr});
      }
      expect(found, asked, fmt::format("question {}, mode {}", static_cast<int>(question), mode));
    }
  }
}
void expect_exact_of_the_open_sphere(std::size_t size, std::size_t size_in_modes) {
  std::array<int, 4> counts = {};
  for (const SourcePtr& source : all_sources()) {
    expect_exact_of_the_open_sphere<float>(*source, size, size_in_modes, counts);
    expect_exact_of_the_open_sphere<double>(*source, size, size_in_modes, counts);
  }
  for (const int count : counts) EXPECT_GT(count, 10) << "nearer, touching, farther or invalid";
}

std::vector<std::string> on_every_instruction_set(const std::vector<std::string>& kernels) {
  std::vector<std::string> ids;
  for (const std::string& kernel : kernels) {
    for (const std::string& target : available_targets()) ids.push_back(kernel + "@" + target);
  }
  return ids;
}

// Each rounding direction, with and without flushing, except the default modes.
std::vector<std::string> in_every_mode(const std::vector<std::string>& called) {
  std::vector<std::string> ids;
  for (const std::string& id : called) {
    ids.push_back(id + ",flushed");
    for (const CallMode& mode : call_modes()) {
      if (mode.flush) continue;
      ids.push_back(fmt::format("{},{}", id, mode.name));
      ids.push_back(fmt::format("{},{},flushed", id, mode.name));
    }
  }
  return ids;
}

const std::vector<std::string> certified = on_every_instruction_set({"certified"});
const std::vector<std::string> certified_in_modes = in_every_mode(certified);
const std::vector<std::string> conservative = on_every_instruction_set({"conservative"});
const std::vector<std::string> filters = on_every_instruction_set({"certified-filter", "certified-filter-published"});

constexpr std::uint64_t few = 2048 / TRIAL_DIVISOR, many = 8 * unit_size / TRIAL_DIVISOR;

TEST(CertifiedFamilies, ExactOnEveryInstructionSet) { expect_exact(certified, few); }
TEST(CertifiedFamilies, ExactInEveryFloatingPointMode) { expect_exact(certified_in_modes, few / 4); }
TEST(CertifiedFamilies, ExactOfTheOpenSphere) { expect_exact_of_the_open_sphere(few / 2, few / 8); }
TEST(CertifiedFamilies, ConservativeAsPromised) { expect_conservative(conservative, few); }
TEST(CertifiedFamilies, FiltersAreNeverWrong) { expect_never_wrong(filters, 2 * few); }

TEST(CertifiedFamiliesLong, ExactOnEveryInstructionSet) { expect_exact(certified, many); }
TEST(CertifiedFamiliesLong, ExactInEveryFloatingPointMode) { expect_exact(certified_in_modes, many); }
TEST(CertifiedFamiliesLong, ExactOfTheOpenSphere) { expect_exact_of_the_open_sphere(many / 16, many / 64); }
TEST(CertifiedFamiliesLong, ConservativeAsPromised) { expect_conservative(conservative, many); }
// 10^8 queries in each precision.
TEST(CertifiedFamiliesLong, FiltersAreNeverWrong) {
  expect_never_wrong({"certified-filter", "certified-filter-published"},
                     100'000'000 / all_sources().size() / TRIAL_DIVISOR + 1);
}

}  // namespace
}  // namespace axiscert

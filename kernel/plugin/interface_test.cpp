// The two sides of the interface: structs of any size, other versions, kernels that declare what cannot be true, and a
// predicate of another shape.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstring>
#include <deque>

#include "kernel/ask.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/plugin/caller.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/predicate.h"
#include "kernel/random_testing.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing_support::random_query;

std::string layout_path(const std::string& name) { return fmt::format(BUILD_FOLDER "/declarations/{}.so", name); }

template <class Real>
QueryBatch<Real> random_queries() {
  constexpr std::size_t count = 2021;  // two batches; the second does not fill whole vectors
  std::mt19937_64 random(3);
  QueryBatch<Real> queries(count, coordinate_count);
  for (std::size_t i = 0; i < count; ++i) queries.push_back(random_query<Real>(random, i % 2 == 1));
  return queries;
}

template <class Real>
Reply<Real> asked(const Kernel& kernel, const QueryBatch<Real>& queries) {
  Reply<Real> reply;
  ask(kernel.on<Real>(scalar_target), queries.columns(), reply);
  return reply;
}

TEST(Interface, APluginOfAnotherVersionIsToldToBeBuiltAgainAndNotRead) {
  for (const int abi : {1, 2}) {
    const Kernel& kernel = find_kernel(fmt::format("plugin:{}", layout_path(fmt::format("abi_{}", abi))));
    EXPECT_FALSE(kernel.has(Precision::binary32) || kernel.has(Precision::binary64));
    ASSERT_EQ(kernel.findings.size(), 1u) << abi;
    EXPECT_EQ(kernel.findings[0].kind, FindingKind::abi);
    EXPECT_EQ(kernel.findings[0].detail,
              fmt::format("it was made for version {} of the plug-in interface, but this axiscert takes 3: build it "
                          "again with this axiscert's <axiscert/plugin.h>",
                          abi));
  }
}

TEST(Interface, SidesComeThrough) {
  const QueryBatch<float> queries = random_queries<float>();
  const Reply<float> reply = asked(find_kernel("plugin:" + layout_path("sides")), queries);
  EXPECT_TRUE(reply.watched.findings.empty()) << reply.watched.findings.front().detail;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const float* const column = queries.columns().column[k % 13];
    EXPECT_EQ(std::memcmp(reply.answers.lhs[k].data(), column, queries.size() * sizeof(float)), 0) << k;
    EXPECT_EQ(reply.answers.rhs[k], std::vector<float>(queries.size(), static_cast<float>(k)));
  }
}

TEST(Interface, NothingIsReadBeyondTheSizeThatAStructHas) {
  const Kernel& kernel = find_kernel("plugin:" + layout_path("short_kernel"));
  EXPECT_TRUE(kernel.findings.empty()) << kernel.findings.front().detail;
  EXPECT_EQ(kernel.summary, "short");
  EXPECT_EQ(kernel.exposes, Exposure::verdict);
  EXPECT_FALSE(kernel.limits.any());
  const Reply<float> reply = asked(kernel, random_queries<float>());
  EXPECT_EQ(reply.verdicts, std::vector(reply.verdicts.size(), Verdict::undecided));

  const Kernel& limited = find_kernel("plugin:" + layout_path("short_limits"));
  EXPECT_TRUE(limited.findings.empty()) << limited.findings.front().detail;
  EXPECT_EQ(limited.limits, (Limits{.least_coordinate = 0.5}));
}

TEST(Interface, AKernelWithoutTheMemberThatSaysThatItDeclinesDoesNotSayIt) {
  for (const char* name : {"short_kernel", "all_but_last"}) {
    const Kernel& kernel = find_kernel("plugin:" + layout_path(name));
    EXPECT_TRUE(kernel.findings.empty()) << name << ": " << kernel.findings.front().detail;
    EXPECT_FALSE(kernel.may_decline) << name;
  }
  EXPECT_EQ(find_kernel("plugin:" + layout_path("all_but_last")).touching, TouchingPolicy::either);
}

TEST(Interface, AKernelHasItsSource) {
  const Kernel& kernel = find_kernel(fmt::format("plugin:{}/misbehaving/alignment.so", BUILD_FOLDER));
  EXPECT_EQ(kernel.source, "kernel/plugin/misbehaving/alignment.c:8");
}

TEST(Interface, WhatCannotBeTrueIsOneLineThatSaysWhatWouldBe) {
  for (const auto& [name, says] :
       {std::pair{"no_size", "it has the size 0; sizeof(axiscert_kernel) was expected, at least 40"},
        std::pair{"no_limits_size", "its `limits` has the size 0; sizeof(axiscert_limits) was expected, at least 16"},
        std::pair{"unknown_predicate", "unknown predicate 'sphere-cube'; predicates: sphere-triangle"},
        std::pair{"unknown_entry", "predicate 'sphere-triangle': unknown entry 'edges'; entries: vertices"},
        std::pair{"wrong_columns", "it reads 12 columns; predicate 'sphere-triangle' in entry 'vertices' has 13"},
        std::pair{"unknown_measure", "it gives 9 measures; predicate 'sphere-triangle' has 8"},
        std::pair{"strange_decline",
                  "its may_decline is 2; known: 0, it decides every query; 1, it may answer undecided"},
        std::pair{"two_promises", "its kernels in binary32 and in binary64 say different things of themselves"}}) {
    SCOPED_TRACE(name);
    const Kernel& kernel = find_kernel(fmt::format("plugin:{}/declarations/{}.so", BUILD_FOLDER, name));
    EXPECT_FALSE(kernel.has(Precision::binary32));
    ASSERT_EQ(kernel.findings.size(), 1u);
    EXPECT_EQ(kernel.findings[0].kind, FindingKind::load);
    EXPECT_THAT(kernel.findings[0].detail, HasSubstr(says));
    EXPECT_EQ(kernel.findings[0].detail.find('\n'), std::string::npos);
  }
}

TEST(Interface, ABitBeyondTheLastComparisonIsFound) {
  QueryBatch<float> queries(1, coordinate_count);
  queries.push_back(Query<float>{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 5000});
  const Reply<float> reply =
      asked(find_kernel(fmt::format("plugin:{}/misbehaving/beyond_the_last.so", BUILD_FOLDER)), queries);
  ASSERT_EQ(reply.watched.findings.size(), 1u);
  EXPECT_EQ(reply.watched.findings[0].kind, FindingKind::inconsistent);
  EXPECT_THAT(reply.watched.findings[0].detail, HasSubstr("comparison bit 40 is 1; there are comparisons 0 to 15"));
}

// A predicate that is not in the list, of the shape that the plug-in `wide` expects.
const Predicate& wide_predicate() {
  static std::deque<std::string> names;
  const auto numbered = [](const char* word, std::size_t i) -> std::string_view {
    return names.emplace_back(fmt::format("{}{}", word, i));
  };
  static const Predicate predicate = [&] {
    Predicate wide{.id = "wide",
                   .asks = "nothing",
                   .touching = "never",
                   .wrong_answers = {},
                   .entries = {{"numbers", "any", {}}},
                   .comparisons = {},
                   .clauses = {{"all", (std::uint64_t{1} << 33) - 1}},
                   .measures = {{"first", "one", "in ulps"}, {"second", "one", "in ulps"}}};
    for (std::size_t k = 0; k < 40; ++k) {
      wide.entries[0].columns.push_back({numbered("x", k), Role::coordinate, "all"});
    }
    for (std::size_t k = 0; k < 33; ++k) wide.comparisons.push_back({numbered("comparison", k), 0});
    return checked(wide);
  }();
  return predicate;
}

TEST(Interface, AKernelOfAPredicateThatIsNotThereIsRefused) {
  const Kernel& kernel = find_kernel("plugin:" + layout_path("wide"));
  ASSERT_EQ(kernel.findings.size(), 1u);
  EXPECT_THAT(kernel.findings[0].detail, HasSubstr("unknown predicate 'wide'"));
}

TEST(Interface, FortyColumnsThirtyThreeComparisonsAndTwoMeasures) {
  constexpr std::size_t count = 9;
  const plugin::Subject subject{&wide_predicate()};
  plugin::HostProcess host({layout_path("wide"), {}}, subject);
  const plugin::Shape& shape = host.shape();
  const plugin::Placement placement;
  const auto array = [&](std::size_t which) {
    return reinterpret_cast<double*>(host.area(which) +
                                     array_offset(placement, count, sizeof(double), host.area_bytes()));
  };
  std::mt19937_64 random(4);
  for (std::size_t k = 0; k < 40; ++k) {
    for (std::size_t i = 0; i < count; ++i) array(k)[i] = static_cast<double>(random() % 16);
  }
  plugin::Reply reply;
  const auto stop =
      host.call({.kernel = 0, .size = count, .exposes = 2, .measures = 2, .placement = placement}, 1, reply);
  ASSERT_FALSE(stop) << stop->detail;
  const auto* const verdict = reinterpret_cast<const std::uint8_t*>(
      host.area(shape.verdict()) + array_offset(placement, count, 1, host.area_bytes()));
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(verdict[i], static_cast<std::uint8_t>(Verdict::undecided));
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 33; ++k) {
      EXPECT_EQ(array(shape.lhs() + k)[i], array(k)[i]);
      EXPECT_EQ(array(shape.rhs() + k)[i], array(k + 7)[i]);
      bits |= std::uint64_t{array(k)[i] > array(k + 7)[i]} << k;
    }
    std::uint64_t told;
    std::memcpy(&told, array(shape.bits()) + i, sizeof told);
    EXPECT_EQ(told, bits);
    for (std::size_t m = 0; m < 2; ++m) {
      EXPECT_EQ(array(shape.measure() + m)[i], array(m + 1)[i] - array(0)[i]);
    }
  }
  EXPECT_EQ(subject.array_name(39), "x39");
  EXPECT_EQ(subject.array_name(shape.rhs() + 32), "rhs[32]");
  EXPECT_EQ(subject.array_name(shape.measure() + 1), "measure[1]");
}

TEST(Interface, ACallerTakesTheColumnsOfItsPredicateAndNoOthers) {
  plugin::Caller<double> caller({.hosted = {layout_path("wide"), {}}, .index = 0, .subject = {&wide_predicate()}}, 1);
  plugin::Outputs<double> outputs;
  QueryBatch<double> queries(3, 40);
  for (std::size_t i = 0; i < 3; ++i) {
    Numbers<double> numbers(40);
    for (std::size_t k = 0; k < 40; ++k) numbers[k] = static_cast<double>((k * (i + 3)) % 11);
    queries.push_back(numbers);
  }
  const auto result = caller.call(queries.columns(), 0, 3, {.asked = Exposure::sides, .measures = 2}, 1, outputs);
  ASSERT_FALSE(result.stop) << result.stop->detail;
  ASSERT_EQ(outputs.measures.size(), 2u);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t m = 0; m < 2; ++m) EXPECT_EQ(outputs.measures[m][i], queries[i][m + 1] - queries[i][0]);
  }
  ASSERT_EQ(outputs.lhs.size(), 33u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Numbers<double> numbers = queries[i];
    for (std::size_t k = 0; k < 33; ++k) {
      EXPECT_EQ(outputs.lhs[k][i], numbers[k]);
      EXPECT_EQ(has_bit(outputs.bits[i], k), numbers[k] > numbers[k + 7]);
    }
  }
  ASSERT_FALSE(caller.call(queries.columns(), 0, 3, {.asked = Exposure::sides}, 1, outputs).stop);
  EXPECT_TRUE(outputs.measures.empty()) << "not asked for";
  const auto narrow = [&] { caller.call(random_queries<double>().columns(), 0, 1, {}, 1, outputs); };
  EXPECT_THAT(narrow, testing::ThrowsMessage<HarnessFault>(HasSubstr("takes 40 columns; the batch has 13")));
}

}  // namespace
}  // namespace axiscert

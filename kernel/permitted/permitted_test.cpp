// Permitted evaluations: the ends of sums and products are those of every order, grouping and rounding tried one by
// one; the arithmetics that a permission allows answer within it; where nothing is rounded nothing is permitted to
// differ.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <random>
#include <set>

#include "kernel/base/error.h"
#include "kernel/permitted/adversary.h"
#include "kernel/permitted/graph.h"
#include "kernel/permitted/kernels.h"
#include "kernel/permitted/lanes.h"
#include "kernel/permitted/reach.h"
#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert::permitted {
namespace {

using Values = std::set<float>;
constexpr std::uint64_t seed = 20261127;

// What one operation may give, by the definition: the float below or at the exact value, and that above or at it.
void put_rounded(const Permissions& permissions, long double exact, Values& to) {
  const auto nearest = static_cast<float>(exact);
  Values some = {nearest};
  if (permissions.faithful && nearest < exact) some.insert(std::nextafter(nearest, HUGE_VALF));
  if (permissions.faithful && nearest > exact) some.insert(std::nextafter(nearest, -HUGE_VALF));
  if (permissions.flushed && std::fabs(exact) < 0x1p-126L) some.insert(0);
  to.merge(some);
}

// Every value of a subset of the terms (or factors), by every way to part it in two.
Values every(const Permissions& permissions, const std::vector<Values>& terms, unsigned mask, bool is_sum) {
  if ((mask & (mask - 1)) == 0) return terms[static_cast<std::size_t>(__builtin_ctz(mask))];
  Values found;
  for (unsigned sub = (mask - 1) & mask; sub != 0; sub = (sub - 1) & mask) {
    for (const float x : every(permissions, terms, sub, is_sum)) {
      for (const float y : every(permissions, terms, mask & ~sub, is_sum)) {
        const long double a = x, b = y;  // 64 bits hold the exact sum and product of the numbers below
        put_rounded(permissions, is_sum ? a + b : a * b, found);
      }
    }
  }
  return found;
}

const Part& part(std::string_view name) {
  for (const Part& one : parts) {
    if (one.name == name) return one;
  }
  throw HarnessFault("no such part");
}

TEST(Reach, EndsAreThoseOfEveryEvaluationTriedOneByOne) {
  std::mt19937_64 random(seed);
  // Numbers of few bits and sizes near each other, so that long doubles are exact, and that roundings and ties are
  // many.
  const auto number = [&] {
    return std::ldexp(static_cast<float>(static_cast<int>(random() % 0x1ffffff) - 0xffffff),
                      static_cast<int>(random() % 12));
  };
  std::size_t wide = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Permissions permissions{.faithful = trial % 2 == 0, .reassociated = true};
    const std::size_t count = 2 + random() % 3;
    Graph graph(permissions);
    std::vector<float> inputs;
    std::vector<Values> terms;
    Value sum = graph.constant(0);
    // Sums of x y + z: products are terms of the sum, to which their own values lead.
    for (std::size_t i = 0; i < count; ++i) {
      const float x = number(), y = i % 2 == 0 ? 1 : number() / 0x1p24F;
      const Value product = y == 1 ? graph.input(inputs.size())
                                   : graph.product(graph.input(inputs.size()), graph.input(inputs.size() + 1));
      const bool minus = random() % 2 == 0;
      sum = graph.sum(sum, minus ? -product : product);
      Values values;
      if (y == 1) values = {x};
      else put_rounded(permissions, static_cast<long double>(x) * y, values);
      inputs.push_back(x);
      if (y != 1) inputs.push_back(y);
      Values signs;
      for (const float value : values) signs.insert(minus ? -value : value);
      terms.push_back(signs);
    }
    Evaluation evaluation(graph);
    evaluation.start(inputs);
    const Values all = every(permissions, terms, (1u << count) - 1, true);
    EXPECT_EQ(evaluation.of(sum), (Reach{*all.begin(), *all.rbegin()})) << "seed " << seed << " trial " << trial;
    wide += all.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(wide, 100u);
}

TEST(Reach, FlushingAndOverflowAreTheEndsThatTheyAllow) {
  Graph graph(part("wgsl").permissions);
  const Value product = graph.product(graph.input(0), graph.input(1));
  Evaluation evaluation(graph);
  const auto reach = [&](float x, float y) {
    const std::vector<float> inputs{x, y};
    evaluation.start(inputs);
    return evaluation.of(product);
  };
  EXPECT_EQ(reach(0x1p-100F, 0x1p-30F), (Reach{0, 0x1p-130F}));
  EXPECT_EQ(reach(-0x1p-130F, 1), (Reach{-0x1p-130F, 0}));
  EXPECT_EQ(reach(0x1p100F, 0x1p30F), (Reach{-HUGE_VALF, HUGE_VALF}));
  // The cofactors of a factor that is taken out are summed, here beyond the greatest float.
  Value sum = product;
  for (const std::size_t k : {2, 3}) sum = graph.sum(sum, graph.product(graph.input(0), graph.input(k)));
  const std::vector<float> inputs{0x1p-100F, 0x1.8p126F, 0x1.8p126F, 0x1.8p126F};
  Evaluation of_three(graph);
  of_three.start(inputs);
  EXPECT_EQ(of_three.of(sum), (Reach{-HUGE_VALF, HUGE_VALF}));
  EXPECT_EQ(of_three.outer_of(sum).radius, HUGE_VAL);
}

TEST(Reach, QuotientsAreAllFloatsWithinTwoAndAHalfUlp) {
  std::mt19937_64 random(seed);
  const auto number = [&] {
    return std::ldexp(static_cast<float>(0x800000 + random() % 0x800000), static_cast<int>(random() % 8) - 26);
  };
  const Permissions& divided = part("divided").permissions;
  for (int trial = 0; trial < 2000; ++trial) {
    const float x = random() % 2 == 0 ? number() : -number(), y = number();
    const long double exact = static_cast<long double>(x) / y;
    // From the definition: the distance of the floats on both sides of the exact value.
    float below = static_cast<float>(exact);
    if (below > exact) below = std::nextafter(below, -HUGE_VALF);
    float above = below;
    if (above < exact) above = std::nextafter(above, HUGE_VALF);
    const long double up = std::nextafter(above, HUGE_VALF), down = std::nextafter(below, -HUGE_VALF);
    const long double ulp =
        below != above ? static_cast<long double>(above) - below : std::min(up - exact, exact - down);
    Values within;
    float first = below;
    for (int i = 0; i < 8; ++i) first = std::nextafter(first, -HUGE_VALF);
    for (int i = 0; i < 18; ++i, first = std::nextafter(first, HUGE_VALF)) {
      if (std::fabs(first - exact) <= 2.5L * ulp) within.insert(first);
    }
    EXPECT_EQ(rounded_quotient(divided, x, y), (Reach{*within.begin(), *within.rbegin()})) << x << " / " << y;
    EXPECT_EQ(rounded_quotient({}, x, y), (Reach{x / y, x / y}));
  }
  const Reach any{-HUGE_VALF, HUGE_VALF};
  EXPECT_EQ(rounded_quotient(divided, 1, 0), any);
  EXPECT_EQ(rounded_quotient(divided, 1, 0x1p-127F), any);
  EXPECT_EQ(rounded_quotient(divided, 1, 0x1.8p126F), any);
}

TEST(Reach, ADivisionIsRegroupedWherePermitted) {
  std::mt19937_64 random(seed);
  std::size_t differing = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<float> inputs;
    for (int i = 0; i < 3; ++i) inputs.push_back(1 + std::ldexp(static_cast<float>(random() % 0x800000), -23));
    const float x = inputs[0], y = inputs[1], z = inputs[2];
    const Values all = {(x * y) / z, x * (y / z), (x / z) * y};
    differing += all.size() > 1 ? 1 : 0;
    for (const bool reassociated : {false, true}) {
      Graph graph({.reassociated = reassociated});
      const Value value = graph.quotient(graph.product(graph.input(0), graph.input(1)), graph.input(2));
      Evaluation evaluation(graph);
      evaluation.start(inputs);
      const Reach alone{(x * y) / z, (x * y) / z};
      EXPECT_EQ(evaluation.of(value), (reassociated ? Reach{*all.begin(), *all.rbegin()} : alone)) << "seed " << seed;
    }
  }
  EXPECT_GT(differing, 50u);
}

TEST(Reach, CommonFactorsAreTakenOutWherePermitted) {
  for (const char* name : {"reassociated", "factored"}) {
    Graph graph(part(name).permissions);
    const Value x = graph.input(0), y = graph.input(1), z = graph.input(2);
    const Value sum = graph.sum(graph.product(x, y), graph.product(x, z));
    Evaluation evaluation(graph);
    const float a = 1.0118216276168823F, b = 1.4504636526107788F, c = -1.460378885269165F;
    const std::vector<float> inputs{a, b, c};
    evaluation.start(inputs);
    const float written = a * b + a * c, factored = a * (b + c);
    ASSERT_LT(factored, written);
    EXPECT_EQ(evaluation.of(sum), (Reach{name == std::string("factored") ? factored : written, written}));
  }
}

// The evaluations of x y z + x y w, tried one by one.
TEST(Reach, FactorsThatAreTakenOutTogetherAreGroupedInEveryWay) {
  std::mt19937_64 random(seed);
  Graph graph(part("factored").permissions);
  const Value x = graph.input(0), y = graph.input(1), z = graph.input(2), w = graph.input(3);
  const Value sum = graph.sum(graph.product(graph.product(x, y), z), graph.product(graph.product(x, y), w));
  Evaluation evaluation(graph);
  std::size_t apart = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::array<float, 4> inputs;
    for (float& input : inputs) input = 1 + std::ldexp(static_cast<float>(random() % 0x800000), -23);
    const auto [a, b, c, e] = inputs;
    const auto products = [a, b](float last) { return Values{(a * b) * last, (a * last) * b, (b * last) * a}; };
    Values all = {a * (b * c + b * e), b * (a * c + a * e), a * (b * (c + e)), b * (a * (c + e))};
    for (const float one : products(c)) {
      for (const float other : products(e)) all.insert(one + other);
    }
    const float together = (a * b) * (c + e);
    if (together < *all.begin() || together > *all.rbegin()) ++apart;
    all.insert(together);
    evaluation.start(inputs);
    EXPECT_EQ(evaluation.of(sum), (Reach{*all.begin(), *all.rbegin()})) << "seed " << seed << " trial " << trial;
  }
  EXPECT_GT(apart, 3u);
}

// A query whose sphere nearly touches, at the origin or far away.
Query<float> near_query(std::mt19937_64& random) {
  Query<float> q = testing_support::random_query<float>(random, false);
  const float away = random() % 2 == 0 ? 0 : 100;
  for (Vec3<float>* v : {&q.a, &q.b, &q.c, &q.p}) v->x += away;
  const auto wide = [](const Vec3<float>& v) { return portable::Vec3<double>{v.x, v.y, v.z}; };
  const auto nearest = methods::ClosestPoint::closest(
      portable::CentredProblem<double>{wide(q.a) - wide(q.p), wide(q.b) - wide(q.p), wide(q.c) - wide(q.p), 0}, 0.0);
  q.r = static_cast<float>(std::sqrt(dot(nearest, nearest)));
  for (int i = static_cast<int>(random() % 5); i > 0; --i) q.r = std::nextafter(q.r, random() % 2 == 0 ? 0.0F : 4.0F);
  return q;
}

Verdict verdict_in(const std::string& id, const Query<float>& q) {
  return ask(find_kernel(id).on<float>(scalar_target), q).outcome(0).verdict;
}

TEST(Adversary, TheQuickIntervalHoldsWhatANodeMayBe) {
  std::mt19937_64 random(seed);
  std::size_t narrow = 0, all = 0;
  for (const char* rung : {"published", "closest-point", "minkowski"}) {
    for (const Part& one : parts) {
      const Recording recording = recorder_of(find_kernel(rung))(one.permissions);
      Evaluation evaluation(recording.graph);
      for (int trial = 0; trial < 12; ++trial) {
        const Query<float> q = trial % 3 == 0 ? testing_support::coarse_query<float>(random, trial % 2 == 0 ? -60 : 0)
                                              : near_query(random);
        const std::vector<float> inputs{q.a.x, q.a.y, q.a.z, q.b.x, q.b.y, q.b.z, q.c.x,
                                        q.c.y, q.c.z, q.p.x, q.p.y, q.p.z, q.r};
        evaluation.start(inputs);
        for (const auto& [lhs, rhs] : recording.sides) {
          for (const Value side : {lhs, rhs}) {
            const Reach reach = evaluation.of(side);
            const Outer outer = evaluation.outer_of(side);
            ++all;
            if (!(outer.radius < HUGE_VAL)) continue;
            ++narrow;
            EXPECT_LE(outer.middle - outer.radius, reach.least) << rung << " " << one.name << " seed " << seed;
            EXPECT_GE(outer.middle + outer.radius, reach.greatest) << rung << " " << one.name << " seed " << seed;
          }
        }
      }
    }
  }
  EXPECT_GT(narrow, all * 3 / 4);
}

// Numbers of all kinds: near each other and far away, of few bits, very small and very great, 0, subnormal, infinite.
std::vector<float> mixed_numbers(std::mt19937_64& random, const Predicate& predicate, std::size_t entry) {
  const std::uint64_t kind = random() % 9;
  std::vector<float> q;
  for (const PredicateColumn& column : predicate.entries[entry].columns) {
    float x = std::ldexp(static_cast<float>(static_cast<int>(random() % 0x1ffffff) - 0xffffff), -24);
    if (kind == 1) x = static_cast<float>(static_cast<int>(random() % 5) - 2);
    if (kind == 2) x = std::ldexp(x, -static_cast<int>(random() % 100));
    if (kind == 3) x = std::ldexp(x, static_cast<int>(random() % 70));
    if (kind == 4) x += 1000;
    if (kind == 5 && random() % 3 == 0) x = 0;
    if (kind == 6 && random() % 9 == 0) x = std::ldexp(x, -126);
    if (kind == 7 && random() % 40 == 0) x = HUGE_VALF;
    q.push_back(column.role == Role::length ? std::fabs(x) : x);
  }
  return q;
}

// Such numbers, or a sphere that nearly touches, also of so little size that products are flushed.
std::vector<float> mixed_query(std::mt19937_64& random, const Kernel& kernel) {
  if (kernel.predicate->id != "sphere-triangle" || random() % 3 == 0)
    return mixed_numbers(random, *kernel.predicate, kernel.entry);
  const Numbers<float> near = near_query(random);
  std::vector<float> q(near.begin(), near.end());
  const int exponent = random() % 2 == 0 ? 0 : -31;
  for (float& x : q) x = std::ldexp(x, exponent);
  return q;
}

TEST(AdversaryInLanes, AnswersAsTheAdversaryAlsoAskedAgainWithOneColumnChanged) {
  std::mt19937_64 random(seed);
  std::map<Verdict, int> answers;
  for (const char* rung :
       {"published", "reduced-nonstrict", "closest-point", "moving-sphere/twenty-nonstrict", "box-box/cofactor"}) {
    const Kernel& kernel = find_kernel(rung);
    const std::size_t count = kernel.predicate->entries[kernel.entry].columns.size();
    for (const Part& one : parts) {
      if (!AdversaryInLanes::covers(one.permissions) || one.permissions.kept) continue;
      const Recording recording = recorder_of(kernel)(one.permissions);
      for (const Verdict wished : {Verdict::separated, Verdict::contact}) {
        const AdversaryInLanes lanes(*kernel.predicate, kernel.entry, recording, wished);
        Adversary adversary(*kernel.predicate, recording, wished);
        QueryBatch<float> batch(199, count);
        std::vector<std::vector<float>> queries;
        batch.resize(batch.capacity());
        for (std::size_t i = 0; i < batch.size(); ++i) queries.push_back(mixed_query(random, kernel));
        for (int again = 0; again < 3; ++again) {
          const std::size_t changed = random() % count;
          for (std::size_t i = 0; i < batch.size(); ++i) {
            if (again > 0) queries[i][changed] *= 0.9999999F;
            for (std::size_t k = 0; k < count; ++k) batch.mutable_columns().column[k][i] = queries[i][k];
          }
          std::vector<std::uint8_t> can_be(batch.size());
          lanes.ask(batch.columns(), can_be.data());
          for (std::size_t i = 0; i < batch.size(); ++i) {
            const Verdict verdict = adversary.answer(queries[i]);
            EXPECT_EQ(can_be[i] != 0, verdict == wished)
                << rung << " " << one.name << " query " << i << " seed " << seed;
            ++answers[verdict];
          }
        }
      }
    }
  }
  EXPECT_GT(answers[Verdict::separated], 1000);
  EXPECT_GT(answers[Verdict::contact], 1000);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(Kernels, WhatAPermissionAllowsIsWithinIt) {
  const struct {
    const char* part;
    std::vector<const char*> arithmetics;
  } within[] = {{"faithful", {"up", "down", "chop"}},
                {"reassociated", {"dot-yz-x", "dot-xz-y", "rr-ee"}},
                {"fused", {"fma"}},
                {"flushed", {"ftz"}},
                {"wgsl", {"up", "down", "chop", "dot-yz-x", "dot-xz-y", "rr-ee", "fma", "ftz"}}};
  std::mt19937_64 random(seed);
  std::map<std::string, int> differ;
  for (int trial = 0; trial < 300; ++trial) {
    const Query<float> q =
        trial % 10 == 0 ? testing_support::coarse_query<float>(random, trial % 20 == 0 ? -64 : 0) : near_query(random);
    for (const std::string rung : {"published", "reduced-nonstrict", "closest-point"}) {
      if (rung == "closest-point" && trial % 12 != 1) continue;  // it is slow
      const bool plain = verdict_in(rung, q) == Verdict::separated;
      for (const auto& [part, arithmetics] : within) {
        const bool can_separate = verdict_in(rung + "+" + part + "-misses", q) == Verdict::separated;
        const bool can_touch = verdict_in(rung + "+" + part + "-invents", q) == Verdict::contact;
        EXPECT_TRUE(plain ? can_separate : can_touch) << rung << " " << part << " trial " << trial << " seed " << seed;
        differ[part] += can_separate && can_touch ? 1 : 0;
        for (const char* arithmetic : arithmetics) {
          if (rung == "closest-point") continue;  // it exists as it stands alone
          const bool separated = verdict_in(rung + "+" + arithmetic, q) == Verdict::separated;
          EXPECT_TRUE(separated ? can_separate : can_touch)
              << rung << "+" << arithmetic << " is not within " << part << ", trial " << trial << " seed " << seed;
        }
        if (part == std::string("wgsl")) continue;
        EXPECT_TRUE(!can_separate || verdict_in(rung + "+wgsl-misses", q) == Verdict::separated);
        EXPECT_TRUE(!can_touch || verdict_in(rung + "+wgsl-invents", q) == Verdict::contact);
      }
      // Behind barriers less is permitted.
      EXPECT_TRUE(verdict_in(rung + "+wgsl-kept-misses", q) == Verdict::contact ||
                  verdict_in(rung + "+wgsl-misses", q) == Verdict::separated);
    }
  }
  for (const auto& [part, count] : differ) EXPECT_GT(count, part == "flushed" ? 0 : 10) << part;
}

TEST(Kernels, WhereNothingIsRoundedAllAnswerAsThePlainOne) {
  std::mt19937_64 random(seed);
  for (int trial = 0; trial < 100; ++trial) {
    const Query<float> q = testing_support::coarse_query<float>(random, 0);
    for (const std::string rung : {"published", "reduced-nonstrict"}) {
      for (const std::string& name : names())
        EXPECT_EQ(verdict_in(rung + "+" + name, q), verdict_in(rung, q)) << rung << "+" << name;
    }
  }
}

TEST(Kernels, AnEvaluationIsPrintedAsAnExpression) {
  // |A - P|^2 is 1 + 2^-46 exactly, and so rounded to nearest the square of r: a faithful rounding makes it more.
  const Query<float> q{{1, 0x1p-23F, 0}, {2, 1, 0}, {2, 0, 1}, {0, 0, 0}, 1};
  const Kernel& kernel = find_kernel("published+faithful-misses");
  const std::vector<std::string> lines = evaluation(kernel, q);
  ASSERT_FALSE(lines.empty());
  EXPECT_THAT(lines[0], testing::StartsWith("vertex_a.radius holds: "));
  EXPECT_THAT(lines[0], testing::HasSubstr("up("));
  EXPECT_THAT(lines[0], testing::HasSubstr("= 1.00000012 > (r r) = 1"));
  EXPECT_TRUE(evaluation(find_kernel("published"), q).empty());
}

TEST(Kernels, WhatTakesRootsIsRefused) {
  EXPECT_THROW(find_kernel("ladder-0+wgsl-misses"), Error);
  EXPECT_NO_THROW(find_kernel("minkowski+wgsl-invents"));
}

}  // namespace
}  // namespace axiscert::permitted

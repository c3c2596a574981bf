// The safe margin of kernels whose margin is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "fuzz/campaign/stretch_testing.h"
#include "fuzz/instruments/safe_margin.h"
#include "kernel/ask.h"
#include "kernel/predicate.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Scenes by their size and by what their triangles are.

namespace {

const SceneMeasure& of_spheres() {
  static const SceneMeasure measure(sphere_triangle_predicate());
  return measure;
}

// The triangle (-1, -1, z), (1, -1, z), (c, y, z) beside a sphere at (x, 0, 0).
template <class Real>
Numbers<Real> scene(Real y, Real z, Real x, Real r) {
  return {-1, -1, z, 1, -1, z, 0, y, z, x, 0, 0, r};
}

TEST(MarginScene, ItsSizeIsSeenFromTheCentre) {
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 0, 0.5f)), (MarginScene{false, 0}));
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 9, 0.5f)), (MarginScene{false, 1}));   // 10 from the first vertex
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 0, 9.75f)), (MarginScene{false, 0}));  // the radius counts
  EXPECT_EQ(of_spheres().of(scene<double>(1, 1e99, 0, 1)), (MarginScene{true, 99}));  // and beyond degree 6
  EXPECT_EQ(of_spheres().of(Numbers<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), (MarginScene{true, -400}));
}

int decade(double size) { return of_spheres().of(Numbers<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, size}).decade; }
int decade_of_the_shortest_decimal(double size) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, size, std::chars_format::scientific).ptr;
  return std::stoi(std::string(std::find(text, end, 'e') + 1, end));
}

TEST(MarginScene, ADecadeIsThatOfTheShortestDecimal) {
  std::mt19937_64 random(1);
  for (int e = -323; e <= 308; ++e) {
    const double power = std::strtod(fmt::format("1e{}", e).c_str(), nullptr);
    for (const double size : {std::nextafter(power, 0), power, std::nextafter(power, 1e308)})
      if (size > 0) {
        EXPECT_EQ(decade(size), decade_of_the_shortest_decimal(size)) << size;
      }
    EXPECT_EQ(decade(power), e);
  }
  for (int i = 0; i < 10'000; ++i) {
    const double size = std::fabs(std::bit_cast<double>(random()));
    if (std::isfinite(size)) {
      EXPECT_EQ(decade(size), decade_of_the_shortest_decimal(size)) << size;
    }
  }
}

TEST(MarginScene, AnInfiniteSizeIsInTheGreatestDecade) {
  Numbers<double> query = scene<double>(1, 0, -1.5e308, 1);
  query[0] = 1.5e308;  // 3e308 from the centre, which is beyond the numbers
  EXPECT_EQ(of_spheres().of(query).decade, 308);
}

TEST(MarginScene, TrianglesWithoutAnAreaAndNeedlesAreDegenerate) {
  EXPECT_TRUE(of_spheres().of(scene<float>(-1, 0, 0, 1)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(-0.999f, 0, 0, 1)).is_degenerate);    // a height of 0.001 on 2
  EXPECT_FALSE(of_spheres().of(scene<float>(-0.9375f, 0, 0, 1)).is_degenerate);  // of a sixteenth
  EXPECT_FALSE(of_spheres().of(scene<float>(1, 0, 0, 0)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(1, 0, 0, 0x1p-70f)).is_degenerate);  // whose square is not a normal number
}

TEST(MarginScene, AMovingSphereIsMeasuredByTheSameTriangle) {
  const SceneMeasure moving(find_predicate("moving-sphere"));
  Numbers<float> motion = {-1, -1, 0, 1, -1, 0, 0, -1, 0, 0, 0, 5, 30, 0, 0, 1};
  EXPECT_EQ(moving.of(motion), (MarginScene{true, 1}));  // the displacement counts
  motion[7] = 1;
  EXPECT_EQ(moving.of(motion), (MarginScene{false, 1}));
}

constexpr std::uint64_t margin_queries_asked = 3000;

// `certified`, asked with another radius.
template <class Change>
Kernel certified_with(const std::string& id, Change change) {
  Kernel kernel = find_kernel("certified");
  kernel.id = id;
  const auto with = [change]<class Real>(Real) {
    return [change](std::string_view target) {
      const Implementation<Real> right = find_kernel("certified").on<Real>(target);
      return Implementation<Real>{[right, change](const QueryColumns<Real>& batch, Verdict* out) {
        std::vector<Real> radii(batch.size);
        for (std::size_t i = 0; i < batch.size; ++i) radii[i] = change(batch.column[12][i]);
        QueryColumns<Real> changed = batch;
        changed.column[12] = radii.data();
        right.verdicts(changed, out);
      }};
    };
  };
  kernel.binary32 = with(float());
  kernel.binary64 = with(double());
  return kernel;
}

SafeMargin margin_for(const Kernel& kernel, Precision precision, std::uint64_t probes, int threads = 2,
                      std::vector<StoredQuery> found = {}) {
  Plan run = small_plan({"published"}, {"general", "tangent", "lattice", "repeated"}, margin_queries_asked);
  run.running.threads = threads;
  const SafeMarginPlan plan{
      &run.questions, &run.running,    &kernel, precision, [](const Source&) { return margin_queries_asked; },
      probes,         std::move(found)};
  const std::atomic<bool> interrupted = false;
  return safe_margin(plan, interrupted, {});
}

// `certified`, that hears of no sphere of a radius below `least`.
Kernel deaf_below(double least) {
  Kernel kernel = find_kernel("certified");
  kernel.id = "deaf";
  const auto with = [least]<class Real>(Real) {
    return [least](std::string_view target) {
      const Implementation<Real> right = find_kernel("certified").on<Real>(target);
      return Implementation<Real>{[right, least](const QueryColumns<Real>& batch, Verdict* out) {
        right.verdicts(batch, out);
        for (std::size_t i = 0; i < batch.size; ++i)
          if (batch.column[12][i] < least && out[i] == Verdict::contact) out[i] = Verdict::separated;
      }};
    };
  };
  kernel.binary32 = with(float());
  kernel.binary64 = with(double());
  return kernel;
}

// The margin for a single query, as a search finds it, without those of a run.
SafeMargin margin_for_find(const Kernel& kernel, Precision precision, const std::string& members) {
  const std::string line = fmt::format(R"({{"precision":"{}",{}}})", name(precision), members);
  Plan run = small_plan({"published"}, {"general"}, 0);
  const SafeMarginPlan plan{&run.questions,
                            &run.running,
                            &kernel,
                            precision,
                            [](const Source&) { return 0u; },
                            0,
                            parse_queries(line + "\n", "f", precision)};
  const std::atomic<bool> interrupted = false;
  return safe_margin(plan, interrupted, {});
}

// A sphere around a point of the triangle, in a scene of size 4.
std::string sphere_of(double r) {
  return fmt::format(R"("a":[-4,-4,0],"b":[4,-4,0],"c":[0,4,0],"p":[0,0,0],"r":{})", r);
}

TEST(SafeMargin, AKernelThatIsRightNeedsNone) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const SafeMargin margin = margin_for(find_kernel("certified"), precision, 200);
    EXPECT_EQ(margin.total().missed, 0u);
    EXPECT_FALSE(margin.factor || margin.amount || margin.hopeless);
    EXPECT_EQ(margin.phantoms, 0u);
    EXPECT_GT(margin.queries, 3 * margin_queries_asked);
    EXPECT_EQ(margin.probed, 4 * 200u);
  }
}

TEST(SafeMargin, AKernelThatHalvesTheRadiusNeedsTheFactorTwoAndNothingElseChanges) {
  const Kernel halves = certified_with("halves", [](auto r) { return r / 2; });
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const SafeMargin margin = margin_for(halves, precision, 100);
    ASSERT_TRUE(margin.factor);
    EXPECT_EQ(margin.factor->value.text(), "2");  // exactly: at the least radius, which the probes ask
    const MarginPart all = margin.total();
    EXPECT_GT(all.missed, 100u);
    EXPECT_EQ(all.hopeless, 0u);
    EXPECT_EQ(all.still_missed_by_factor, 0u);
    EXPECT_EQ(all.phantoms_by_factor, 0u);  // the sphere of twice the radius, halved, is the same
    EXPECT_EQ(all.still_missed_by_amount, 0u);
    EXPECT_GT(all.phantoms_by_amount, 0u);  // what the greatest of a decade needs is too much for a small sphere
  }
}

TEST(SafeMargin, TheWitnessIsMissedAtItsRadiusAndCaughtWhereItSays) {
  const Kernel halves = certified_with("halves", [](auto r) { return r / 2; });
  const SafeMargin margin = margin_for(halves, Precision::binary32, 10);
  ASSERT_TRUE(margin.amount);
  const StoredQuery stored = parse_queries(margin.amount->query + "\n", "w", Precision::binary32).front();
  Numbers<float> query = std::get<Numbers<float>>(stored.numbers);
  const Implementation<float> kernel = halves.on<float>("scalar");
  EXPECT_EQ(ask(kernel, query).verdicts[0], Verdict::separated);
  query[12] = std::strtof(margin.amount->critical.c_str(), nullptr);
  EXPECT_EQ(ask(kernel, query).verdicts[0], Verdict::contact);
  query[12] = std::nextafter(query[12], 0.0f);
  EXPECT_EQ(ask(kernel, query).verdicts[0], Verdict::separated);
}

TEST(SafeMargin, NoRadiusMendsAKernelThatNeverSaysContact) {
  const Kernel never = certified_with("never", [](auto r) { return r * 0; });
  const SafeMargin margin = margin_for(never, Precision::binary32, 0);
  const MarginPart all = margin.total();
  EXPECT_GT(all.hopeless, 1000u);
  EXPECT_EQ(all.hopeless, all.missed);
  ASSERT_TRUE(margin.hopeless);
  EXPECT_EQ(margin.hopeless->critical, "");
  EXPECT_FALSE(margin.factor);
}

TEST(SafeMargin, ASphereThatHoldsTheTriangleAndIsMissedIsPastMending) {
  // The size of the scene is 4: what would be heard from 8 on is mended, and from more on not.
  const SafeMargin mended = margin_for_find(deaf_below(8), Precision::binary32, sphere_of(0.5)),
                   missed = margin_for_find(deaf_below(9), Precision::binary32, sphere_of(0.5));
  EXPECT_EQ(mended.total().hopeless, 0u);
  ASSERT_TRUE(mended.factor);
  EXPECT_EQ(mended.factor->value.text(), "16");
  EXPECT_EQ(missed.total().hopeless, 1u);
  EXPECT_FALSE(missed.factor || missed.amount);
}

TEST(SafeMargin, AFindOfASearchCounts) {
  // The sphere of radius 1 touches; a hundredth less is what only this query needs.
  const Kernel shy = certified_with("shy", [](auto r) { return r == 1 ? decltype(r)(0.99) : r; });
  const std::string line = R"({"precision":"binary32","a":[-5,-5,1],"b":[5,-5,1],"c":[0,5,1],"p":[0,0,0],"r":1})";
  EXPECT_EQ(
      margin_for(find_kernel("certified"), Precision::binary32, 0, 2, parse_queries(line, "f", Precision::binary32))
          .total()
          .missed,
      0u);
  const SafeMargin margin = margin_for(shy, Precision::binary32, 0, 2, parse_queries(line, "f", Precision::binary32));
  EXPECT_EQ(margin.found, 1u);
  ASSERT_TRUE(margin.factor);
  EXPECT_EQ(margin.parts.at({false, 0}).amount->family.empty(), false);
  EXPECT_EQ(margin.factor->value.text(), "1.00001");  // the next number after 1
}

TEST(SafeMargin, ATinyRadiusHasAnAmountAndNoFactor) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const double least_not_tiny = std::ldexp(4.0, -tiny_radius_exponent[precision]);
    for (const double r : {0.0, -0.0, 1e-30, least_not_tiny * 0.75}) {
      const SafeMargin margin = margin_for_find(deaf_below(0.25), precision, sphere_of(r));
      EXPECT_EQ(margin.total().missed, 1u) << r;
      EXPECT_EQ(margin.total().tiny, 1u) << r;
      EXPECT_FALSE(margin.factor || margin.parts.begin()->second.factor) << r;
      ASSERT_TRUE(margin.amount) << r;
      EXPECT_EQ(exact(std::strtod(margin.amount->critical.c_str(), nullptr)), Rational(1, 4)) << r;
      EXPECT_LE(margin.amount->value.value(), 0.25) << r;
    }
    const SafeMargin margin = margin_for_find(deaf_below(0.25), precision, sphere_of(least_not_tiny));
    EXPECT_EQ(margin.total().tiny, 0u);
    ASSERT_TRUE(margin.factor);
    EXPECT_EQ(margin.factor->value.text(), precision == Precision::binary32 ? "256" : "4194310");  // 2^22, rounded up
  }
}

TEST(SafeMargin, DegenerateTrianglesHaveAMarginOfTheirOwn) {
  // The needle needs 16 times the radius, the triangle twice.
  const std::string needle = R"("a":[-4,-1,0],"b":[4,-1,0],"c":[0,-0.9999,0],"p":[0,-1,0],"r":0.0625)";
  const std::string triangle = sphere_of(0.5);
  const SafeMargin of_needle = margin_for_find(deaf_below(1), Precision::binary32, needle),
                   of_triangle = margin_for_find(deaf_below(1), Precision::binary32, triangle);
  ASSERT_TRUE(of_needle.parts.contains({true, 0}) && of_triangle.parts.contains({false, 0}));
  EXPECT_EQ(of_needle.parts.at({true, 0}).factor->value.text(), "16");
  EXPECT_EQ(of_triangle.parts.at({false, 0}).factor->value.text(), "2");
}

TEST(SafeMargin, IsTheSameOnAnyNumberOfThreads) {
  const Kernel halves = certified_with("halves", [](auto r) { return r / 2; });
  const SafeMargin one = margin_for(halves, Precision::binary32, 50, 1),
                   two = margin_for(halves, Precision::binary32, 50, 2);
  ASSERT_EQ(one.parts.size(), two.parts.size());
  EXPECT_EQ(one.factor->query, two.factor->query);
  EXPECT_EQ(one.amount->query, two.amount->query);
  EXPECT_EQ(one.total().phantoms_by_amount, two.total().phantoms_by_amount);
}

TEST(SafeMargin, ARadiusIsRoundedUp) {
  EXPECT_GE(exact(rounded_up_to<float>(Rational(1, 3))), Rational(1, 3));
  EXPECT_LT(exact(std::nextafter(rounded_up_to<float>(Rational(1, 3)), 0.0f)), Rational(1, 3));
  EXPECT_EQ(rounded_up_to<float>(Rational(1)), 1.0f);
  EXPECT_EQ(rounded_up_to<float>(exact(1e300)), std::numeric_limits<float>::max());
}

// A contact that got no verdict is not one that was not missed: nothing is known of it.
TEST(SafeMargin, CountsContactsByTheAnswerThatTheyGot) {
  Kernel kernel = find_kernel("certified");
  kernel.id = "mute";
  const auto said = [](Verdict answer) {
    return [answer](std::string_view) {
      return Implementation<float>{
          [answer](const QueryColumns<float>& batch, Verdict* out) { std::fill_n(out, batch.size, answer); }};
    };
  };
  for (const Verdict answer : enumerators<Verdict>) {
    kernel.binary32 = said(answer);
    const SafeMargin margin = margin_for(kernel, Precision::binary32, 8);
    const ContactAnswers& run = margin.of_run;
    EXPECT_GT(run.asked(), 1000u);
    EXPECT_EQ(run.missed, answer == Verdict::separated ? run.asked() : 0);
    EXPECT_EQ(run.looked_at.undecided, answer == Verdict::undecided ? run.asked() : 0);
    EXPECT_EQ(run.looked_at.invalid, answer == Verdict::invalid ? run.asked() : 0);
    EXPECT_EQ(run.looked_at.unanswered, answer == Verdict::unanswered ? run.asked() : 0);
    const MarginPart all = margin.total();
    EXPECT_EQ(all.contacts, run.asked() + margin.of_others.asked());
    EXPECT_EQ(all.without_verdict, run.without_verdict() + margin.of_others.without_verdict());
    EXPECT_EQ(all.missed, run.missed + margin.of_others.missed);
  }
}

}  // namespace

}  // namespace axiscert

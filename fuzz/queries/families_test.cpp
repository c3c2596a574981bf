// Properties of every family: the registry, oracles that agree; and that the families about
// sizes reach the sizes they claim.
#include <fmt/format.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <set>

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/queries/family_testing.h"
#include "fuzz/queries/floats.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "kernel/base/error.h"
#include "kernel/sources_testing.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
class EveryFamily : public testing::Test {};
TYPED_TEST_SUITE(EveryFamily, Reals);
template <class Real>
class FamilySizes : public testing::Test {};
TYPED_TEST_SUITE(FamilySizes, Reals);

TEST(Families, HaveANameOfTheirOwnAVersionAndAPurposeOfOneLine) {
  for (const Family* family : families()) {
    EXPECT_GE(family->version, 1) << family->name;
    EXPECT_GE(family->cost, 1) << family->name;
    EXPECT_GE(family->trial_divisor, 1) << family->name;
    EXPECT_FALSE(family->purpose.empty() || family->purpose.find('\n') != std::string_view::npos) << family->name;
    EXPECT_EQ(&find_family(family->name), family) << "two families are called '" << family->name << "'";
  }
  EXPECT_THROW(find_family("nothing"), Error);
}

// A family of another predicate than the first is defined with the predicate's id before its own name; one of the first
// has hyphens where its variable has underscores.
TEST(Families, EveryOneThatIsDefinedIsListed) {
  for (const auto& [defined, file] : testing_support::defined_in("fuzz", R"(extern const Family (\w+)_family =)")) {
    const std::string folder = file.substr(0, file.rfind('/'));
    std::string name = defined;
    if (folder.ends_with("/sphere_triangle/families")) std::replace(name.begin(), name.end(), '_', '-');
    for (const Predicate* predicate : predicates()) {
      std::string prefix = std::string(predicate->id) + "_";
      std::replace(prefix.begin(), prefix.end(), '-', '_');
      if (predicate != &sphere_triangle_predicate() && defined.starts_with(prefix)) {
        name = fmt::format("{}/{}", predicate->id, defined.substr(prefix.size()));
      }
    }
    EXPECT_NO_THROW(find_family(name)) << file << " defines " << defined << "_family, which the list of " << folder
                                       << "/families.cpp lacks";
  }
}

TYPED_TEST(EveryFamily, RoundsNothingWhereItSaysSo) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    if (!family->exact_arithmetic) continue;
    for_each_query<TypeParam>(family->name, 2000, [&](const Query<TypeParam>& q, std::uint64_t) {
      std::feclearexcept(FE_INEXACT);
      reference_sides(q);
      EXPECT_EQ(std::fetestexcept(FE_INEXACT), 0)
          << "'" << family->name << "' is said to be of exact arithmetic in the file that defines it";
    });
  }
}

TYPED_TEST(EveryFamily, GivesAnAddressOneQueryAndAnotherSeedAnother) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    const auto bytes = [&](std::uint64_t seed, std::uint64_t position) {
      const auto v = coordinates(query_from(family->make<TypeParam>(seed, position)));
      return std::string(reinterpret_cast<const char*>(v.data()), sizeof v);
    };
    std::size_t same = 0;
    for (std::uint64_t position = 0; position < 100; ++position) {
      EXPECT_EQ(bytes(7, position), bytes(7, position)) << family->name << " at " << position;
      same += bytes(7, position) == bytes(8, position);
    }
    EXPECT_LE(same, family->name == "scale" ? 10u : 0u) << family->name << ": only scale may round to nothing";
  }
}

// CGAL and the exact formulae agree; exact_truth throws if they do not. The queries of all families but one are valid
// throughout.
TYPED_TEST(EveryFamily, IsAcceptedByTheOracles) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<TypeParam>(family->name, 2000, [&](const Query<TypeParam>& q, std::uint64_t position) {
      EXPECT_NO_THROW(exact_truth(q, position % 512 == 0));
      EXPECT_TRUE(is_valid(q) || family->name == "nonfinite");
    });
  }
}

// The generators solve with formulae of their own, which are compared here with the oracle's distance.
TYPED_TEST(EveryFamily, RadiusAtDistanceIsTheOraclesDistance) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<TypeParam>(family->name, 400, [&](const Query<TypeParam>& q, std::uint64_t) {
      if (is_valid(q)) {
        EXPECT_EQ(radius_at_distance(q), nearest_sqrt<TypeParam>(squared_distance(q)));
      }
    });
  }
}

template <class Real>
double length(const Vec3<Real>& v) {
  return std::hypot(double(v.x), double(v.y), double(v.z));
}
template <class Real>
Real greatest(const Query<Real>& q) {
  Real most = 0;
  for (const Real x : coordinates(q)) most = std::max(most, std::abs(x));
  return most;
}

TYPED_TEST(FamilySizes, FarIsADecadeInTurnFromTheOrigin) {
  for_each_query<TypeParam>("far", 1000, [](const Query<TypeParam>& q, std::uint64_t position) {
    const double decade = std::pow(10, 2 + static_cast<int>(position % 5));
    for (const auto& v : {q.a, q.b, q.c, q.p}) EXPECT_NEAR(length(v), decade, 2);
    EXPECT_LE(length(q.a - q.b), 3.6);
  });
}

// Every exponent that a coordinate below one can take, from complete underflow to just finite; and clear of tangency.
TYPED_TEST(FamilySizes, ScaleSweepsTheExponentsAndStaysClear) {
  using Limits = std::numeric_limits<TypeParam>;
  const int least = Limits::min_exponent - Limits::digits, greatest_exponent = Limits::max_exponent - 1;
  const auto sweep = static_cast<std::uint64_t>(greatest_exponent - least + 1);
  std::set<int> exponents;
  for_each_query<TypeParam>("scale", sweep, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const int k = least + static_cast<int>(position);
    const TypeParam most = greatest(q);
    if (most > 0) {
      exponents.insert(std::ilogb(most));
      EXPECT_LE(std::ilogb(most), k);
    }
    if (k < Limits::min_exponent + 10) return;  // rounded into subnormals
    EXPECT_GE(std::ilogb(most), k - 3);
    if (std::abs(k) < 100) {
      const double distance = std::sqrt(squared_distance(q).get_d());
      EXPECT_TRUE(q.r <= distance * 0.5001 || q.r >= distance * 1.9999);
    }
  });
  EXPECT_EQ(*exponents.begin(), least);
  EXPECT_GE(*exponents.rbegin(), greatest_exponent - 1);
  EXPECT_GE(exponents.size(), sweep - sweep / 10);
}

TYPED_TEST(FamilySizes, RatioSweepsBothRatios) {
  std::set<int> of_radius, of_distance;
  std::size_t without_radius = 0;
  for_each_query<TypeParam>("ratio", 81 * 82, [&](const Query<TypeParam>& q, std::uint64_t) {
    const double edge = std::max({length(q.a - q.b), length(q.b - q.c), length(q.c - q.a)});
    const double distance = std::min({length(q.a - q.p), length(q.b - q.p), length(q.c - q.p)});
    of_distance.insert(std::ilogb(distance / edge));
    if (q.r == 0) ++without_radius;
    else of_radius.insert(std::ilogb(q.r / edge));
  });
  EXPECT_EQ(without_radius, 81u);
  for (const auto* exponents : {&of_radius, &of_distance}) {
    EXPECT_LE(*exponents->begin(), -40);
    EXPECT_GE(*exponents->rbegin(), 38);
    EXPECT_GE(exponents->size(), 79u);
  }
}

TYPED_TEST(FamilySizes, BitsAreFiniteOfEveryExponent) {
  using Limits = std::numeric_limits<TypeParam>;
  std::set<int> exponents;
  for_each_query<TypeParam>("bits", 4000, [&](const Query<TypeParam>& q, std::uint64_t) {
    ASSERT_TRUE(is_valid(q));
    EXPECT_FALSE(std::signbit(q.r));
    for (const TypeParam x : coordinates(q)) {
      exponents.insert(std::fpclassify(x) == FP_NORMAL ? std::ilogb(x) : Limits::min_exponent - 2);
    }
  });
  EXPECT_EQ(exponents.size(), static_cast<std::size_t>(Limits::max_exponent - Limits::min_exponent + 2));
}

TYPED_TEST(FamilySizes, SubnormalIsBelowOrNearTheLeastNormal) {
  using Limits = std::numeric_limits<TypeParam>;
  std::size_t subnormals = 0, near_distance = 0;
  for_each_query<TypeParam>("subnormal", 2000, [&](const Query<TypeParam>& q, std::uint64_t position) {
    EXPECT_LE(greatest(q), std::ldexp(Limits::min(), 14));
    EXPECT_GT(greatest(q), 0);
    if (position % 2 == 0) {
      for (const TypeParam x : {q.a.x, q.b.y, q.c.z, q.p.x}) EXPECT_LT(std::abs(x), Limits::min());
      ++subnormals;
    }
    const auto distance = nearest_sqrt<TypeParam>(squared_distance(q));
    near_distance += q.r >= step_radius(distance, -2) && q.r <= step_radius(distance, 2);
  });
  EXPECT_EQ(subnormals, 1000u);
  EXPECT_GE(near_distance, 500u);
}

TYPED_TEST(FamilySizes, NonfiniteReachesEveryPlaceAndLeavesSomeValid) {
  std::array<std::size_t, coordinate_count> not_finite{};
  std::size_t valid = 0, negative_radius = 0, minus_zero_radius = 0;
  const std::uint64_t count = 13 * 8 * 20;
  for_each_query<TypeParam>("nonfinite", count, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const auto v = coordinates(q);
    const std::size_t place = position % coordinate_count;
    const std::uint64_t kind = position / coordinate_count % 8;
    EXPECT_EQ(std::isnan(v[place]), kind == 0);
    EXPECT_EQ(std::isinf(v[place]), kind == 1 || kind == 2);
    for (std::size_t k = 0; k < coordinate_count; ++k) not_finite[k] += !std::isfinite(v[k]);
    valid += is_valid(q);
    negative_radius += std::isfinite(q.r) && q.r < 0;
    minus_zero_radius += q.r == 0 && std::signbit(q.r) && is_valid(q);
  });
  for (std::size_t k = 0; k < coordinate_count; ++k) EXPECT_GE(not_finite[k], 60u) << coordinate_names[k];
  EXPECT_GE(valid, count / 8);
  EXPECT_LE(valid, count * 3 / 4);
  EXPECT_GE(negative_radius, 40u);
  EXPECT_GE(minus_zero_radius, 10u);
}

TEST(Families, AreOfOnePredicateEachAndAreNamedAfterItUnlessItIsTheFirst) {
  std::size_t sum = 0;
  for (const Predicate* predicate : predicates()) {
    for (const Family* family : all_families_of(*predicate)) {
      const bool is_of_first = predicate == &sphere_triangle_predicate();
      EXPECT_EQ(family->name.starts_with(std::string(predicate->id) + "/"), !is_of_first) << family->name;
      ASSERT_LT(family->entry, predicate->entries.size()) << family->name;
      EXPECT_EQ(family->make<float>(1, 0).size(), family->column_count()) << family->name;
      ++sum;
    }
  }
  EXPECT_EQ(sum, families().size());
}

}  // namespace
}  // namespace axiscert

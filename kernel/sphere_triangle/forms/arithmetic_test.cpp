// Products that keep their rounding errors or add in another order, against integer arithmetic; the kernels made of
// them; the names by which they are found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kernel/base/error.h"
#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::for_each_vertex_order, testing_support::random_query,
    testing_support::sides_in;

template <class Number>
Vec3<Number> vector(float x, float y, float z) {
  return {Number(x), Number(y), Number(z)};
}
template <class Number>
float dot_of(Vec3<float> u, Vec3<float> v) {
  return float(portable::dot(vector<Number>(u.x, u.y, u.z), vector<Number>(v.x, v.y, v.z)));
}
// a b - c d, computed as the x component of a cross product.
template <class Number>
float difference(float a, float b, float c, float d) {
  return float(portable::cross(vector<Number>(0, a, c), vector<Number>(0, d, b)).x);
}

using arithmetic::CompensatedNumber, arithmetic::FusedNumber, arithmetic::Kahan;

// (1 + h)^2 - (1 + 2h) = h^2, h = 2^-12, with the square as the first or as the second product.
TEST(Arithmetic, DifferencesOfProductsByHand) {
  const float h = 0x1p-12f, hh = 0x1p-24f, s = 1 + h, t = 1 + 2 * h;
  EXPECT_EQ(difference<float>(s, s, t, 1), 0);
  EXPECT_EQ(difference<FusedNumber<float>>(s, s, t, 1), hh);
  EXPECT_EQ(difference<Kahan<float>>(s, s, t, 1), hh);
  EXPECT_EQ(difference<CompensatedNumber<float>>(s, s, t, 1), hh);
  EXPECT_EQ(difference<FusedNumber<float>>(t, 1, s, s), 0) << "the second product is rounded";
  EXPECT_EQ(difference<Kahan<float>>(t, 1, s, s), -hh);
  EXPECT_EQ(difference<CompensatedNumber<float>>(t, 1, s, s), -hh);
  EXPECT_EQ(difference<FusedNumber<float>>(s, s, s, s), hh) << "u x u need not vanish";
  EXPECT_EQ(difference<Kahan<float>>(s, s, s, s), 0);
  EXPECT_EQ(difference<CompensatedNumber<float>>(s, s, s, s), 0);
}

TEST(Arithmetic, DotProductsByHand) {
  const float h = 0x1p-12f, hh = 0x1p-24f, s = 1 + h;
  const Vec3<float> first{s, 1, 1}, first_by{s, -1, -2 * h};  // the square comes first
  const Vec3<float> second{1, s, 1}, second_by{-1, s, -2 * h};
  EXPECT_EQ(dot_of<float>(second, second_by), 0);
  EXPECT_EQ(dot_of<FusedNumber<float>>(second, second_by), hh);
  EXPECT_EQ(dot_of<FusedNumber<float>>(first, first_by), 0) << "the first product is rounded";
  EXPECT_EQ(dot_of<Kahan<float>>(first, first_by), hh);
  const Vec3<float> small{1, 0x1p-15f, 1}, small_by{1, 0x1p-15f, -1};  // 1 + 2^-30 - 1
  EXPECT_EQ(dot_of<Kahan<float>>(small, small_by), 0) << "the sum of the first two is rounded";
  EXPECT_EQ(dot_of<CompensatedNumber<float>>(small, small_by), 0x1p-30f);
  // 2^24 + 1 - 2^24, the 1 in the middle.
  using namespace arithmetic;
  using YZFirst = DotOrder<float, FirstPair::y_and_z>;
  using XZFirst = DotOrder<float, FirstPair::x_and_z>;
  const Vec3<float> x_last{1, 0x1p24f, 0x1p24f}, x_last_by{1, -1, 1};
  EXPECT_EQ(dot_of<float>(x_last, x_last_by), 1) << "1 - 2^24 is exact";
  EXPECT_EQ(dot_of<YZFirst>(x_last, x_last_by), 1);
  EXPECT_EQ(dot_of<XZFirst>(x_last, x_last_by), 0);
  const Vec3<float> y_last{0x1p24f, 1, 0x1p24f}, y_last_by{1, 1, -1};
  EXPECT_EQ(dot_of<float>(y_last, y_last_by), 0);
  EXPECT_EQ(dot_of<YZFirst>(y_last, y_last_by), 1);
  EXPECT_EQ(dot_of<XZFirst>(y_last, y_last_by), 1);
  const Vec3<float> z_last{0x1p24f, 0x1p24f, 1}, z_last_by{1, -1, 1};
  EXPECT_EQ(dot_of<float>(z_last, z_last_by), 1);
  EXPECT_EQ(dot_of<YZFirst>(z_last, z_last_by), 1);
  EXPECT_EQ(dot_of<XZFirst>(z_last, z_last_by), 0);
}

// Integers of 24 bits: products and their sums are exact in 64 bits.
struct Integers {
  std::mt19937_64 random;
  std::int64_t next() { return static_cast<std::int64_t>(random() >> 40) * (random() % 2 == 0 ? 1 : -1); }
};
double ulp(std::int64_t x) { return x == 0 ? 0 : std::ldexp(1, std::max(0, std::ilogb(static_cast<double>(x)) - 23)); }

TEST(Arithmetic, DifferencesOfProductsStayWithinTheirBounds) {
  constexpr int seed = 31;
  Integers integers{std::mt19937_64(seed)};
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t a = integers.next(), b = integers.next();
    // In every second case the products nearly cancel.
    const std::int64_t near = i % 2 == 0 ? 0 : 1 + static_cast<std::int64_t>(integers.random() % 1000);
    const std::int64_t c = near == 0 ? integers.next() : a - (a > 0 ? near : -near);
    const std::int64_t d = near == 0 ? integers.next() : b;
    const std::int64_t exact = a * b - c * d;
    const auto error = [&]<class Number>() {
      return std::fabs(double(difference<Number>(float(a), float(b), float(c), float(d))) - double(exact));
    };
    const double kahan = error.template operator()<Kahan<float>>();
    ASSERT_LE(kahan, 1.5 * ulp(exact)) << "case " << i << " of seed " << seed;
    if (exact != 0) worst = std::max(worst, kahan / ulp(exact));
    // Ogita, Rump, Oishi: u |exact| + gamma_2^2 (|a b| + |c d|), gamma_2 = 2u / (1 - 2u).
    const double size = std::fabs(double(a * b)) + std::fabs(double(c * d));
    ASSERT_LE(error.template operator()<CompensatedNumber<float>>(),
              0x1p-24 * std::fabs(double(exact)) + 0x1.001p-46 * size)
        << "case " << i << " of seed " << seed;
  }
  EXPECT_GT(worst, 0.5) << "no case came near the bound";
}

TEST(Arithmetic, DotProductsAreRoundedWhereTheySay) {
  constexpr int seed = 32;
  Integers integers{std::mt19937_64(seed)};
  for (int i = 0; i < 200000; ++i) {
    std::int64_t u[3], v[3];
    for (int k = 0; k < 3; ++k) u[k] = integers.next(), v[k] = integers.next();
    const Vec3<float> x{float(u[0]), float(u[1]), float(u[2])}, y{float(v[0]), float(v[1]), float(v[2])};
    // The conversion of a 64-bit integer to float rounds once, to nearest.
    const auto once = [](std::int64_t n) { return static_cast<std::int64_t>(static_cast<float>(n)); };
    const std::int64_t fused = once(u[2] * v[2] + once(u[1] * v[1] + once(u[0] * v[0])));
    ASSERT_EQ(dot_of<FusedNumber<float>>(x, y), static_cast<float>(fused)) << "case " << i << " of seed " << seed;
    const std::int64_t exact = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    double size = 0;
    for (int k = 0; k < 3; ++k) size += std::fabs(double(u[k] * v[k]));
    ASSERT_LE(std::fabs(double(dot_of<CompensatedNumber<float>>(x, y)) - double(exact)),
              0x1p-24 * std::fabs(double(exact)) + 9 * 0x1.001p-48 * size)  // gamma_3^2
        << "case " << i << " of seed " << seed;
  }
}

int different_sides(const Query<double>& q, std::string_view rung, std::string_view arithmetic) {
  const auto plain = sides_in(find_kernel(rung), q);
  const auto other = sides_in(find_kernel(std::string(rung) + "+" + std::string(arithmetic)), q);
  int count = 0;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    count += plain.lhs[k] != other.lhs[k] || plain.rhs[k] != other.rhs[k];
  }
  return count;
}

// An operation that is exact does not depend on order, fusion or rounding direction.
TEST(Arithmetic, DiffersFromPlainOnSomeQueryAndOnNoneThatIsExact) {
  constexpr int seed = 33;
  std::mt19937_64 random(seed);
  for (const char* arithmetic : {"fma", "kahan", "compensated", "up", "down", "chop", "dot-yz-x", "dot-xz-y", "rr-ee",
                                 "exact-translation", "world-double"}) {
    int differing = 0;
    for (int i = 0; i < 100; ++i) {
      auto q = random_query<double>(random, false);
      q.p = q.p * 0x1p-9;  // finer than the vertices, so that the translation is rounded
      differing += different_sides(q, "published", arithmetic);
      std::array<double, coordinate_count> v;
      for (double& x : v) x = static_cast<double>(random() % 5) - 2;
      EXPECT_EQ(different_sides(from_coordinates(v), "published", arithmetic), 0)
          << arithmetic << ", query " << i << " of seed " << seed;
    }
    EXPECT_GT(differing, 0) << arithmetic;
  }
}

// A = (2^24 + 1, 0, 0) after the centre is subtracted: one more than r, and one bit too long for binary32.
TEST(Arithmetic, TheTranslationsErrorIsKept) {
  const float far = 0x1p24f;
  const Query<float> original{{far, 0, 0}, {far, 4, 0}, {far, 0, 4}, {-1, 0, 0}, far};
  for_each_vertex_order(original, [](const Query<float>& q, std::string_view order) {
    EXPECT_EQ(answer(find_kernel("published"), q).verdict, Verdict::contact) << order;
    EXPECT_EQ(answer(find_kernel("published+exact-translation"), q).verdict, Verdict::separated) << order;
  });
}

// Edge and plane sides have degree 6: at 2^40 they overflow, at 2^-40 they underflow to zero.
TEST(Arithmetic, PrescalingSurvivesWhereThePublishedTestLeavesTheRange) {
  for (const float s : {0x1p40f, 0x1p-40f}) {
    for (const Vec3<float> p : {Vec3<float>{1, 1, 3}, Vec3<float>{1, -3, 0}, Vec3<float>{4, 4, 1}}) {
      const Query<float> original{{0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}, p * s, s};
      for_each_vertex_order(original, [&](const Query<float>& q, std::string_view order) {
        EXPECT_EQ(answer(find_kernel("published"), q).verdict, Verdict::contact) << s << " " << order;
        EXPECT_EQ(answer(find_kernel("published+prescaled"), q).verdict, Verdict::separated) << s << " " << order;
      });
    }
  }
  const float max = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  const Kernel& kernel = find_kernel("published+prescaled");
  EXPECT_EQ(answer<float>(kernel, {{max, 0, 0}, {max, max, 0}, {max, 0, max}, {0, 0, 0}, max / 2}).verdict,
            Verdict::separated);
  EXPECT_EQ(answer<float>(kernel, {{2 * least, 0, 0}, {2 * least, least, 0}, {2 * least, 0, least}, {0, 0, 0}, least})
                .verdict,
            Verdict::separated);
}

// r is the float below sqrt(3), and r r rounds to 3 in binary32.
TEST(Arithmetic, InDoubleSeparatesWhatBinary32Cannot) {
  const float r = 0x1.bb67aep0f;
  const Query<float> original{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 0}, r};
  ASSERT_LT(double(r) * double(r), 3.0);
  for_each_vertex_order(original, [](const Query<float>& q, std::string_view order) {
    EXPECT_EQ(answer(find_kernel("published"), q).verdict, Verdict::contact) << order;
    EXPECT_EQ(answer(find_kernel("published+in-double"), q).verdict, Verdict::separated) << order;
  });
}

std::string refusal(std::string_view id) {
  try {
    find_kernel(id);
  } catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << id << " was found";
  return "";
}

TEST(ArithmeticNames, AnUnknownOneIsRefusedWithWhatThereIs) {
  std::vector<std::string> known, rungs;
  for (const ArithmeticInfo& arithmetic : arithmetics()) known.push_back(arithmetic.name);
  for (const Kernel& kernel : kernels()) {
    if (kernel.takes_arithmetic) rungs.push_back(kernel.id);
  }
  ASSERT_GT(known.size(), 3u);
  ASSERT_GT(rungs.size(), 3u);
  // The nearest name comes first; every name comes.
  const auto expect_all = [](const std::string& id, const std::string& says, const std::vector<std::string>& names) {
    const std::string message = refusal(id), list = ", " + message.substr(std::min(says.size(), message.size())) + ", ";
    EXPECT_EQ(message.find(says), 0u) << message;
    for (const std::string& name : names)
      EXPECT_NE(list.find(", " + name + ", "), std::string::npos) << name << message;
  };
  expect_all("published+nope", "kernel 'published+nope': unknown arithmetic 'nope'; arithmetics: ", known);
  const std::string says = " is not a rung that takes another arithmetic; rungs that do: ";
  expect_all("minkowski+fma", "kernel 'minkowski+fma': 'minkowski'" + says, rungs);
  expect_all("nope+fma", "kernel 'nope+fma': 'nope'" + says, rungs);
}

TEST(ArithmeticNames, AComposedKernelIsMadeOnceAndSaysWhatItIs) {
  const Kernel& kernel = find_kernel("nonstrict+dot-xz-y");
  EXPECT_EQ(&kernel, &find_kernel("nonstrict+dot-xz-y"));
  EXPECT_EQ(kernel.id, "nonstrict+dot-xz-y");
  EXPECT_EQ(kernel.strictness, Strictness::nonstrict);
  EXPECT_EQ(kernel.formulae, "published");
  EXPECT_EQ(name(kernel.arithmetic), "dot-xz-y");
  EXPECT_FALSE(find_kernel("published+spu").has(Precision::binary64));
  EXPECT_FALSE(find_kernel("published+in-double").has(Precision::binary64));
  EXPECT_FALSE(find_kernel("published+world-double").has(Precision::binary32));
}

}  // namespace
}  // namespace axiscert

// The kernels of two boxes on queries by hand: what an axis sees, what an epsilon costs, and the columns of both
// entries.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "kernel/ask.h"
#include "kernel/boxes/boxes.h"
#include "kernel/boxes/names.h"

namespace axiscert {

std::vector<Kernel> box_box_kernels();

namespace boxes {
namespace {

using Axes = std::array<Vec3<double>, 3>;
constexpr Axes upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// `axes` turned by `angle` about z.
Axes about_z(Axes axes, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3<double>& v : axes) v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  return axes;
}
// On an edge along x: 45 degrees about it.
Axes on_an_edge() {
  const double h = std::sqrt(0.5);
  return {{{1, 0, 0}, {0, h, h}, {0, -h, h}}};
}

bool is_slip(const Kernel& kernel) { return kernel.id.starts_with("box-box/slip-"); }

std::vector<const Kernel*> kernels_of_entry(std::size_t entry, bool with_slips = false) {
  static const std::vector<Kernel> all = box_box_kernels();
  std::vector<const Kernel*> found;
  for (const Kernel& kernel : all) {
    if (kernel.entry == entry && (with_slips || !is_slip(kernel))) found.push_back(&kernel);
  }
  return found;
}

template <class Real>
Reply<Real> reply_of(const Kernel& kernel, const Numbers<Real>& numbers) {
  QueryBatch<Real> batch(1, numbers.size());
  batch.push_back(numbers);
  Reply<Real> reply;
  ask(kernel.on<Real>(scalar_target), batch.columns(), reply);
  return reply;
}
bool is_contact(const Kernel& kernel, const Numbers<double>& numbers) {
  return reply_of(kernel, numbers).verdicts[0] == Verdict::contact;
}

BoxPair<double> unit_boxes(const Axes& a, const Vec3<double>& at, const Axes& b) {
  return {{{0, 0, 0}, {1, 1, 1}, a}, {at, {1, 1, 1}, b}};
}

TEST(BoxKernels, AllSeeAFaceAnEdgeAndACorner) {
  const double diagonal = std::sqrt(2.0);
  for (const Kernel* kernel : kernels_of_entry(MatrixBoxes::entry)) {
    SCOPED_TRACE(kernel->id);
    const auto meets = [&](const BoxPair<double>& q) { return is_contact(*kernel, numbers_of(q)); };
    EXPECT_FALSE(meets(unit_boxes(upright, {2.25, 0, 0}, upright)));
    EXPECT_TRUE(meets(unit_boxes(upright, {2, 0, 0}, upright))) << "touching";
    EXPECT_TRUE(meets(unit_boxes(upright, {1.75, 1.75, 1.75}, upright)));
    // Two edges that cross at right angles, at heights 1.41 and z - 1.41.
    const Axes across = about_z(on_an_edge(), std::acos(0.0));
    EXPECT_FALSE(meets(unit_boxes(on_an_edge(), {0, 0, 2 * diagonal + 0.01}, across)));
    EXPECT_TRUE(meets(unit_boxes(on_an_edge(), {0, 0, 2 * diagonal - 0.01}, across)));
  }
}

TEST(BoxKernels, TheCrossedEdgesAreSeparatedByTheirProductAlone) {
  const Axes across = about_z(on_an_edge(), std::acos(0.0));
  for (const Kernel* kernel : kernels_of_entry(MatrixBoxes::entry)) {
    const Reply<double> reply =
        reply_of(*kernel, numbers_of(unit_boxes(on_an_edge(), {0, 0, 2 * std::sqrt(2.0) + 0.01}, across)));
    if (!reply.has_bits) continue;  // textbook-early shows its verdict alone
    EXPECT_EQ(reply.answers.bits[0], one_bit<ComparisonBits>(edges(0, 0))) << kernel->id;
  }
}

// Edges of half length 1 that cross at a small angle, 2 sqrt(epsilon s l) apart at the widest.
TEST(BoxKernels, AnEpsilonInventsContactsAtItsSquareRoot) {
  const auto says_contact = [](std::string_view id, double gap, double angle) {
    const BoxPair<double> q = unit_boxes(on_an_edge(), {0, 0, 2 * std::sqrt(2.0) + gap}, about_z(on_an_edge(), angle));
    for (const Kernel* kernel : kernels_of_entry(MatrixBoxes::entry)) {
      if (kernel->id == id) return is_contact(*kernel, numbers_of(q));
    }
    ADD_FAILURE() << "no kernel " << id;
    return false;
  };
  EXPECT_TRUE(says_contact("box-box/gottschalk", 1.8e-3, 2e-3));
  EXPECT_FALSE(says_contact("box-box/gottschalk", 2.5e-3, 2e-3));
  EXPECT_TRUE(says_contact("box-box/bullet", 5e-3, 6e-3));
  EXPECT_TRUE(says_contact("box-box/rtcd", 6e-4, 6.9e-4));
  for (const std::string_view right : {"box-box/projected", "box-box/textbook", "box-box/cofactor"}) {
    EXPECT_FALSE(says_contact(right, 6e-4, 6.9e-4)) << right;
    EXPECT_FALSE(says_contact(right, 1e-6, 2e-3)) << right;
  }
}

// Signed permutations as matrices, and as quaternions: every form without an epsilon has the same bits.
TEST(BoxKernels, AgreeOnAlignedBoxesInBothEntries) {
  std::mt19937_64 random(11);
  const auto small = [&](int bound) {
    return static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(2 * bound + 1)) - bound);
  };
  for (int i = 0; i < 300; ++i) {
    TurnedPair<double> turned{};
    BoxPair<double> matrix{};
    const double x = small(4), y = small(4), z = small(4);
    const Vec3<double> at = {x, y, z};
    turned.b.centre = matrix.b.centre = at;
    for (std::size_t k = 0; k < 3; ++k) {
      turned.a.half[k] = matrix.a.half[k] = std::abs(small(2));
      turned.b.half[k] = matrix.b.half[k] = std::abs(small(2));
    }
    turned.a.q = {2, 0, 0, 0};
    turned.b.q = {3, 3, 0, 0};  // a quarter turn about x
    matrix.a.axis = upright;
    matrix.b.axis = {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    const Verdict expected = reply_of(*kernels_of_entry(MatrixBoxes::entry)[0], numbers_of(matrix)).verdicts[0];
    for (const Kernel* kernel : kernels_of_entry(MatrixBoxes::entry)) {
      EXPECT_EQ(reply_of(*kernel, numbers_of(matrix)).verdicts[0], expected) << kernel->id;
    }
    for (const Kernel* kernel : kernels_of_entry(QuaternionBoxes::entry)) {
      EXPECT_EQ(reply_of(*kernel, numbers_of(turned)).verdicts[0], expected) << kernel->id;
    }
  }
}

TEST(BoxColumns, AreReadInTheOrderInWhichTheyAreWritten) {
  Numbers<float> numbers(30), turned(20);
  for (std::size_t k = 0; k < 30; ++k) numbers[k] = static_cast<float>(k);
  for (std::size_t k = 0; k < 20; ++k) turned[k] = static_cast<float>(k);
  const auto q = MatrixBoxes::problem<float>([&](std::size_t k) { return numbers[k]; });
  const auto t = QuaternionBoxes::problem<float>([&](std::size_t k) { return turned[k]; });
  const Numbers<float> back = numbers_of(q), turned_back = numbers_of(t);
  EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), back.begin(), back.end()));
  EXPECT_TRUE(std::equal(turned.begin(), turned.end(), turned_back.begin(), turned_back.end()));
  const Predicate& predicate = box_box_predicate();
  ASSERT_EQ(predicate.entries.size(), 4u);
  EXPECT_EQ(predicate.entries[0].columns.size(), 30u);
  EXPECT_EQ(predicate.entries[1].columns.size(), 20u);
  EXPECT_EQ(predicate.entries[0].columns[14].name, "a.b2z");
  EXPECT_EQ(q.a.axis[2].z, 14);
  EXPECT_EQ(predicate.entries[1].columns[16].name, "b.qw");
  EXPECT_EQ(t.b.q[0], 16);
  EXPECT_EQ(predicate.comparisons[edges(1, 2)].name, "a1b2");
  EXPECT_EQ(predicate.comparisons[facet_of_b(2)].name, "b2");
}

// Each slip is wrong on a query by hand, and in one direction.
TEST(BoxKernels, SlipsAreWrong) {
  const Axes turned = about_z(upright, 0.5);
  const Axes across = about_z(on_an_edge(), std::acos(0.0));
  const std::map<std::string, std::pair<BoxPair<double>, bool>> wrong = {
      {"box-box/slip-book", {unit_boxes(upright, {0, 2.25, 0}, upright), true}},
      {"box-box/slip-frame", {{{{0, 0, 0}, {4, 1, 1}, about_z(upright, 1.5)}, {{0, 4, 0}, {1, 1, 1}, turned}}, false}},
      {"box-box/slip-one-interval", {unit_boxes(upright, {2.25, 0, 0}, upright), true}},
      {"box-box/slip-own-edges", {unit_boxes(on_an_edge(), {0, 0, 2 * std::sqrt(2.0) + 0.01}, across), true}},
  };
  int asked = 0;
  for (const Kernel* kernel : kernels_of_entry(MatrixBoxes::entry, true)) {
    const auto found = wrong.find(kernel->id);
    if (found == wrong.end()) continue;
    ++asked;
    const auto& [query, says_contact] = found->second;
    EXPECT_EQ(is_contact(*kernel, numbers_of(query)), says_contact) << kernel->id;
    EXPECT_EQ(is_contact(*kernels_of_entry(MatrixBoxes::entry)[0], numbers_of(query)), !says_contact) << kernel->id;
  }
  EXPECT_EQ(asked, 4);
}

TEST(BoxKernels, HaveIdsOfThePredicateAndOfTheirEntry) {
  EXPECT_EQ(kernels_of_entry(0).size(), 11u);
  EXPECT_EQ(kernels_of_entry(0, true).size(), 17u);
  EXPECT_EQ(kernels_of_entry(1).size(), 10u);
  EXPECT_EQ(kernels_of_entry(2).size(), 4u);
  EXPECT_EQ(kernels_of_entry(3).size(), 3u);
  for (const std::size_t entry : {0, 1, 2, 3}) {
    for (const Kernel* kernel : kernels_of_entry(entry)) EXPECT_TRUE(kernel->id.starts_with("box-box/")) << kernel->id;
  }
}

}  // namespace
}  // namespace boxes
}  // namespace axiscert

// The judge of the numbers of boxes: what is right is found right, and each planted fault by its own figure.
#include "exact/boxes/contact_judge.h"

#include <cmath>
#include <numbers>

#include "exact/boxes/boxes_testing.h"
#include "exact/judge/oracles.h"
#include "kernel/boxes/contact.h"

namespace axiscert::boxes {
namespace {

using Said = std::array<double, contact_measures>;

constexpr std::array<Vec3<double>, 3> world = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
// B is 1/8 deep in the top of A.
const BoxPair<double> one_on_another{{{0, 0, 0}, {{1, 1, 1}}, world}, {{0.5, 0.25, 1.875}, {{1, 1, 1}}, world}};
const BoxPair<double> far_apart{{{0, 0, 0}, {{1, 1, 1}}, world}, {{4, 5, 6}, {{1, 1, 1}}, world}};
constexpr Said right_of_one_on_another = {-0.125, 0, 0, 1, 0.5, 0, 1, 0.5, 0, 0.875};

ContactJudgement judged(const BoxPair<double>& q, Verdict said, const Said& numbers,
                        std::size_t given = contact_measures) {
  const auto judge = oracles_of(box_box_predicate()).contact_judge(numbers_of(q));
  return judge->judge(said, std::span(numbers).first(given));
}
ContactJudgement changed(const std::function<void(Said&)>& change, Verdict said = Verdict::contact) {
  Said numbers = right_of_one_on_another;
  change(numbers);
  return judged(one_on_another, said, numbers);
}

TEST(BodyContactJudge, FindsRightNumbersRight) {
  const ContactJudgement found = changed([](Said&) {});
  EXPECT_EQ(found.consistency, Consistency::consistent);
  EXPECT_TRUE(found.separation->ulps.is_zero());
  EXPECT_EQ(found.normal_angle, 0);
  EXPECT_EQ(found.normal_length_error, 0);
  EXPECT_TRUE(found.pushed->left.is_zero());
  EXPECT_FALSE(found.pushed->is_flip);
  EXPECT_EQ(found.point_a_error, 0);
  EXPECT_EQ(found.point_b_error, 0);
  EXPECT_EQ(found.points_apart, 0);
}

TEST(BodyContactJudge, FindsEachFault) {
  const double scene = std::sqrt(0.25 + 0.0625 + 1.875 * 1.875);
  EXPECT_NEAR(changed([](Said& n) { n[0] = -0.0625; }).separation->share, 0.0625 / scene, 1e-15) << "half of the depth";
  EXPECT_NEAR(changed([](Said& n) { n[0] = 0.125; }).separation->length, 0.25, 1e-15);
  EXPECT_EQ(changed([](Said& n) { n[0] = 0.125; }).consistency, Consistency::positive);
  EXPECT_EQ(changed([](Said&) {}, Verdict::separated).consistency, Consistency::negative);
  const ContactJudgement flipped = changed([](Said& n) { n[3] = -1; });
  EXPECT_TRUE(flipped.pushed->is_flip);
  EXPECT_EQ(flipped.pushed->left.text(), "2");
  EXPECT_EQ(flipped.normal_angle, std::numbers::pi);
  EXPECT_EQ(flipped.points_apart, 0) << "its points are as right as they were";
  const ContactJudgement across = changed([](Said& n) { n[3] = 0, n[1] = 1; });
  EXPECT_FALSE(across.pushed->is_flip) << "at a right angle";
  EXPECT_EQ(across.pushed->left.text(), "1");
  const ContactJudgement tilted = changed([](Said& n) { n[1] = 0.001; });
  EXPECT_NEAR(*tilted.normal_angle, 0.001, 1e-6);
  EXPECT_NEAR(tilted.pushed->left.value(), 5e-7, 1e-9) << "of second order";
  EXPECT_EQ(changed([](Said& n) { n[3] = 2; }).normal_length_error, 1);
  EXPECT_TRUE(changed([](Said& n) { n[3] = 2; }).pushed->left.is_zero()) << "a length is no direction";
  const ContactJudgement none = changed([](Said& n) { n[3] = 0; });
  EXPECT_TRUE(none.pushed->is_nowhere);
  EXPECT_EQ(none.pushed->left.text(), "1");
  EXPECT_EQ(none.normal_angle, std::numbers::pi);
  const ContactJudgement swapped = changed([](Said& n) { std::swap_ranges(&n[4], &n[7], &n[7]); });
  EXPECT_EQ(swapped.point_a_error, 0) << "within A";
  EXPECT_NEAR(*swapped.points_apart, 0.25 / scene, 1e-15) << "all of the depth is left, twice";
  const ContactJudgement both = changed([](Said& n) { n[3] = -1, std::swap_ranges(&n[4], &n[7], &n[7]); });
  EXPECT_EQ(both.points_apart, swapped.points_apart) << "a normal that fits them makes them no better";
  const ContactJudgement sideways = changed([](Said& n) { n[4] = 0.625, n[6] = n[9] = 0.9375; });
  EXPECT_EQ(sideways.point_a_error, 0);
  EXPECT_NEAR(*sideways.points_apart, 0.125 / scene, 1e-15) << "as far apart as the depth, and nothing is gained";
  EXPECT_NEAR(*changed([](Said& n) { n[6] = 1.25; }).point_a_error, 0.25 / scene, 1e-15);
  EXPECT_NEAR(*changed([](Said& n) { n[6] = 0.9375; }).points_apart, 0.0625 / scene, 1e-15);
}

TEST(BodyContactJudge, TellsWhatIsNotGiven) {
  const auto gone = [](std::size_t first, std::size_t end) {
    return changed([=](Said& n) { std::fill(&n[first], n.data() + end, NAN); });
  };
  EXPECT_TRUE(gone(0, 1).lacks_separation);
  EXPECT_EQ(gone(0, 1).consistency, Consistency::missing);
  EXPECT_TRUE(gone(1, 4).lacks_normal);
  EXPECT_TRUE(gone(4, 7).lacks_point);
  EXPECT_FALSE(gone(0, 10).consistency) << "nothing is given";
  const ContactJudgement few = judged(one_on_another, Verdict::contact, right_of_one_on_another, 4);
  EXPECT_FALSE(few.lacks_point) << "it does not give them anywhere";
  EXPECT_FALSE(few.points_apart);
  Said nothing;
  nothing.fill(NAN);
  EXPECT_FALSE(judged(far_apart, Verdict::separated, nothing).lacks_separation);
}

TEST(BodyContactJudge, JudgesDistances) {
  Said numbers = {std::sqrt(29), 2, 3, 4, 1, 1, 1, 3, 4, 5};
  const ContactJudgement found = judged(far_apart, Verdict::separated, numbers);
  EXPECT_LE(found.separation->ulps.value(), 0.5);
  EXPECT_EQ(found.normal_angle, 0);
  EXPECT_FALSE(found.pushed) << "there is no penetration";
  EXPECT_EQ(found.points_apart, 0);
  for (std::size_t k = 1; k < 4; ++k) numbers[k] *= -1;
  EXPECT_EQ(judged(far_apart, Verdict::separated, numbers).points_apart, 0) << "whatever the normal";
  numbers[7] = 3.5;
  EXPECT_GT(*judged(far_apart, Verdict::separated, numbers).points_apart, 0.02);
  const auto place = oracles_of(box_box_predicate()).contact_judge(numbers_of(far_apart))->place();
  EXPECT_NEAR(*place.separation, std::sqrt(29), 1e-15);
  EXPECT_EQ(*place.point, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(*place.point_b, (std::array<double, 3>{3, 4, 5}));
}

// Where both sides are as deep, either is right; and of a depth like a rounding, a rounding may take the other.
TEST(BodyContactJudge, NoSideIsAFlipWhereBothAreAsDeep) {
  BoxPair<double> q = one_on_another;
  q.b.centre = {0, 0, 0};
  q.b.half = q.a.half = {{1, 1, 0.125}};
  const Said down = {-0.25, 0, 0, -1, 0, 0, -0.125, 0, 0, 0.125}, up = {-0.25, 0, 0, 1, 0, 0, 0.125, 0, 0, -0.125};
  for (const Said& said : {down, up}) {
    EXPECT_TRUE(judged(q, Verdict::contact, said).pushed->left.is_zero());
    EXPECT_FALSE(judged(q, Verdict::contact, said).normal_angle) << "there are two";
    EXPECT_EQ(judged(q, Verdict::contact, said).points_apart, 0);
    Said other = said;
    other[3] *= -1;
    EXPECT_EQ(judged(q, Verdict::contact, other).points_apart, 0) << "points of the one, normal of the other";
  }
  q.a.half[2] = q.b.half[2] = 0x1p-60;
  q.b.centre.z = 0x1p-61;
  const ContactJudgement thin = judged(q, Verdict::contact, down);
  EXPECT_EQ(thin.pushed->left.text(), "0.666667") << "the way down is 5/3 as long";
  EXPECT_FALSE(thin.pushed->is_flip);
}

// What the kernels with numbers say of every entry is judged by the same code.
TEST(BodyContactJudge, EveryEntryHasOne) {
  for (const Predicate* predicate : {&box_box_predicate(), &box_triangle_predicate()}) {
    EXPECT_EQ(predicate->measures.size(), contact_measures);
    for (std::size_t entry = 0; entry < predicate->entries.size(); ++entry) {
      Numbers<float> numbers(predicate->entries[entry].columns.size());
      for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<float>(k % 7) + 1;
      EXPECT_NE(oracles_of(*predicate, entry).contact_judge(numbers), nullptr) << predicate->id << entry;
    }
  }
}

}  // namespace
}  // namespace axiscert::boxes

// What each rung gets wrong over the reals, where nothing is rounded but the numbers given; and the furthest that an
// epsilon reaches, beside 2 sqrt(epsilon s l).
#include <gtest/gtest.h>

#include <cmath>

#include "exact/boxes/boxes_testing.h"
#include "fuzz/boxes/parts.h"
#include "kernel/boxes/textbook.h"
#include "kernel/boxes/projected.h"

namespace axiscert::boxes {
namespace {

constexpr std::uint64_t reals_seed = 1;
constexpr const char* reals_families[] = {"general", "tangent",  "stacked", "resting", "level",
                                          "crossed", "parallel", "thin",    "flat"};

// By rung, in the order of `rungs_on`.
struct RungCounts {
  std::array<Wrong, 9> wrong;
};

template <class... F>
void count_rungs(const BoxPair<ExactNumber>& problem, const ExactPair& exact, bool apart, RungCounts& counts) {
  std::size_t k = 0;
  const auto one = [&]<class Rung>() {
    Wrong& wrong = counts.wrong[k++];
    const bool said_apart = separates<Rung, ExactNumber>(problem);
    wrong.count(said_apart, apart);
    if (said_apart && !apart) wrong.deepest_miss = std::max(wrong.deepest_miss, rounded_depth(exact_depth(exact)));
  };
  (one.template operator()<F>(), ...);
}

RungCounts rungs_on(const char* family, std::uint64_t queries) {
  RungCounts counts;
  const Family& made = find_family(std::string("box-box/") + family);
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<float> numbers = made.make<float>(reals_seed, position);
    const auto problem = exact_problem<MatrixBoxes>(numbers);
    const ExactPair exact = exactly(MatrixBoxes::problem<float>([&](std::size_t k) { return numbers[k]; }));
    count_rungs<ProjectedFifteen, Columns, DroppedFifteen, FramedFifteen, Textbook, Rtcd, Gottschalk, Bullet, Cofactor>(
        problem, exact, are_apart(exact), counts);
  }
  return counts;
}

TEST(RungsOverTheReals, ProjectedIsRightAndOnlyTheTextbookMissesDeeply) {
  const RungCounts resting = rungs_on("resting", 60);
  EXPECT_EQ(resting.wrong[0].all(), 0);
  EXPECT_GT(resting.wrong[4].missed, 3);
  EXPECT_EQ(resting.wrong[8].all(), 0);
  EXPECT_EQ(rungs_on("level", 60).wrong[4].all(), 0) << "upright, the textbook is right";
}

TEST(RungsOverTheRealsLong, OfTheFormsWithoutAnEpsilonTheTextbookAloneMissesDeeply) {
  constexpr std::size_t projected = 0, textbook = 4;
  double deepest = 0;
  for (const char* family : reals_families) {
    const RungCounts counts = rungs_on(family, 2500 / TRIAL_DIVISOR);
    EXPECT_EQ(counts.wrong[projected].all(), 0) << family;
    for (std::size_t k = 0; k < counts.wrong.size(); ++k) {
      if (k != textbook) {
        EXPECT_LT(counts.wrong[k].deepest_miss, 1e-6) << family << ", rung " << k;
      }
    }
    deepest = std::max(deepest, counts.wrong[textbook].deepest_miss);
  }
  if (TRIAL_DIVISOR == 1) {
    EXPECT_GT(deepest, 0.3) << "the textbook";
  }
}

// Both boxes stand on an edge, of half length l along x; B is turned about z, and its lowest edge crosses A's highest
// one in the middle, `gap` above it. In doubles, whose roundings are nothing beside the band.
BoxPair<double> crossing(double s, double l, double angle, double gap) {
  const double h = std::sqrt(0.5), c = std::cos(angle), n = std::sin(angle);
  return {{{0, 0, 0}, {l, s, s}, {{{1, 0, 0}, {0, h, h}, {0, -h, h}}}},
          {{0, 0, 2 * s * std::sqrt(2.0) + gap}, {l, s, s}, {{{c, n, 0}, {-n * h, c * h, h}, {n * h, -c * h, h}}}}};
}

// The widest gap that F still calls contact, over angles of 2^-16 to 1/2.
template <class F>
double band_of(double s, double l) {
  double widest = 0;
  for (double angle = 0x1p-16; angle < 0.5; angle *= 1.01) {
    double contact = 0, apart = 0.25;
    for (int i = 0; i < 60; ++i) {
      const double middle = (contact + apart) / 2;
      (separates<F>(crossing(s, l, angle, middle)) ? apart : contact) = middle;
    }
    widest = std::max(widest, contact);
  }
  return widest;
}

TEST(EpsilonBand, IsTwoRootsOfTheEpsilonTimesBothLengths) {
  for (const auto& [s, l] : {std::pair{1.0, 1.0}, std::pair{1.0, 8.0}, std::pair{1.0, 64.0}, std::pair{0.125, 8.0}}) {
    const auto expect_band = [s = s, l = l](double band, double epsilon) {
      const double expected = 2 * std::sqrt(epsilon * s * l);
      EXPECT_GT(band, expected * 0.9) << s << ' ' << l;
      EXPECT_LT(band, expected * 1.1) << s << ' ' << l;
    };
    expect_band(band_of<Rtcd>(s, l), 0x1p-23);
    expect_band(band_of<Gottschalk>(s, l), 1e-6);
    expect_band(band_of<Bullet>(s, l), 1e-5);
    EXPECT_LT(band_of<Cofactor>(s, l), 1e-12);
  }
}

}  // namespace
}  // namespace axiscert::boxes

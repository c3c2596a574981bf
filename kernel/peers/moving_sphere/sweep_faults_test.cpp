// The known faults of each library that is asked about a sphere that moves, by kind: a change to one of these requires
// a change to docs/moving.md. The truth of each query is in fuzz/corpus/moving-sphere.jsonl, under the name given here.
#include "kernel/peers/moving_sphere/sweeps_testing.h"

namespace axiscert::peer {
namespace {

const char* const bullets[] = {"bullet-subsimplex", "bullet-continuous", "bullet-gjk-cast", "bullet-world"};

template <class Real>
void expect_answer(const char* peer, const Sweep<Real>& query, char wrong) {
  EXPECT_EQ(letters_of(ask_sweeps<Real>(peer, {query})), std::string(1, wrong)) << peer;
}

// bullet-no-motion
TEST(BulletSweepFaults, WithoutMotionAnOverlapIsMissed) {
  for (const char* peer : bullets) expect_answer(peer, motion<float>({1, 1, 0.5f}, {0, 0, 0}, 1), 's');
}

// bullet-overlap-leaving, bullet-overlap-beside
TEST(BulletSweepFaults, AnOverlapAtTheStartIsMissedWhereTheSphereDoesNotApproach) {
  for (const char* peer : bullets) {
    expect_answer(peer, motion<float>({1, 1, 0.5f}, {0, 0, 2}, 1), 's');
    expect_answer(peer, motion<float>({1, 1, 0.5f}, {2, 0, 0}, 1), 's');
  }
}

// fcl-ten-positions: it asks at the heights 9, 7, 5, 3, 1, -1, ...
TEST(FclSweepFaults, ItGoesThroughTheFaceBetweenTwoOfTenPositions) {
  expect_answer("fcl-continuous", motion<double>({1, 1, 9}, {0, 0, -18}, 0.25), 's');
}

// fcl-late-by-a-step: at height 1, after 4/9; the first contact is at 1.99, after 0.3894.
TEST(FclSweepFaults, AHitIsLateByUpToAStep) {
  const auto answer = ask_sweeps<double>("fcl-continuous", {motion<double>({1, 1, 9}, {0, 0, -18}, 1.99)});
  ASSERT_EQ(letters_of(answer), "c");
  EXPECT_EQ(answer[0].measures[0], 4.0 / 9);
}

// fcl-advance-face
TEST(FclSweepFaults, AdvancementMissesAFaceStraightBelow) {
  for (const char* peer : {"fcl-advance-rss", "fcl-advance-obbrss"})
    expect_answer(peer, motion<double>({1, 1, 3}, {0, 0, -4}, 1), 's');
}

// wildmagic-overlap: it is asked to say true at time 0, as its header promises, and says false.
TEST(WildMagicSweepFaults, AnOverlapAtTheStartIsNoContact) {
  const Sweep<float> beside{{0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {-0.5f, 0, 0}, {-1, 0, 0}, 1};
  for (const char* peer : {"wildmagic", "wildmagic-float"}) {
    expect_answer(peer, beside, 's');
    expect_answer(peer, motion<float>({1, 1, 0.5f}, {0, 0, -2}, 1), 's');
  }
}

// wildmagic-invented, wildmagic-negative-time: the root that it takes for the first contact is one before the motion,
// at height 19.7. The first contact is at height 3.74, after 0.532 of the longer motion; the shorter one ends at 7.
TEST(WildMagicSweepFaults, AContactIsGivenATimeBeforeTheMotion) {
  const Sweep<float> whole{{0, -1, 0}, {1, 0, 0}, {0, 0, 0}, {-1, 1, 8}, {0, 0, -8}, 4};
  Sweep<float> clear = whole;
  clear.d.z = -1;
  for (const char* peer : {"wildmagic", "wildmagic-float"}) {
    for (const Sweep<float>& q : {whole, clear}) {
      const auto answer = ask_sweeps<float>(peer, {q});
      ASSERT_EQ(letters_of(answer), "c") << peer;
      EXPECT_NEAR(answer[0].measures[0] * q.d.z, 11.7417, 1e-4) << peer;
    }
  }
}

// wildmagic-assertion: Math::InvSqrt asserts that it is not given 0. The next motion of the batch is answered.
TEST(WildMagicSweepFaults, AnAssertionEndsTheProcessOnAPathThatTouchesAVertex) {
  const Sweep<float> at_an_edge{{1, -1, 1}, {-1, 0, -1}, {0, 0, 0}, {-2, 2, 2}, {0, -3, -3}, 2};
  const auto face = motion<float>({1, 1, 3}, {0, 0, -4}, 1);
  for (const char* peer : {"wildmagic", "wildmagic-float"})
    EXPECT_EQ(letters_of(ask_sweeps<float>(peer, {at_an_edge, face, at_an_edge, face})), "ucuc") << peer;
}

// ode-capsule-vertex
TEST(OdeSweepFaults, ACapsuleThatEndsOnAVertexIsMissed) {
  expect_answer("ode-capsule", motion<double>({-3, -4, 0.5}, {3, 4, -0.5}, 1), 's');
}

}  // namespace
}  // namespace axiscert::peer

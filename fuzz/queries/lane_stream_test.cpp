// Philox in lanes gives Random123's known answers, and every lane of a LaneStream draws the same numbers as a Stream,
// on each instruction set of this machine.
#include <gtest/gtest.h>

#include "fuzz/sphere_triangle/families/parts/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/queries/lane_stream_test.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/queries/lane_stream-inl.h"

#ifndef AXISCERT_LANE_STREAM_TEST_H
#define AXISCERT_LANE_STREAM_TEST_H
namespace axiscert {
using FourWords = std::array<std::uint32_t, 4>;
// The numbers drawn by each lane of a LaneStream, in the order of drawn(): [draw][lane].
template <class Real>
using LaneDraws = std::vector<std::vector<double>>;
inline constexpr int rounds = 40;
constexpr std::uint64_t scattered(std::uint64_t lane) { return lane * lane * 0x100000007u; }
}  // namespace axiscert
#endif

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

FourWords philox_in_lanes(const FourWords& counter, std::uint64_t key) {
#if HWY_TARGET == HWY_SCALAR
  const r123::Philox4x32::ctr_type at = {{counter[0], counter[1], counter[2], counter[3]}};
  const auto words = r123::Philox4x32()(at, {{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)}});
  return {words[0], words[1], words[2], words[3]};
#else
  const hn::ScalableTag<std::uint64_t> d;
  constexpr std::uint64_t garbage = 0xdeadbeef00000000u;  // high halves must not matter
  const auto at = [&](std::size_t k) HWY_ATTR { return hn::Set(d, garbage | counter[k]); };
  const auto words = philox(PhiloxWords<hn::Vec<decltype(d)>>{at(0), at(1), at(2), at(3)}, key);
  const auto low = [](auto w) HWY_ATTR { return static_cast<std::uint32_t>(hn::GetLane(w)); };
  return {low(words.w0), low(words.w1), low(words.w2), low(words.w3)};
#endif
}

template <class Real>
void drawn(const StreamName& name, std::uint64_t first, LaneDraws<Real>& out) {
  using Random = LaneStream<Real>;
  Random random(name, first);
  const auto keep = [&](typename Random::T x) HWY_ATTR {
    HWY_ALIGN Real each[Random::lanes];
    hn::Store(x.v, typename Random::D(), each);
    out.emplace_back(each, each + Random::lanes);
  };
  const auto n = hn::Iota(typename Random::DW(), 1);  // a different n in each lane
  for (int i = 0; i < rounds; ++i) {
    keep(random.unit());
    keep(random.symmetric());
    keep(random.integer(-7, 1 << 20));
    keep(Random::number(random.below(n)));
    keep(random.sign());
  }
  std::uint64_t positions[Random::lanes];
  for (std::size_t i = 0; i < Random::lanes; ++i) positions[i] = first + scattered(i);
  keep(Random(name, positions).unit());
}
void drawn32(const StreamName& name, std::uint64_t first, LaneDraws<float>& out) { drawn<float>(name, first, out); }
void drawn64(const StreamName& name, std::uint64_t first, LaneDraws<double>& out) { drawn<double>(name, first, out); }

}  // namespace
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "fuzz/queries/lane_testing.h"

namespace axiscert {
namespace {
HWY_EXPORT(philox_in_lanes);
HWY_EXPORT(drawn32);
HWY_EXPORT(drawn64);

TEST(LaneStream, PhiloxGivesTheKnownAnswers) {  // kat_vectors of Random123, the lines "philox4x32 10"
  const std::uint32_t ones = 0xffffffff;
  for_each_instruction_set([&](const std::string& target) {
    const auto philox = HWY_DYNAMIC_DISPATCH(philox_in_lanes);
    EXPECT_EQ(philox({0, 0, 0, 0}, 0), (FourWords{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8})) << target;
    EXPECT_EQ(philox({ones, ones, ones, ones}, ~std::uint64_t{0}),
              (FourWords{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}))
        << target;
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
              (FourWords{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}))
        << target;
  });
}

template <class Real>
void expect_lanes_draw_what_streams_draw() {
  // In the second and the last of these, the low word of the position carries over within a vector.
  for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{0xfffffffb}, std::uint64_t{0x123456789abcdef}}) {
    const StreamName name(0xfedcba9876543210, name_hash("lane_stream_test"), 3, precision_of<Real>);
    for_each_instruction_set([&](const std::string& target) {
      LaneDraws<Real> lanes;
      if constexpr (sizeof(Real) == 4) HWY_DYNAMIC_DISPATCH(drawn32)(name, first, lanes);
      else HWY_DYNAMIC_DISPATCH(drawn64)(name, first, lanes);
      for (std::size_t i = 0; i < lanes[0].size(); ++i) {
        Stream random(name, first + i);
        EXPECT_EQ(lanes.back()[i], static_cast<double>(Stream(name, first + scattered(i)).unit<Real>()));
        for (std::size_t k = 0; k + 5 <= lanes.size(); k += 5) {
          SCOPED_TRACE(testing::Message() << target << " lane " << i << " draw " << k << " first " << first);
          EXPECT_EQ(lanes[k][i], static_cast<double>(random.unit<Real>()));
          const Real signed_number = random.symmetric<Real>();
          EXPECT_EQ(lanes[k + 1][i], static_cast<double>(signed_number));
          EXPECT_EQ(std::signbit(lanes[k + 1][i]), std::signbit(signed_number));
          EXPECT_EQ(lanes[k + 2][i], static_cast<double>(random.integer(-7, 1 << 20)));
          EXPECT_EQ(lanes[k + 3][i], static_cast<double>(random.below(i + 1)));
          EXPECT_EQ(lanes[k + 4][i], random.coin() ? 1 : -1);
          if (testing::Test::HasFailure()) return;
        }
      }
    });
  }
}
TEST(LaneStream, DrawsWhatStreamsDrawInBinary32) { expect_lanes_draw_what_streams_draw<float>(); }
TEST(LaneStream, DrawsWhatStreamsDrawInBinary64) { expect_lanes_draw_what_streams_draw<double>(); }

}  // namespace
}  // namespace axiscert
#endif

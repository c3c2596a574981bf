// What a run counts of the first contacts that a kernel reports: times, tunnels, features, normals and points.
#pragma once

#include <array>
#include <cstdint>

#include "exact/judge/motion_judgement.h"
#include "fuzz/campaign/counts/leaders.h"

namespace axiscert {

// Errors of times by powers of two, in units in the last place: number k counts those above 2^(k-1) and at most 2^k;
// the first also all that are less, the last all that are more.
inline constexpr std::size_t ulp_powers = 32;
using UlpCounts = std::array<std::uint64_t, ulp_powers>;
std::size_t ulp_power(const Decimal6& ulps);

// Times on one side of the best one.
struct TimeErrors {
  UlpCounts by_power{};
  Leaders<Decimal6> largest_ulps, largest_in_u;
};

// Tunnels that late hits make, or misses.
struct TunnelTally {
  std::uint64_t through = 0;  // of exactly 1
  Leaders<Decimal6> deepest;
};

struct MotionTally {
  std::uint64_t hits = 0;  // contacts that are right, on which a kernel's measures are judged
  EnumArray<TimeVerdict, std::uint64_t> times{};
  Leaders<bool> no_time;  // the first hit whose time is `none` or `invalid`; ranked by whether it is given
  TimeErrors late, early;
  TunnelTally late_tunnels, missed_tunnels;
  Leaders<double> largest_gap;
  std::uint64_t features = 0, wrong_features = 0, normals = 0, points = 0;  // given, and judged
  Leaders<bool> wrong_feature;
  Leaders<double> largest_angle, largest_point_error;

  void merge(const MotionTally& other);
};

void count_hit(MotionTally& tally, std::uint64_t position, const MotionJudgement& judgement);
void count_missed(MotionTally& tally, std::uint64_t position, const Tunnel& tunnel);

}  // namespace axiscert

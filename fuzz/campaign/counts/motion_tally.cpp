#include "fuzz/campaign/counts/motion_tally.h"

#include <algorithm>

namespace axiscert {
namespace {

void merge_errors(TimeErrors& into, const TimeErrors& from) {
  for (std::size_t k = 0; k < ulp_powers; ++k) into.by_power[k] += from.by_power[k];
  into.largest_ulps.merge(from.largest_ulps);
  into.largest_in_u.merge(from.largest_in_u);
}

void merge_tunnels(TunnelTally& into, const TunnelTally& from) {
  into.through += from.through;
  into.deepest.merge(from.deepest);
}

void count_tunnel(TunnelTally& tally, std::uint64_t position, const Tunnel& tunnel) {
  tally.through += tunnel.is_through;
  if (!tunnel.depth.is_zero()) tally.deepest.offer({tunnel.depth, position});
}

void count_error(TimeErrors& errors, std::uint64_t position, const MotionJudgement& judgement) {
  ++errors.by_power[ulp_power(judgement.ulps)];
  errors.largest_ulps.offer({judgement.ulps, position});
  errors.largest_in_u.offer({judgement.in_u, position});
}

}  // namespace

std::size_t ulp_power(const Decimal6& ulps) {
  const double size = ulps.value();
  std::size_t power = 0;
  for (double bound = 1; power + 1 < ulp_powers && size > bound; bound *= 2) ++power;
  return power;
}

void MotionTally::merge(const MotionTally& other) {
  hits += other.hits;
  for (const TimeVerdict verdict : enumerators<TimeVerdict>) times[verdict] += other.times[verdict];
  no_time.merge(other.no_time);
  merge_errors(late, other.late);
  merge_errors(early, other.early);
  merge_tunnels(late_tunnels, other.late_tunnels);
  merge_tunnels(missed_tunnels, other.missed_tunnels);
  largest_gap.merge(other.largest_gap);
  features += other.features;
  wrong_features += other.wrong_features;
  normals += other.normals;
  points += other.points;
  wrong_feature.merge(other.wrong_feature);
  largest_angle.merge(other.largest_angle);
  largest_point_error.merge(other.largest_point_error);
}

void count_hit(MotionTally& tally, std::uint64_t position, const MotionJudgement& judgement) {
  ++tally.hits;
  if (judgement.time) {
    const TimeVerdict time = *judgement.time;
    ++tally.times[time];
    switch (time) {
      case TimeVerdict::none:
      case TimeVerdict::invalid:
        tally.no_time.offer({time == TimeVerdict::invalid, position});
        break;
      case TimeVerdict::early:
        count_error(tally.early, position, judgement);
        tally.largest_gap.offer({judgement.gap, position});
        break;
      case TimeVerdict::best:
        break;
      case TimeVerdict::late:
        count_error(tally.late, position, judgement);
        count_tunnel(tally.late_tunnels, position, *judgement.tunnel);
        break;
    }
  }
  if (judgement.feature_is_right) {
    ++tally.features;
    if (!*judgement.feature_is_right) {
      ++tally.wrong_features;
      tally.wrong_feature.offer({true, position});
    }
  }
  if (judgement.normal_angle) {
    ++tally.normals;
    tally.largest_angle.offer({*judgement.normal_angle, position});
  }
  if (judgement.point_error) {
    ++tally.points;
    tally.largest_point_error.offer({*judgement.point_error, position});
  }
}

void count_missed(MotionTally& tally, std::uint64_t position, const Tunnel& tunnel) {
  count_tunnel(tally.missed_tunnels, position, tunnel);
}

}  // namespace axiscert

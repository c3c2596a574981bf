#include "fuzz/record/motion_tally.h"

#include <algorithm>

namespace axiscert {
namespace {

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

void count_hit(MotionTally& tally, std::uint64_t position, const MotionJudgement& judgement) {
  ++tally.hits;
  if (judgement.time) {
    TimeTally& time = *tally.time;
    switch (*judgement.time) {
      case TimeVerdict::none:
        ++time.none;
        time.no_time.offer({false, position});
        break;
      case TimeVerdict::invalid:
        ++time.invalid;
        time.no_time.offer({true, position});
        break;
      case TimeVerdict::early:
        ++time.early;
        count_error(time.early_errors, position, judgement);
        time.largest_gap.offer({judgement.gap, position});
        break;
      case TimeVerdict::best:
        ++time.best;
        break;
      case TimeVerdict::late:
        ++time.late;
        count_error(time.late_errors, position, judgement);
        count_tunnel(time.late_tunnels, position, *judgement.tunnel);
        break;
    }
  }
  if (judgement.feature_is_right) {
    ++tally.feature->judged;
    if (!*judgement.feature_is_right) {
      ++tally.feature->wrong;
      tally.feature->first_wrong.offer({true, position});
    }
  }
  if (judgement.normal_angle) {
    ++tally.normal->judged;
    tally.normal->largest_angle.offer({*judgement.normal_angle, position});
  }
  if (judgement.point_error) {
    ++tally.point->judged;
    tally.point->largest_error.offer({*judgement.point_error, position});
  }
}

void count_missed(MotionTally& tally, std::uint64_t position, const Tunnel& tunnel) {
  count_tunnel(tally.missed, position, tunnel);
}

}  // namespace axiscert

#include "fuzz/record/motion_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  if (judgement.share != 0) errors.largest_share.offer({judgement.share, position});
  if (judgement.length != 0) errors.largest_length.offer({judgement.length, position});
}

}  // namespace

std::size_t ulp_power(const Decimal6& ulps) {
  const double size = ulps.value();
  std::size_t power = 0;
  for (double bound = 1; power + 1 < ulp_powers && size > bound; bound *= 2) ++power;
  return power;
}

bool is_told_in_ulps(const Decimal6& ulps) {
  constexpr double most_ulps = 0x1p13;  // an ulp is at most 2^-23, that of 1 in binary32
  return ulps.value() <= most_ulps;
}

std::string way_text(double share, double length) {
  constexpr double least_percent = 1e-3;
  const std::string of_way =
      share < least_percent ? fmt::format("{:.3g}", share) : fmt::format("{:.3g} %", 100 * share);
  return fmt::format("{} of the way, length {:.3g}", of_way, length);
}

std::string time_error_text(const Decimal6& ulps, double share, double length) {
  return is_told_in_ulps(ulps) ? ulps.text() + " ulps" : way_text(share, length);
}

std::string way_text(const TimeErrors& errors) {
  return way_text(errors.largest_share.best(), errors.largest_length.best());
}

std::string time_error_text(const TimeErrors& errors) {
  return time_error_text(errors.largest_ulps.best(), errors.largest_share.best(), errors.largest_length.best());
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
      const double error = judgement.feature_error.value_or(0);
      if (std::isinf(error)) ++tally.feature->unnamed;
      else if (error != 0) tally.feature->largest_error.offer({error, position});
    }
  }
  if (judgement.normal_angle) {
    ++tally.normal->judged;
    tally.normal->largest_angle.offer({*judgement.normal_angle, position});
    tally.normal->largest_length_error.offer({judgement.normal_length_error.value_or(0), position});
  }
  if (judgement.point_error) {
    ++tally.point->judged;
    tally.point->largest_error.offer({*judgement.point_error, position});
  }
  if (judgement.lacks_feature) ++tally.feature->none;
  if (judgement.lacks_normal) ++tally.normal->none;
  if (judgement.lacks_point) ++tally.point->none;
}

void count_missed(MotionTally& tally, std::uint64_t position, const Tunnel& tunnel) {
  count_tunnel(tally.missed, position, tunnel);
}

}  // namespace axiscert

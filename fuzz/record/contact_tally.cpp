#include "fuzz/record/contact_tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiscert {
namespace {

void count_tunnel(TunnelTally& tally, std::uint64_t position, const Tunnel& tunnel) {
  tally.through += tunnel.is_through;
  if (!tunnel.depth.is_zero()) tally.deepest.offer({tunnel.depth, position});
}

void count_error(TimeErrors& errors, std::uint64_t position, const ContactJudgement& judgement) {
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

namespace {

void count_time(TimeTally& time, std::uint64_t position, const ContactJudgement& judgement) {
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

void count_consistency(ConsistencyTally& tally, std::uint64_t position, Consistency found) {
  ++tally.judged;
  tally.positive += found == Consistency::positive;
  tally.negative += found == Consistency::negative;
  tally.missing += found == Consistency::missing;
  if (found != Consistency::consistent) tally.first[found].offer({true, position});
}

void count_separation(SeparationTally& tally, std::uint64_t position, const SeparationError& error) {
  ++tally.judged;
  ++tally.by_decade[error.ulps.is_zero() ? 0 : std::max(decade_of(error.share), std::size_t{1})];
  if (error.ulps.is_zero()) return;
  tally.largest_error.offer({error.share, position});
  tally.largest_length.offer({error.length, position});
  tally.largest_ulps.offer({error.ulps, position});
  tally.largest_in_u.offer({error.in_u, position});
}

void count_feature(FeatureTally& tally, std::uint64_t position, const ContactJudgement& judgement) {
  ++tally.judged;
  if (*judgement.feature_is_right) return;
  ++tally.wrong;
  tally.first_wrong.offer({true, position});
  const double error = judgement.feature_error.value_or(0);
  if (std::isinf(error)) ++tally.unnamed;
  else if (error != 0) tally.largest_error.offer({error, position});
}

void count_pushed(PushTally& tally, std::uint64_t position, const Pushed& pushed) {
  ++tally.judged;
  tally.nowhere += pushed.is_nowhere;
  if (!pushed.left.is_zero()) tally.largest_left.offer({pushed.left, position});
  if (!pushed.is_flip) return;
  ++tally.flips;
  tally.first_flip.offer({true, position});
}

template <class OfPoints>
void count_error_of(OfPoints& tally, std::uint64_t position, const std::optional<double>& error) {
  if (!error) return;
  ++tally.judged;
  if (*error != 0) tally.largest_error.offer({*error, position});
}

}  // namespace

void count_contact(ContactTally& tally, std::uint64_t position, const ContactJudgement& judgement) {
  ++*tally.decided;
  if (judgement.missed) {
    count_tunnel(*tally.missed, position, *judgement.missed);
    return;
  }
  ++tally.answers;
  if (judgement.time) count_time(*tally.time, position, judgement);
  if (judgement.consistency) count_consistency(*tally.consistency, position, *judgement.consistency);
  if (judgement.separation) count_separation(*tally.separation, position, *judgement.separation);
  if (const auto& less = judgement.separation_less_margin) {
    auto& found = tally.separation->less_margin;
    if (!found) found.emplace();
    if (less->share != 0) {
      found->largest_error.offer({less->share, position});
      found->largest_length.offer({less->length, position});
    }
  }
  if (judgement.feature_is_right) count_feature(*tally.feature, position, judgement);
  if (judgement.normal_angle) {
    ++tally.normal->judged;
    tally.normal->largest_angle.offer({*judgement.normal_angle, position});
  }
  if (judgement.normal_length_error) {
    ++tally.normal->lengths;
    tally.normal->largest_length_error.offer({*judgement.normal_length_error, position});
  }
  if (judgement.pushed) count_pushed(*tally.pushed, position, *judgement.pushed);
  count_error_of(*tally.point, position, judgement.point_error);
  count_error_of(*tally.point_a, position, judgement.point_a_error);
  count_error_of(*tally.point_b, position, judgement.point_b_error);
  count_error_of(*tally.points, position, judgement.points_apart);
  const auto count_missing = [position](auto& part, bool is_missing) {
    if (!is_missing) return;
    ++part->none;
    part->first_none.offer({true, position});
  };
  count_missing(tally.separation, judgement.lacks_separation);
  count_missing(tally.feature, judgement.lacks_feature);
  count_missing(tally.normal, judgement.lacks_normal);
  count_missing(tally.pushed, judgement.lacks_push);
  for (auto* const points : {&tally.point, &tally.point_a, &tally.point_b})
    count_missing(*points, judgement.lacks_point);
}

void AnswerSet::add(std::uint64_t position) {
  // The mixing of splitmix64: each position has 64 bits of its own.
  std::uint64_t x = position + 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  mark ^= x ^ (x >> 31);
}
AnswerSet::Written AnswerSet::written() const { return mark == 0 ? Written() : Written(fmt::format("{:x}", mark)); }
void AnswerSet::take(const Written& written) {
  mark = 0;
  std::from_chars(written.data(), written.data() + written.size(), mark, 16);
}

void count_given(ContactTally& tally, std::uint64_t position, const Predicate& predicate, Verdict said,
                 std::span<const double> measures) {
  const bool says_contact = said == Verdict::contact;
  tally.separations += !says_contact;
  for_each_number(tally, [&](MeasureKind kind, auto& part) {
    if (!gives_measure(predicate, measures.size(), kind)) return;
    const auto is_number = [&](double x) {
      if (kind == MeasureKind::feature) return !std::isnan(x);  // an infinite one names no part, and is judged
      return std::isfinite(x) && (kind != MeasureKind::time || (x >= 0 && x <= 1));
    };
    for (std::size_t k = 0; k < measures.size(); ++k) {
      if (predicate.measures[k].kind == kind && !is_number(measures[k])) return;
    }
    GivenTally& given = part->given;
    ++(says_contact ? given.contacts : given.separations);
    (says_contact ? given.which_contacts : given.which_separations).add(position);
    if (kind == MeasureKind::separation)
      ++(says_contact ? tally.consistency->contacts : tally.consistency->separations);
  });
}

ContactTally given_contacts(ContactTally tally, const Predicate& predicate, std::size_t measure_count) {
  const auto gives = [&](MeasureKind kind) { return gives_measure(predicate, measure_count, kind); };
  const bool moves = is_of_motions(predicate), has_pair = gives(MeasureKind::point_a) && gives(MeasureKind::point_b);
  if (!moves) {
    tally.decided.reset();
    tally.missed.reset();
  }
  if (!gives(MeasureKind::time)) tally.time.reset();
  if (!gives(MeasureKind::separation)) {
    tally.consistency.reset();
    tally.separation.reset();
  }
  if (!gives(MeasureKind::feature)) tally.feature.reset();
  if (!gives(MeasureKind::normal)) tally.normal.reset();
  if (moves || !gives(MeasureKind::normal)) tally.pushed.reset();
  if (!gives(MeasureKind::point)) tally.point.reset();
  if (!gives(MeasureKind::point_a)) tally.point_a.reset();
  if (!gives(MeasureKind::point_b)) tally.point_b.reset();
  if (!has_pair) tally.points.reset();
  return tally;
}

}  // namespace axiscert

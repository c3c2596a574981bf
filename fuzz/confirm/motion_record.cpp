#include "fuzz/confirm/motion_record.h"

#include "exact/trait/oracles.h"
#include "fuzz/files/details.h"
#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

ErrorNumber error_number(const Decimal6& decimal) { return read_as<ErrorNumber>(json_of(decimal)); }

std::optional<ErrorNumber> depth_of(const std::optional<Tunnel>& tunnel) {
  return tunnel ? std::optional(error_number(tunnel->depth)) : std::nullopt;
}

PlaceNumbers place_numbers(const std::array<double, 3>& at) {
  return {SignedNumber{at[0]}, SignedNumber{at[1]}, SignedNumber{at[2]}};
}

}  // namespace

std::optional<MeasuresRecord> measures_of(const Predicate& predicate, const Examination& found) {
  const bool is_contact = found.answer.verdict == Verdict::contact && !found.measures.empty();
  if (!is_contact && !found.missed) return std::nullopt;
  MeasuresRecord record;
  for (std::size_t k = 0; is_contact && k < found.measures.size(); ++k) {
    record.given.put(predicate.measures[k].name) = format_number(found.measures[k]);
  }
  record.tunnel = depth_of(found.missed);
  if (!found.motion) return record;
  const MotionJudgement& motion = *found.motion;
  if (motion.tunnel) record.tunnel = depth_of(motion.tunnel);
  const bool is_off = motion.time == TimeVerdict::early || motion.time == TimeVerdict::late;
  record.time.emplace(motion.time);
  record.ulps.emplace(is_off ? std::optional(error_number(motion.ulps)) : std::nullopt);
  record.in_u.emplace(is_off ? std::optional(error_number(motion.in_u)) : std::nullopt);
  record.gap.emplace(motion.time == TimeVerdict::early ? std::optional(motion.gap) : std::nullopt);
  record.feature_is_right.emplace(motion.feature_is_right);
  record.normal_angle.emplace(motion.normal_angle);
  record.point_error.emplace(motion.point_error);
  return record;
}

template <class Real>
std::optional<FirstContactRecord> first_contact_of(const Oracles& oracles, const Truth& truth,
                                                   const Numbers<Real>& numbers) {
  if (truth.verdict == Verdict::invalid) return std::nullopt;
  Json details = Json::object();
  for (const Detail& detail : oracles.details(numbers)) details[std::string(detail.name)] = detail_json(detail);
  auto record = read_as<FirstContactRecord>(details);
  if (truth.verdict != Verdict::contact) return record;
  const ContactPlace place = oracles.motion_judge(numbers)->first();
  record.after_time = place.after_best;
  record.point = place_numbers(place.point);
  record.point_from_a = place_numbers(place.from_a);
  record.normal.emplace(place.normal ? std::optional(place_numbers(*place.normal)) : std::nullopt);
  return record;
}
template std::optional<FirstContactRecord> first_contact_of(const Oracles&, const Truth&, const Numbers<float>&);
template std::optional<FirstContactRecord> first_contact_of(const Oracles&, const Truth&, const Numbers<double>&);

}  // namespace axiscert

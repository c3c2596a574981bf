#include "fuzz/confirm/motion_record.h"

#include <algorithm>

#include "exact/trait/oracles.h"
#include "fuzz/confirm/record.h"
#include "fuzz/files/details.h"
#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

Json tunnels_json(const TunnelTally& tally) {
  return {{"through", tally.through}, {"deepest_tunnel", decimal_json(tally.deepest.best())}};
}

Json errors_json(const TimeErrors& errors) {
  Json powers = Json::object();
  for (std::size_t k = 0; k < ulp_powers; ++k) {
    if (errors.by_power[k] != 0) powers[std::to_string(k)] = errors.by_power[k];
  }
  return {{"largest_ulps", decimal_json(errors.largest_ulps.best())},
          {"largest_in_u", decimal_json(errors.largest_in_u.best())},
          {"by_power", std::move(powers)}};
}

Json times_json(const MotionTally& tally) {
  Json json = Json::object();
  for (const TimeVerdict verdict : enumerators<TimeVerdict>) {
    json[std::string(time_verdict_names[verdict])] = tally.times[verdict];
  }
  json["late_errors"] = errors_json(tally.late);
  json["late_tunnels"] = tunnels_json(tally.late_tunnels);
  json["early_errors"] = errors_json(tally.early);
  json["largest_gap"] = tally.largest_gap.best();
  return json;
}

// Whether the kernel gives the test's measure of that name, and so all before it.
bool gives(const Kernel& kernel, std::string_view measure) {
  const auto& all = kernel.test->measures;
  const auto found = std::find_if(all.begin(), all.end(), [&](const TestMeasure& one) { return one.name == measure; });
  return found - all.begin() < static_cast<std::ptrdiff_t>(kernel.measure_count);
}

Json tunnel_json(const std::optional<Tunnel>& tunnel) { return tunnel ? decimal_json(tunnel->depth) : Json(nullptr); }

}  // namespace

Json given_measures_json(const Kernel& kernel) {
  Json names = Json::array();
  for (std::size_t k = 0; k < kernel.measure_count; ++k) names.push_back(kernel.test->measures[k].name);
  return names;
}

Json policy_json(const MotionPolicy& policy) {
  return {{"start", start_policy_names[policy.start]},
          {"still", still_policy_names[policy.still]},
          {"sides", sides_policy_names[policy.sides]}};
}

Json motion_json(const MotionTally& tally, const Kernel& kernel) {
  Json json = {{"hits", tally.hits}, {"missed", tunnels_json(tally.missed_tunnels)}};
  const auto put = [&](const char* member, std::string_view last, Json&& judged) {
    json[member] = gives(kernel, last) ? std::move(judged) : Json(nullptr);
  };
  put("time", "time", times_json(tally));
  put("feature", "feature", {{"judged", tally.features}, {"wrong", tally.wrong_features}});
  put("normal", "normal_z", {{"judged", tally.normals}, {"largest_angle", tally.largest_angle.best()}});
  put("point", "point_z", {{"judged", tally.points}, {"largest_error", tally.largest_point_error.best()}});
  return json;
}

Json measures_json(const TestDescription& test, const Examination& found) {
  const bool is_contact = found.answer.verdict == Verdict::contact && !found.measures.empty();
  if (!is_contact && !found.missed) return nullptr;
  Json json = Json::object(), given = Json::object();
  for (std::size_t k = 0; is_contact && k < found.measures.size(); ++k) {
    given[std::string(test.measures[k].name)] = format_number(found.measures[k]);
  }
  json["given"] = std::move(given);
  json["tunnel"] = tunnel_json(found.missed);
  if (!found.motion) return json;
  const MotionJudgement& motion = *found.motion;
  if (motion.tunnel) json["tunnel"] = tunnel_json(motion.tunnel);
  const bool is_off = motion.time == TimeVerdict::early || motion.time == TimeVerdict::late;
  json["time"] = motion.time ? Json(time_verdict_names[*motion.time]) : Json(nullptr);
  json["ulps"] = is_off ? decimal_json(motion.ulps) : Json(nullptr);
  json["in_u"] = is_off ? decimal_json(motion.in_u) : Json(nullptr);
  json["gap"] = motion.time == TimeVerdict::early ? Json(motion.gap) : Json(nullptr);
  json["feature_is_right"] = motion.feature_is_right ? Json(*motion.feature_is_right) : Json(nullptr);
  json["normal_angle"] = motion.normal_angle ? Json(*motion.normal_angle) : Json(nullptr);
  json["point_error"] = motion.point_error ? Json(*motion.point_error) : Json(nullptr);
  return json;
}

template <class Real>
Json first_contact_json(const Oracles& oracles, const Truth& truth, const Numbers<Real>& numbers) {
  if (truth.verdict == Verdict::invalid) return nullptr;
  Json json = Json::object();
  for (const Detail& detail : oracles.details(numbers)) json[std::string(detail.name)] = detail_json(detail);
  if (truth.verdict != Verdict::contact) return json;
  const ContactPlace place = oracles.motion_judge(numbers)->first();
  json["after_time"] = place.after_best;
  json["point"] = place.point;
  json["point_from_a"] = place.from_a;
  json["normal"] = place.normal ? Json(*place.normal) : Json(nullptr);
  return json;
}
template Json first_contact_json(const Oracles&, const Truth&, const Numbers<float>&);
template Json first_contact_json(const Oracles&, const Truth&, const Numbers<double>&);

}  // namespace axiscert

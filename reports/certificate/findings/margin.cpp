#include "reports/certificate/findings/margin.h"

namespace axiscert {
namespace {

Json missed_json(const std::optional<MissedContact>& missed) {
  if (!missed) return nullptr;
  return {{"value", missed->value.text()},
          {"r", missed->radius},
          {"contact_from", missed->critical.empty() ? Json(nullptr) : Json(missed->critical)},
          {"family", missed->family},
          {"query", Json::parse(missed->query)}};
}

Json part_json(const MarginPart& part) {
  const auto value = [](const std::optional<MissedContact>& greatest) {
    return greatest ? Json(greatest->value.text()) : Json(nullptr);
  };
  return {{"queries", part.queries},
          {"contacts", part.contacts},
          {"without_verdict", part.without_verdict},
          {"missed", part.missed},
          {"hopeless", part.hopeless},
          {"tiny", part.tiny},
          {"unmeasured", part.unmeasured},
          {"factor", value(part.factor)},
          {"amount", value(part.amount)},
          {"phantoms_by_factor", part.phantoms_by_factor},
          {"phantoms_by_amount", part.phantoms_by_amount},
          {"still_missed_by_factor", part.still_missed_by_factor},
          {"still_missed_by_amount", part.still_missed_by_amount}};
}

Json answers_json(const ContactAnswers& answers) {
  return {{"asked", answers.asked()},
          {"missed", answers.missed},
          {"declined", answers.looked_at.undecided},
          {"invalid", answers.looked_at.invalid},
          {"unanswered", answers.looked_at.unanswered}};
}

}  // namespace

Json margin_json(const SafeMargin& margin) {
  Json decades = Json::array();
  for (const auto& [scene, part] : margin.parts) {
    Json entry = {{"degenerate", scene.is_degenerate}, {"decade", scene.decade}};
    entry.update(part_json(part));
    decades.push_back(entry);
  }
  return {{"precision", name(margin.precision)},
          {"queries", margin.queries},
          {"probed", margin.probed},
          {"found", margin.found},
          {"phantoms", margin.phantoms},
          {"contacts", {{"of_run", answers_json(margin.of_run)}, {"of_others", answers_json(margin.of_others)}}},
          {"factor", missed_json(margin.factor)},
          {"amount", missed_json(margin.amount)},
          {"hopeless", missed_json(margin.hopeless)},
          {"all", part_json(margin.total())},
          {"decades", decades}};
}

}  // namespace axiscert

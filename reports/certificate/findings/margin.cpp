#include "reports/certificate/findings/margin.h"

namespace axiscert {
namespace {

std::optional<MissedStatement> missed_statement(const std::optional<MissedContact>& missed) {
  if (!missed) return std::nullopt;
  MissedStatement said{
      missed->value.text(), missed->radius, std::nullopt, missed->family, {Json::parse(missed->query)}};
  if (!missed->critical.empty()) said.contact_from = missed->critical;
  return said;
}

MarginPartStatement part_statement(const MarginPart& part) {
  const auto value = [](const std::optional<MissedContact>& greatest) -> std::optional<TextNumber> {
    if (!greatest) return std::nullopt;
    return greatest->value.text();
  };
  return {part.queries,
          part.contacts,
          part.without_verdict,
          part.missed,
          part.hopeless,
          part.tiny,
          part.unmeasured,
          value(part.factor),
          value(part.amount),
          part.phantoms_by_factor,
          part.phantoms_by_amount,
          part.still_missed_by_factor,
          part.still_missed_by_amount};
}

ContactsStatement contacts_statement(const ContactAnswers& answers) {
  return {answers.asked(), answers.missed, answers.looked_at.undecided, answers.looked_at.invalid,
          answers.looked_at.unanswered};
}

}  // namespace

MarginStatement margin_statement(const SafeMargin& margin) {
  MarginStatement said{margin.precision,
                       margin.queries,
                       margin.probed,
                       margin.found,
                       margin.phantoms,
                       {contacts_statement(margin.of_run), contacts_statement(margin.of_others)},
                       missed_statement(margin.factor),
                       missed_statement(margin.amount),
                       missed_statement(margin.hopeless),
                       part_statement(margin.total()),
                       {}};
  for (const auto& [scene, part] : margin.parts)
    said.decades.push_back({part_statement(part), scene.is_degenerate, scene.decade});
  return said;
}

}  // namespace axiscert

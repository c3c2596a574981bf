#include "cli/running/check_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/text/number_text.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

std::string bits16(ComparisonBits bits) { return bit_string(bits, comparison_count); }
std::string bits7(ComparisonBits bits) { return bit_string(axes_of(bits), axis_count); }

Json exact_json(const Examination& found) {
  Json json = {{"verdict", name(found.truth.verdict)}, {"touching", found.truth.touching}};
  const auto& formula = found.truth.formula;
  json["squared_distance"] = nullptr;
  if (found.squared_distance) {
    const Rational& d = *found.squared_distance;
    json["squared_distance"] = d.get_num().get_str() + "/" + d.get_den().get_str();
  }
  json["comparisons"] = formula ? Json(bits16(formula->strict)) : Json(nullptr);
  json["axes"] = formula ? Json(bits7(formula->strict)) : Json(nullptr);
  json["ties"] = formula ? Json(bits16(formula->ties)) : Json(nullptr);
  return json;
}

Json computed_json(const Answer& answer) {
  Json json = {{"verdict", name(answer.verdict)}};
  json["comparisons"] = answer.bits ? Json(bits16(*answer.bits)) : Json(nullptr);
  json["axes"] = answer.bits ? Json(bits7(*answer.bits)) : Json(nullptr);
  return json;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json all = Json::array();
  for (const Finding& finding : findings) all.push_back({{"kind", name(finding.kind)}, {"detail", finding.detail}});
  return all;
}

// " (touching)", with the kernel's own convention where that is not contact.
std::string touching_text(const Truth& truth, const Kernel& kernel) {
  if (!truth.touching) return "";
  switch (kernel.touching) {
    case Touching::contact:
      return " (touching)";
    case Touching::separated:
      return fmt::format(" (touching, which {} calls separated)", kernel.id);
    case Touching::either:
      return fmt::format(" (touching, where {} may say either)", kernel.id);
  }
  return "";
}

}  // namespace

std::string check_text(const std::string& id, const Kernel& kernel, const Examination& found) {
  const bool answered = found.answer.verdict != Verdict::unanswered;
  std::string line =
      fmt::format("{}: exact {}{}, {} {}", id, name(found.truth.verdict), touching_text(found.truth, kernel), kernel.id,
                  answered ? name(found.answer.verdict) : "gave no answer");
  if (!found.within_limits) line += " (outside the limits that it declares)";
  if (found.depth) line += fmt::format(", wrong by {:.3g} of the scene", *found.depth);
  for (const Flip& flip : found.judgement.flips()) {
    line += fmt::format("; {} {}{} [{}]", name(*kernel.test, flip), flip_kind_names[flip.kind],
                        flip.level == Level::verdict ? ""
                        : flip.decisive              ? " decisive"
                                                     : " masked",
                        fmt::join(names(flip.links), " "));
  }
  for (const Finding& finding : found.findings) line += fmt::format("; {}: {}", name(finding.kind), finding.detail);
  return line;
}

Json check_json(const std::string& id, const Kernel& kernel, const Examination& found) {
  return {{"id", id},
          {"kernel", kernel.id},
          {"exact", exact_json(found)},
          {"computed", computed_json(found.answer)},
          {"within_limits", found.within_limits},
          {"findings", findings_json(found.findings)},
          {"flips", flips_json(*kernel.test, found.judgement)}};
}

std::string errors_text(const std::optional<SideErrors>& errors) {
  if (!errors) return "  no computed sides to measure";
  std::string text;
  const auto amount = [](const std::optional<Decimal6>& error) { return error ? error->text() : "none"; };
  for (std::size_t k = 0; k < comparison_count; ++k) {
    text += fmt::format("{}  {}: error {} u, relative {} u", k == 0 ? "" : "\n", comparisons[k].name,
                        amount(errors->absolute[k]), amount(errors->relative[k]));
  }
  return text;
}

Json errors_json(const std::optional<SideErrors>& errors) {
  if (!errors) return nullptr;
  Json all = Json::object();
  const auto amount = [](const std::optional<Decimal6>& error) { return error ? number_json(*error) : Json(nullptr); };
  for (std::size_t k = 0; k < comparison_count; ++k) {
    all[std::string(comparisons[k].name)] = {{"absolute_u", amount(errors->absolute[k])},
                                             {"relative_u", amount(errors->relative[k])}};
  }
  return all;
}

}  // namespace axiscert

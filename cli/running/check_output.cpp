#include "cli/running/check_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "fuzz/confirm/motion_record.h"
#include "fuzz/files/details.h"
#include "fuzz/text/number_text.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

Json bits_json(const TestDescription& test, const std::optional<ComparisonBits>& bits) {
  return bits ? Json(bit_string(*bits, test.comparisons.size())) : Json(nullptr);
}
Json axes_json(const TestDescription& test, const std::optional<ComparisonBits>& bits) {
  return bits ? Json(bit_string(clauses_of(test, *bits), test.clauses.size())) : Json(nullptr);
}

// "time 0.25, features vertex_a edge_ab": those that the query has, numbers in decimal.
std::string details_text(const std::vector<Detail>& details) {
  std::vector<std::string> texts;
  const auto add = [&](const Detail& detail, const auto& value) {
    texts.push_back(fmt::format("{} {}", detail.name, value));
  };
  for (const Detail& detail : details) {
    if (const double* number = std::get_if<double>(&detail.value)) add(detail, *number);
    if (const auto* word = std::get_if<std::string_view>(&detail.value)) add(detail, *word);
    if (const auto* names = std::get_if<std::vector<std::string_view>>(&detail.value)) {
      add(detail, fmt::format("{}", fmt::join(*names, " ")));
    }
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

Json exact_json(const TestDescription& test, const Checked& found) {
  Json json = {{"verdict", name(found.truth.verdict)}, {"touching", found.truth.touching}};
  if (!found.why_invalid.empty()) json["reason"] = found.why_invalid;
  if (oracles_of(test).has_squared_distance()) json["squared_distance"] = nullptr;
  if (found.squared_distance) {
    const Rational& d = *found.squared_distance;
    json["squared_distance"] = d.get_num().get_str() + "/" + d.get_den().get_str();
  }
  for (const Detail& detail : found.details) json[std::string(detail.name)] = detail_json(detail);
  json["comparisons"] = bits_json(test, found.exact);
  json["axes"] = axes_json(test, found.exact);
  json["ties"] = bits_json(test, found.ties);
  return json;
}

Json computed_json(const TestDescription& test, const Answer& answer) {
  return {{"verdict", name(answer.verdict)},
          {"comparisons", bits_json(test, answer.bits)},
          {"axes", axes_json(test, answer.bits)}};
}

Json findings_json(const std::vector<Finding>& findings) {
  Json all = Json::array();
  for (const Finding& finding : findings) all.push_back({{"kind", name(finding.kind)}, {"detail", finding.detail}});
  return all;
}

// "touching", with the kernel's own convention where that is not contact.
std::string touching_text(const Kernel& kernel) {
  switch (kernel.touching) {
    case Touching::contact:
      return "touching";
    case Touching::separated:
      return fmt::format("touching, which {} calls separated", kernel.id);
    case Touching::either:
      return fmt::format("touching, where {} may say either", kernel.id);
  }
  return "";
}

// " (touching; time 0.25, features vertex_a edge_ab)": what there is to say besides; the details of a motion are of its
// contact.
std::string remarks(const Checked& found, const Kernel& kernel) {
  std::vector<std::string> all;
  if (found.truth.touching) all.push_back(touching_text(kernel));
  if (!found.why_invalid.empty()) all.push_back(found.why_invalid);
  if (found.truth.verdict == Verdict::contact || kernel.test->measures.empty()) {
    if (std::string text = details_text(found.details); !text.empty()) all.push_back(std::move(text));
  }
  return all.empty() ? "" : fmt::format(" ({})", fmt::join(all, "; "));
}

// "late by 2.5 ulps, tunnel 1e-07": how the time of a right contact is wrong.
std::string time_text(const MotionJudgement& motion) {
  if (!motion.time) return "";
  switch (*motion.time) {
    case TimeVerdict::none:
      return "no time is given";
    case TimeVerdict::invalid:
      return "no time in [0, 1]";
    case TimeVerdict::early:
      return fmt::format("early by {} ulps, {} u", motion.ulps.text(), motion.in_u.text());
    case TimeVerdict::best:
      return "the best time";
    case TimeVerdict::late:
      return fmt::format("late by {} ulps, {} u, tunnel {}", motion.ulps.text(), motion.in_u.text(),
                         motion.tunnel->depth.text());
  }
  return "";
}

// " (time 0.25, feature 3, ...; late by 2.5 ulps, ...)": beside a contact that is right, and of a missed one its
// tunnel.
std::string measures_text(const TestDescription& test, const Examination& found) {
  if (found.missed) return fmt::format(" (tunnel {})", found.missed->depth.text());
  if (!found.motion || found.measures.empty()) return "";
  std::vector<std::string> given, wrong;
  for (std::size_t k = 0; k < found.measures.size(); ++k) {
    if (!std::isnan(found.measures[k])) given.push_back(fmt::format("{} {}", test.measures[k].name, found.measures[k]));
  }
  const MotionJudgement& motion = *found.motion;
  wrong.push_back(time_text(motion));
  if (motion.feature_is_right == false) wrong.emplace_back("a feature that is not touched first");
  if (motion.normal_angle) wrong.push_back(fmt::format("normal off by {:.3g} radians", *motion.normal_angle));
  if (motion.point_error) wrong.push_back(fmt::format("point off by {:.3g} of the scene", *motion.point_error));
  return fmt::format(" ({}; {})", fmt::join(given, ", "), fmt::join(wrong, ", "));
}

// Why the line says nothing about right and wrong.
std::string_view standing_text(std::string_view standing) {
  if (standing == "declined") return " (it declines)";
  if (standing == "undeclared_decline") return " (a fault: it does not declare that it may decline)";
  if (standing == "called_invalid") return " (a fault: the query is valid)";
  if (standing == "unanswered") return " (a fault: the query is valid)";
  if (standing == "outside_limits") return " (outside the limits that it declares)";
  return "";
}

}  // namespace

std::string_view standing_of(const Kernel& kernel, Verdict exact, bool is_within_limits, Verdict computed) {
  if (exact == Verdict::invalid) return "no_query";
  if (!is_within_limits) return "outside_limits";
  switch (computed) {
    case Verdict::contact:
    case Verdict::separated:
      return "decided";
    case Verdict::undecided:
      return kernel.may_decline ? "declined" : "undeclared_decline";
    case Verdict::invalid:
      return "called_invalid";
    case Verdict::unanswered:
      break;
  }
  return "unanswered";
}

Checked checked_of(const TestDescription& test, const Examination& found, std::vector<Detail> details) {
  Checked checked{found.truth,    found.squared_distance, {},          {},
                  found.answer,   found.judgement,        found.depth, found.is_promised,
                  found.findings, std::move(details)};
  if (!test.measures.empty()) checked.measures = json_of(measures_of(test, found));
  checked.measures_text = measures_text(test, found);
  if (found.exact) {
    checked.exact = found.exact->holds;
    checked.ties = found.exact->ties;
  }
  return checked;
}

std::string check_text(const std::string& id, const Kernel& kernel, const Checked& found) {
  const bool answered = found.answer.verdict != Verdict::unanswered;
  std::string line =
      fmt::format("{}: exact {}{}, {} {}{}", id, name(found.truth.verdict), remarks(found, kernel), kernel.id,
                  answered ? name(found.answer.verdict) : "gave no answer", found.measures_text);
  line += standing_text(standing_of(kernel, found));
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

Json check_json(const std::string& id, const Kernel& kernel, const Checked& found) {
  const TestDescription& test = *kernel.test;
  Json json = {{"id", id},
               {"kernel", kernel.id},
               {"standing", standing_of(kernel, found)},
               {"exact", exact_json(test, found)},
               {"computed", computed_json(test, found.answer)},
               {"within_limits", found.within_limits},
               {"findings", findings_json(found.findings)},
               {"flips", json_of(flips_of(test, found.judgement))}};
  if (!test.measures.empty()) json["computed"]["measures"] = found.measures;
  if (const std::string_view name = written_name(test); !name.empty()) json["test"] = name;
  return json;
}

std::string errors_text(const TestDescription& test, const std::optional<SideErrors>& errors) {
  if (!errors) return "  no computed sides to measure";
  std::string text;
  const auto amount = [](const std::optional<Decimal6>& error) { return error ? error->text() : "none"; };
  for (std::size_t k = 0; k < test.comparisons.size(); ++k) {
    text += fmt::format("{}  {}: error {} u, relative {} u", k == 0 ? "" : "\n", test.comparisons[k].name,
                        amount(errors->absolute[k]), amount(errors->relative[k]));
  }
  return text;
}

Json errors_json(const TestDescription& test, const std::optional<SideErrors>& errors) {
  if (!errors) return nullptr;
  Json all = Json::object();
  for (std::size_t k = 0; k < test.comparisons.size(); ++k) {
    all[std::string(test.comparisons[k].name)] = {{"absolute_u", json_of(errors->absolute[k])},
                                                  {"relative_u", json_of(errors->relative[k])}};
  }
  return all;
}

}  // namespace axiscert

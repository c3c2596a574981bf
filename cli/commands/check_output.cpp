#include "cli/commands/check_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fuzz/confirm/witness.h"
#include "fuzz/files/query_object.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

std::optional<BitText> bits_line(const Predicate& predicate, const std::optional<ComparisonBits>& bits) {
  return bits ? std::optional(BitText(bit_string(*bits, predicate.comparisons.size()))) : std::nullopt;
}
std::optional<BitText> axes_line(const Predicate& predicate, const std::optional<ComparisonBits>& bits) {
  return bits ? std::optional(BitText(bit_string(clauses_of(predicate, *bits), predicate.clauses.size())))
              : std::nullopt;
}

// "deciding_axes b1 a0b2, defect 1.5": those that the query has, numbers in decimal; facts say more of theirs.
std::string details_text(const CheckResult& found) {
  std::vector<std::string> texts;
  const auto add = [&](const Detail& detail, const auto& value) {
    texts.push_back(fmt::format("{} {}", detail.name, value));
  };
  for (const Detail& detail : found.details) {
    const auto is_it = [&](const ExactFact& fact) { return fact.name == detail.name; };
    if (std::any_of(found.facts.begin(), found.facts.end(), is_it)) continue;
    if (const double* number = std::get_if<double>(&detail.value)) add(detail, *number);
    if (const auto* word = std::get_if<std::string_view>(&detail.value)) add(detail, *word);
    if (const auto* names = std::get_if<std::vector<std::string_view>>(&detail.value)) {
      add(detail, fmt::format("{}", fmt::join(*names, " ")));
    }
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

Json numbers_json(const std::vector<std::string>& texts) {
  if (texts.empty()) return nullptr;
  if (texts.size() == 1) return texts.front();
  return texts;
}
ExactFactLine fact_line(const ExactFact& fact, int digits) {
  ExactFactLine line;
  std::vector<std::string> decimals, exactly;
  for (const ExactValue& number : fact.numbers) {
    decimals.push_back(decimal_text(number, digits));
    exactly.push_back(exact_text(number));
  }
  line.value = fact.names.empty() ? numbers_json(decimals) : Json(fact.names);
  line.exact = numbers_json(exactly);
  if (!fact.note.empty()) line.note = std::string(fact.note);
  return line;
}

ExactAnswersLine exact_line(const Predicate& predicate, const CheckResult& found) {
  ExactAnswersLine line{.verdict = found.truth.verdict,
                        .touching = found.truth.touching,
                        .reason = {},
                        .squared_distance = {},
                        .details = {},
                        .facts = {},
                        .comparisons = bits_line(predicate, found.exact),
                        .axes = axes_line(predicate, found.exact),
                        .ties = bits_line(predicate, found.ties)};
  if (!found.why_invalid.empty()) line.reason = found.why_invalid;
  if (oracles_of(predicate).has_squared_distance()) line.squared_distance.emplace();
  if (found.squared_distance) {
    const Rational& d = *found.squared_distance;
    line.squared_distance = d.get_num().get_str() + "/" + d.get_den().get_str();
  }
  for (const Detail& detail : found.details) line.details.put(detail.name) = detail_json(detail);
  for (const ExactFact& fact : found.facts) line.facts.put(fact.name) = fact_line(fact, found.digits);
  return line;
}

// The texts that a number has in `text_of`, with commas between the coordinates of a place.
template <class TextOf>
std::string numbers_text(const ExactFact& fact, TextOf&& text_of) {
  std::vector<std::string> texts;
  for (const ExactValue& number : fact.numbers) texts.push_back(text_of(number));
  return texts.size() == 1 ? texts.front() : fmt::format("({})", fmt::join(texts, ", "));
}

// "depth 0.25 of the scene", "normal (0, 0, 1) (not the only one)".
std::string fact_text(const ExactFact& fact, int digits, bool is_exact) {
  std::string text(fact.name);
  if (!fact.names.empty()) text += fmt::format(" {}", fmt::join(fact.names, " "));
  if (!fact.numbers.empty()) {
    text += " " + numbers_text(fact, [&](const ExactValue& x) { return decimal_text(x, digits); });
    if (is_exact) text += " = " + numbers_text(fact, [](const ExactValue& x) { return exact_text(x); });
  }
  if (!fact.unit.empty()) text += fmt::format(" {}", fact.unit);
  if (!fact.note.empty()) text += fmt::format(" ({})", fact.note);
  return text;
}

// "touching", with the kernel's own convention where that is not contact.
std::string touching_text(const Kernel& kernel) {
  switch (kernel.touching) {
    case TouchingPolicy::contact:
      return "touching";
    case TouchingPolicy::separated:
      return fmt::format("touching, which {} calls separated", kernel.id);
    case TouchingPolicy::either:
      return fmt::format("touching, where {} may say either", kernel.id);
  }
  return "";
}

// " (touching; deciding_axes b1 a0b2)": what there is to say besides; the details of a motion are of its contact.
std::string remarks(const CheckResult& found, const Kernel& kernel) {
  std::vector<std::string> all;
  if (found.truth.touching) all.push_back(touching_text(kernel));
  if (!found.why_invalid.empty()) all.push_back(found.why_invalid);
  if (found.truth.verdict == Verdict::contact || !is_of_motions(*kernel.predicate)) {
    if (std::string text = details_text(found); !text.empty()) all.push_back(std::move(text));
  }
  return all.empty() ? "" : fmt::format(" ({})", fmt::join(all, "; "));
}

// "late by 2.5 ulps, tunnel 1e-07": how the time of a right contact is wrong.
std::string time_text(const ContactJudgement& motion) {
  switch (*motion.time) {
    case TimeVerdict::none:
      return "no time is given";
    case TimeVerdict::invalid:
      return "no time in [0, 1]";
    case TimeVerdict::early:
      return fmt::format("early by {}", time_error_text(motion.ulps, motion.share, motion.length));
    case TimeVerdict::best:
      return "the best time";
    case TimeVerdict::late:
      return fmt::format("late by {}, tunnel {}", time_error_text(motion.ulps, motion.share, motion.length),
                         motion.tunnel->depth.text());
  }
  return "";
}

// A normal is rounded: what is less of its length is not worth a word.
constexpr double visible_length_error = 1e-6;

// "separation off by 1.2e-08 of the scene, 3 ulps": how the numbers beside any verdict are wrong.
void add_body_texts(std::vector<std::string>& wrong, const ContactJudgement& contact) {
  if (contact.consistency && *contact.consistency != Consistency::consistent)
    wrong.emplace_back(consistency_words[*contact.consistency]);
  if (contact.separation) {
    const SeparationError& error = *contact.separation;
    wrong.push_back(error.ulps.is_zero() ? "the exact separation"
                                         : fmt::format("separation off by {:.3g} of the scene, length {:.3g}, {} ulps",
                                                       error.share, error.length, error.ulps.text()));
  }
  if (contact.pushed && contact.pushed->is_flip)
    wrong.push_back(fmt::format("a normal to the other side, {} of the depth is left", contact.pushed->left.text()));
  else if (contact.pushed && !contact.pushed->left.is_zero())
    wrong.push_back(fmt::format("{} of the depth is left along the normal", contact.pushed->left.text()));
}

// " (time 0.25, feature 3, ...; late by 2.5 ulps, ...)": the numbers beside the verdict, and of a missed contact of
// motions its tunnel.
std::string measures_text(const Predicate& predicate, const Examination& found) {
  if (!found.contact) return "";
  const ContactJudgement& contact = *found.contact;
  if (contact.missed) return fmt::format(" (tunnel {})", contact.missed->depth.text());
  std::vector<std::string> given, wrong;
  for (std::size_t k = 0; k < found.measures.size(); ++k) {
    if (!std::isnan(found.measures[k]))
      given.push_back(fmt::format("{} {}", predicate.measures[k].name, found.measures[k]));
  }
  if (found.measures.empty()) return "";
  if (contact.time) wrong.push_back(time_text(contact));
  add_body_texts(wrong, contact);
  if (contact.feature_error && std::isinf(*contact.feature_error)) wrong.emplace_back("a feature that there is not");
  else if (contact.feature_is_right == false) {
    wrong.push_back(fmt::format("a wrong feature, off by {:.3g} of the scene", contact.feature_error.value_or(0)));
  }
  if (contact.normal_angle) wrong.push_back(fmt::format("normal off by {:.3g} radians", *contact.normal_angle));
  if (contact.normal_length_error && *contact.normal_length_error > visible_length_error)
    wrong.push_back(fmt::format("its length off by {:.3g}", *contact.normal_length_error));
  const auto add_error = [&](const std::optional<double>& error, const char* what) {
    if (error) wrong.push_back(fmt::format("{} off by {:.3g} of the scene", what, *error));
  };
  add_error(contact.point_error, "point");
  add_error(contact.point_a_error, "first point");
  add_error(contact.point_b_error, "second point");
  add_error(contact.points_apart, "distance of the points");
  if (given.empty()) given.emplace_back("no number");
  return fmt::format(" ({}{}{})", fmt::join(given, ", "), wrong.empty() ? "" : "; ", fmt::join(wrong, ", "));
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

CheckResult checked_of(const Predicate& predicate, const Examination& found, std::vector<Detail> details) {
  CheckResult checked{found.truth,    found.squared_distance, {},          {},
                      found.answer,   found.judgement,        found.depth, found.is_promised,
                      found.findings, std::move(details)};
  checked.measures = measures_of(predicate, found);
  checked.measures_text = measures_text(predicate, found);
  if (found.exact) {
    checked.exact = found.exact->holds;
    checked.ties = found.exact->ties;
  }
  return checked;
}

std::string check_text(const std::string& id, const Kernel& kernel, const CheckResult& found) {
  const bool answered = found.answer.verdict != Verdict::unanswered;
  std::string line =
      fmt::format("{}: exact {}{}, {} {}{}", id, name(found.truth.verdict), remarks(found, kernel), kernel.id,
                  answered ? name(found.answer.verdict) : "gave no answer", found.measures_text);
  line += standing_text(standing_of(kernel, found));
  if (found.depth) line += fmt::format(", wrong by {:.3g} of the scene", *found.depth);
  for (const Flip& flip : found.judgement.flips()) {
    line += fmt::format("; {} {}{} [{}]", name(*kernel.predicate, flip), flip_kind_names[flip.kind],
                        flip.level == Level::verdict ? ""
                        : flip.decisive              ? " decisive"
                                                     : " masked",
                        fmt::join(names(flip.links), " "));
  }
  for (const Finding& finding : found.findings) line += fmt::format("; {}: {}", name(finding.kind), finding.detail);
  return line;
}

std::string facts_text(const CheckResult& found, bool is_exact) {
  std::vector<std::string> texts;
  for (const ExactFact& fact : found.facts) texts.push_back(fact_text(fact, found.digits, is_exact));
  if (texts.empty()) return "";
  return fmt::format("  rounded to {} digits: {}", found.digits, fmt::join(texts, "; "));
}

CheckLine check_line(const std::string& id, const Kernel& kernel, const CheckResult& found) {
  const Predicate& predicate = *kernel.predicate;
  CheckLine line;
  line.id = id;
  line.kernel = kernel.id;
  line.standing = standing_of(kernel, found);
  line.exact = exact_line(predicate, found);
  line.computed = {
      found.answer.verdict, bits_line(predicate, found.answer.bits), axes_line(predicate, found.answer.bits), {}};
  if (says_contacts(kernel)) line.computed.measures.emplace(found.measures);
  line.within_limits = found.within_limits;
  line.findings = finding_rows(found.findings);
  line.flips = flips_of(predicate, found.judgement);
  if (const std::string_view name = written_name(predicate); !name.empty()) line.predicate = name;
  return line;
}

std::string errors_text(const Predicate& predicate, const std::optional<SideErrors>& errors) {
  if (!errors) return "  no computed sides to measure";
  std::string text;
  const auto amount = [](const std::optional<Decimal6>& error) {
    return error ? error->text() + " u" : "not measured";
  };
  for (std::size_t k = 0; k < predicate.comparisons.size(); ++k) {
    text += fmt::format("{}  {}: error {}, relative {}", k == 0 ? "" : "\n", predicate.comparisons[k].name,
                        amount(errors->absolute[k]), amount(errors->relative[k]));
  }
  return text;
}

std::optional<NamedValues<ComparisonErrorLine>> errors_line(const Predicate& predicate,
                                                            const std::optional<SideErrors>& errors) {
  if (!errors) return std::nullopt;
  NamedValues<ComparisonErrorLine> all;
  for (std::size_t k = 0; k < predicate.comparisons.size(); ++k)
    all.put(predicate.comparisons[k].name) = {errors->absolute[k], errors->relative[k]};
  return all;
}

}  // namespace axiscert

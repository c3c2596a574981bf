// report.sarif: SARIF 2.1.0, for code scanning. One result for each cell with something wrong in it: kernel, precision,
// family, and the verdict or comparison. Its fingerprint is that of the cell, and so the same in every run, whatever
// the count. Its location is where the kernel is written, by run.json, with the line of the cell's deepest witness in
// witnesses.jsonl as a related one; where the source is not known, that line is the location. A cell that is worse than
// the ratchet accepts has one more result, an error, at the same location; one that the ratchet accepts is a note with
// a suppression. A level that is not met has an error for each family where none of these stands for it.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "fuzz/text/json_form.h"
#include "reports/comparison/cells.h"
#include "reports/wording/depths.h"
#include "reports/wording/summary.h"
#include "reports/formats/format.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/evidence.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

// The kinds of cells by what they count: verdicts, a comparison, the times of a predicate of motions, or another
// number.
enum class CountOf { verdict, comparison, time, number };

struct Rule {
  const char *id, *member;  // `member`: the cell's member that the rule is about
  CountOf of;
  const char *level, *sentence;
};

// A wrong comparison under a right verdict is a note, since it lost no contact; so is a time before the contact.
constexpr Rule rules[] = {
    {"missed-contact", "false_separation", CountOf::verdict, "error",
     "The kernel says separated where there is contact."},
    {"phantom-contact", "false_contact", CountOf::verdict, "warning", "The kernel says contact where there is none."},
    {"undecided", "undecided", CountOf::verdict, "note", "The kernel declines to answer a valid query."},
    {"invalid-answer", "invalid", CountOf::verdict, "error", "The kernel calls a valid query invalid."},
    {"no-answer", "unanswered", CountOf::verdict, "error", "The kernel gave no answer to a valid query."},
    {"false-separation", "false_separation", CountOf::comparison, "note",
     "A comparison holds that does not hold in exact arithmetic, by the kernel's own formulae."},
    {"missed-separation", "missed_separation", CountOf::comparison, "note",
     "A comparison does not hold that holds in exact arithmetic, by the kernel's own formulae."},
    {"tolerance", "tolerance_failures", CountOf::comparison, "error",
     "A comparison's error is above the tolerance given for it."},
    {"not-finite", "range_events", CountOf::comparison, "note", "A computed side of a comparison is not finite."},
    {"late-time", "late", CountOf::time, "warning",
     "The time is later than the first contact: what moves so far goes in."},
    {"early-time", "early", CountOf::time, "note", "The time is earlier than the best number of the precision."},
    {"no-time", "none", CountOf::time, "error", "A contact that is found has no time, though the kernel gives times."},
    {"wrong-feature", "wrong", CountOf::number, "warning", "The feature is not one that is nearest."},
    {"flip", "flips", CountOf::number, "error", "The normal goes to the other side."},
    {"contact-apart", "positive", CountOf::number, "warning", "A contact has a separation above 0."},
    {"separated-inside", "negative", CountOf::number, "warning", "An answer `separated` has a separation below 0."},
    {"contradiction", "missing", CountOf::number, "note", "An answer has some numbers, and not this other one."},
    {"no-number", "none", CountOf::number, "note", "An answer lacks this number, though there is one."},
    {"invalid-time", "invalid", CountOf::time, "error", "The time is not a number from 0 to 1."},
};
constexpr Rule ratchet_rule = {
    "worse-than-accepted", "", CountOf::verdict, "error",
    "A figure is worse than the ratchet accepts, its waiver has expired, or it was not checked."};
constexpr Rule unchecked_rule = {"requirement-not-checked", "", CountOf::verdict, "error",
                                 "A level of --require, or a kernel, was not checked, which does not pass."};
constexpr Rule unmet_rule = {"requirement-not-met", "", CountOf::verdict, "error",
                             "A level of --require is not met, which no result about a count says."};
constexpr Rule finding_rule = {"plug-in", "", CountOf::verdict, "error", "A plug-in violated the rules for kernels."};
constexpr const Rule* other_rules[] = {&finding_rule, &ratchet_rule, &unchecked_rule, &unmet_rule};

// Its place among all rules: those of counts, then the others.
std::size_t rule_index(const Rule& rule) {
  const auto other = std::ranges::find(other_rules, &rule);
  return other == std::end(other_rules) ? static_cast<std::size_t>(&rule - rules)
                                        : std::size(rules) + static_cast<std::size_t>(other - other_rules);
}

CountOf counted_in(const Cell& cell) {
  if (cell.place == "verdict") return CountOf::verdict;
  if (cell.place == "time") return CountOf::time;
  return cell.is_of_contacts() ? CountOf::number : CountOf::comparison;
}

const Rule* rule_of(const Cell& cell) {
  if (cell.kind == Cell::Kind::finding) return &finding_rule;
  for (const Rule& rule : rules) {
    if (cell.member == rule.member && rule.of == counted_in(cell)) return &rule;
  }
  return nullptr;  // a maximum or a tunnel: the ratchet's and the levels'
}

Json rule_json(const Rule& rule) {
  return {{"id", rule.id},
          {"shortDescription", {{"text", rule.sentence}}},
          {"defaultConfiguration", {{"level", rule.level}}}};
}

class Log {
 public:
  explicit Log(const Run& run)
      : record_(run.record),
        held_(run.ratchet),
        cells_(cells_of(run.record)),
        witnesses_(run.record),
        outcomes_(outcomes_of(run.record)) {
    if (run.info) sources_ = run.info->sources;
    if (held_) {
      for (const RatchetFailure& failure : held_->failures) failed_.insert(failure.fingerprint);
      for (const WaivedCells& cells : held_->held) {
        for (const std::string& fingerprint : cells.fingerprints) waivers_[fingerprint] = &cells.waiver;
      }
    }
    failures_ = failures_of(outcomes_);
    has_suppressions_ =
        held_ || std::any_of(outcomes_.begin(), outcomes_.end(), [](const auto& o) { return o.is_allowed; });
  }

  Json json() const {
    Json driver = {{"name", "axiscert"}, {"version", json_of(record_.plan.axiscert)}, {"rules", Json::array()}};
    for (const Rule& rule : rules) driver["rules"].push_back(rule_json(rule));
    for (const Rule* rule : other_rules) driver["rules"].push_back(rule_json(*rule));
    Json results = Json::array();
    std::vector<const Cell*> errors;
    for (const Cell& cell : cells_) {
      const Rule* const rule = rule_of(cell);
      if (rule == nullptr || cell.is_zero()) continue;
      results.push_back(result(cell, *rule));
      if (results.back()["level"] == "error") errors.push_back(&cell);
    }
    if (held_) {
      for (const RatchetFailure& failure : held_->failures) results.push_back(ratchet_result(failure));
    }
    for (const LevelOutcome& outcome : outcomes_) {
      const bool is_beside_families = std::ranges::any_of(outcome.failures, &Failure::is_beside_families);
      if (outcome.state == LevelState::not_checked || is_beside_families) results.push_back(unchecked_result(outcome));
      for (const auto& [family, failures] : without_error(outcome, errors))
        results.push_back(unmet_result(outcome, family, failures));
    }
    for (const std::string& sentence : unjudged(record_)) results.push_back(unjudged_result(sentence));
    const Json invocation = {{"executionSuccessful", record_.complete}};
    const Json run = {{"tool", {{"driver", driver}}},
                      {"invocations", Json::array({invocation})},
                      {"columnKind", "unicodeCodePoints"},
                      {"results", results}};
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
            {"version", "2.1.0"},
            {"runs", Json::array({run})}};
  }

 private:
  Json result(const Cell& cell, const Rule& rule) const {
    const auto witnesses = witnesses_.of(cell);
    const WitnessRecord* const worst = deepest(witnesses);
    const std::string where = fmt::format("{} {} on {}, {}", cell.kernel, cell.precision, cell.family, cell.place);
    const char* const among = rule.of == CountOf::time     ? "contacts found"
                              : rule.of == CountOf::number ? "answers"
                                                           : "queries";
    std::string message = fmt::format("{}: {} of {} {}. {}", where, thousands(cell.count()), thousands(cell.of.trials),
                                      among, rule.sentence);
    if (cell.kind == Cell::Kind::finding) message = finding_message(cell);
    if (const std::string depths = depths_of(cell); !depths.empty())
      message += fmt::format(" By depth, of the scene: {}.", depths);
    if (worst != nullptr) message += " Reproduced by: " + replay_command(*worst, record_.plan);
    const bool is_unmet = std::any_of(failures_.begin(), failures_.end(), [&](const Failure& failure) {
      return cell.place == "verdict" && failure.kernel == cell.kernel && failure.precision == cell.precision &&
             failure.family == cell.family;
    });
    const Waiver* const waiver = is_unmet ? nullptr : waiver_of(cell);
    Json json = {{"ruleId", rule.id},
                 {"ruleIndex", rule_index(rule)},
                 {"level", is_unmet            ? "error"
                           : waiver != nullptr ? "note"
                                               : rule.level},
                 {"message", {{"text", message_text(message)}}},
                 {"partialFingerprints", {{"axiscertCell/v1", fingerprint(cell.key())}}}};
    put_places(json, cell.kernel, cell.key(), worst);
    put_suppressions(json, waiver);
    return json;
  }

  // The waiver under which the ratchet accepts a cell, with the depth of its wrong verdicts; null where it does not.
  const Waiver* waiver_of(const Cell& cell) const {
    const auto found = waivers_.find(fingerprint(cell.key()));
    if (found == waivers_.end()) return nullptr;
    Cell deepest = cell;
    deepest.member = "deepest_" + cell.member;
    return failed_.contains(fingerprint(deepest.key())) ? nullptr : found->second;
  }

  // SARIF wants suppressions in all results of a run or in none.
  void put_suppressions(Json& result, const Waiver* waiver) const {
    if (!has_suppressions_) return;
    Json& all = result["suppressions"] = Json::array();
    if (waiver == nullptr) return;
    all.push_back({{"kind", "external"},
                   {"status", "accepted"},
                   {"justification", fmt::format("accepted in {}{} by {}: {}", held_->file,
                                                 waiver->expiry == "never" ? "" : " until " + waiver->expiry,
                                                 waiver->owner, waiver->reason)}});
  }

  // The depths of a cell's wrong verdicts; empty for any other cell.
  std::string depths_of(const Cell& cell) const {
    if (cell.place != "verdict" || (cell.member != "false_separation" && cell.member != "false_contact")) return "";
    for (const KernelRecord& kernel : record_.kernels) {
      if (kernel.id != cell.kernel || name(kernel.precision) != cell.precision) continue;
      const std::optional<DepthTally>& depths = kernel.families.at(cell.family).verdict.depths;
      if (!depths) return "";
      return depths_text(cell.member == "false_separation" ? depths->false_separation : depths->false_contact);
    }
    return "";
  }

  // A result of one of other_rules, with its fingerprint of that kind.
  Json other_result(const Rule& rule, const std::string& text, const char* kind, const std::string& print,
                    const std::string& kernel, const Json& key, const WitnessRecord* witness = nullptr) const {
    Json json = {{"ruleId", rule.id},
                 {"ruleIndex", rule_index(rule)},
                 {"level", rule.level},
                 {"message", {{"text", message_text(text)}}},
                 {"partialFingerprints", {{kind, print}}}};
    put_places(json, kernel, key, witness);
    put_suppressions(json, nullptr);
    return json;
  }

  Json ratchet_result(const RatchetFailure& failure) const {
    Json key = Json::array({failure.kernel, failure.precision, failure.family, failure.cell});
    const WitnessRecord* worst = nullptr;
    for (const Cell& cell : cells_) {
      if (cell.key_of(cell.kernel) != key) continue;
      worst = deepest(witnesses_.of(cell));
      key = cell.key();
      break;
    }
    return other_result(ratchet_rule, failure.text, "axiscertRatchet/v1", failure.fingerprint, failure.kernel, key,
                        worst);
  }

  // "KERNEL [PRECISION]: NOT JUDGED: ..."
  Json unjudged_result(const std::string& sentence) const {
    const std::string who = sentence.substr(0, sentence.find(": NOT JUDGED"));
    std::string kernel = who;
    for (const std::string& one : record_.plan.kernels) {
      if (who == one || who.starts_with(one + " ")) kernel = one;
    }
    const Json key = Json::array({kernel, "", "", "judged"});
    return other_result(unchecked_rule, sentence, "axiscertJudged/v1", fingerprint(Json::array({who, "judged"})),
                        kernel, key);
  }

  Json unchecked_result(const LevelOutcome& outcome) const {
    const Json key = Json::array({outcome.kernel, outcome.precision, "", "requirement." + outcome.asked.text});
    Json json =
        other_result(unchecked_rule, outcome.text(), "axiscertRequirement/v1", fingerprint(key), outcome.kernel, key);
    if (outcome.is_allowed) {
      json["level"] = "note";
      json["suppressions"].push_back({{"kind", "external"}, {"justification", "--allow-unchecked"}});
    }
    return json;
  }

  // The failures of a level, by family, that no error about a cell stands for: a size is none of the cells that have
  // rules.
  using ByFamily = std::map<std::string, std::vector<const Failure*>>;
  ByFamily without_error(const LevelOutcome& outcome, const std::vector<const Cell*>& errors) const {
    const GateLevel& level = level_of(outcome.asked);
    const bool is_of_verdicts = level.allowed != nullptr || level.is_about_causes;
    ByFamily found;
    for (const Failure& failure : outcome.failures) {
      const auto stands_for_it = [&](const Cell* cell) {
        if (cell->kernel != failure.kernel || cell->precision != failure.precision || cell->family != failure.family)
          return false;
        if (is_of_verdicts && cell->place == "verdict") return true;
        const auto witnesses = witnesses_.of(*cell);
        const auto is_its = [&](const WitnessRecord* witness) { return witness->id == failure.witness; };
        return cell->count() == failure.count && (failure.witness.empty() || std::ranges::any_of(witnesses, is_its));
      };
      if (!failure.is_beside_families && std::ranges::none_of(errors, stands_for_it))
        found[failure.family].push_back(&failure);
    }
    return found;
  }

  Json unmet_result(const LevelOutcome& outcome, const std::string& family,
                    const std::vector<const Failure*>& failures) const {
    std::string kernel = outcome.kernel, message = outcome.asked.text + " is not met.";
    for (const Cell& cell : cells_) {
      if (cell.kernel == outcome.kernel) kernel = cell.identity;
    }
    const WitnessRecord* witness = nullptr;
    for (const Failure* failure : failures) {
      message += " " + failure->text() + ".";
      for (const WitnessRecord& one : record_.witnesses) {
        if (witness == nullptr && one.id == failure->witness) witness = &one;
      }
    }
    if (witness != nullptr) message += " Reproduced by: " + replay_command(*witness, record_.plan);
    const Json key = Json::array({kernel, outcome.precision, family, "requirement." + outcome.asked.text});
    return other_result(unmet_rule, message, "axiscertRequirement/v1", fingerprint(key), outcome.kernel, key, witness);
  }

  // Where the kernel is written and, as a related place, the line of the witness in witnesses.jsonl. Without a source
  // the latter is the place; without a witness, the first line.
  void put_places(Json& result, const std::string& kernel, const Json& key, const WitnessRecord* witness) const {
    const std::ptrdiff_t line = witness == nullptr ? 1 : witness - record_.witnesses.data() + 1;
    const auto part = [&](std::size_t i) { return key[i].get<std::string>(); };
    const auto place = [](const std::string& file, const Json& at) -> Json {
      return {{"physicalLocation", {{"artifactLocation", {{"uri", file}}}, {"region", {{"startLine", at}}}}}};
    };
    Json shown = place("witnesses.jsonl", line);
    if (const SourcePlace* source = sources_.find(kernel)) {
      if (witness != nullptr) {
        shown["message"] = {{"text", message_text("The deepest witness, " + witness->id)}};
        result["relatedLocations"] = Json::array({shown});
      }
      shown = place(uri_of(source->file), source->line);
    }
    shown["logicalLocations"] = Json::array(
        {{{"name", part(3)}, {"fullyQualifiedName", fmt::format("{}/{}/{}/{}", part(0), part(1), part(2), part(3))}}});
    result["locations"] = Json::array({std::move(shown)});
  }

  // A path as a URI reference, relative to the repository where the path is relative: bytes that a URI cannot have are
  // percent-encoded. "./" keeps a colon in a first name from ending a scheme.
  static std::string uri_of(const std::string& path) {
    std::string uri;
    for (const char c : path) {
      const bool is_unreserved = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                                 std::string_view("-._~/:@!$&'()*+,;=").find(c) != std::string_view::npos;
      if (is_unreserved) uri += c;
      else uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    if (path.starts_with('/')) return "file://" + uri;
    return uri.find(':') < uri.find('/') ? "./" + uri : uri;
  }

  // SARIF reads [text](target) in a message as a link and {0} as a placeholder: neither is meant here.
  static std::string message_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
      if (c == '\\' || c == '[' || c == ']') escaped += '\\';
      escaped += c;
      if (c == '{' || c == '}') escaped += c;
    }
    return escaped;
  }

  std::string finding_message(const Cell& cell) const {
    for (const FindingRecord& finding : record_.findings) {
      const std::string_view precision = finding.precision ? name(*finding.precision) : "";
      if (finding.kernel == cell.kernel && precision == cell.precision && finding.family.value_or("") == cell.family &&
          name(finding.kind) == cell.member)
        return finding_text(finding);
    }
    return cell.member;
  }

  static const WitnessRecord* deepest(const std::vector<const WitnessRecord*>& witnesses) {
    const auto found =
        std::max_element(witnesses.begin(), witnesses.end(),
                         [](const WitnessRecord* x, const WitnessRecord* y) { return x->depth < y->depth; });
    return found == witnesses.end() ? nullptr : *found;
  }

  const Record& record_;
  const std::optional<RatchetOutcome>& held_;
  std::vector<Cell> cells_;
  WitnessesByCell witnesses_;
  std::vector<LevelOutcome> outcomes_;
  SourcePlaces sources_;                          // by the kernel's id
  std::set<std::string> failed_;                  // fingerprints
  std::map<std::string, const Waiver*> waivers_;  // by fingerprint of what they accept
  std::vector<Failure> failures_;
  bool has_suppressions_ = false;  // whether the ratchet or --allow-unchecked accepts anything of the run
};

std::string render_sarif(const Run& run) { return Log(run).json().dump(1) + "\n"; }

}  // namespace

extern const Format sarif_format = {"report.sarif", "for code scanning", render_sarif};

}  // namespace axiscert

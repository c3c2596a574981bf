// report.sarif: SARIF 2.1.0, for code scanning. One result for each cell with something wrong in it: kernel, precision,
// family, and the verdict or comparison. Its fingerprint is that of the cell, and so the same in every run, whatever
// the count; its location is the line of the cell's deepest witness in witnesses.jsonl. A cell that is worse than the
// ratchet accepts has one more result, an error, at the same location.
#include <fmt/format.h>

#include <algorithm>

#include "reports/comparison/cells.h"
#include "reports/wording/depths.h"
#include "reports/wording/finding.h"
#include "reports/formats/format.h"
#include "reports/wording/reproduce.h"
#include "reports/gates/requirement.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

struct Rule {
  const char *id, *member;  // `member`: the cell's member that the rule is about
  bool of_verdict;
  const char *level, *sentence;
};

// A wrong comparison under a right verdict is a note: no contact was lost by it.
constexpr Rule rules[] = {
    {"missed-contact", "false_separation", true, "error", "The kernel says separated where there is contact."},
    {"phantom-contact", "false_contact", true, "warning", "The kernel says contact where there is none."},
    {"undecided", "undecided", true, "note", "The kernel declines to answer a valid query."},
    {"invalid-answer", "invalid", true, "error", "The kernel calls a valid query invalid."},
    {"no-answer", "unanswered", true, "error", "The kernel gave no answer to a valid query."},
    {"false-separation", "false_separation", false, "note",
     "A comparison holds that does not hold in exact arithmetic, by the kernel's own formulae."},
    {"missed-separation", "missed_separation", false, "note",
     "A comparison does not hold that holds in exact arithmetic, by the kernel's own formulae."},
    {"tolerance", "tolerance_failures", false, "error", "A comparison's error is above the tolerance given for it."},
};
constexpr Rule ratchet_rule = {
    "worse-than-accepted", "", false, "error",
    "A figure is worse than the ratchet accepts, its waiver has expired, or it was not checked."};
constexpr Rule unchecked_rule = {"requirement-not-checked", "", false, "error",
                                 "A level of --require was not checked, which does not pass."};
constexpr Rule finding_rule = {"plug-in", "", false, "error", "A plug-in violated the rules for kernels."};

const Rule* rule_of(const Cell& cell) {
  if (cell.kind == Cell::Kind::finding) return &finding_rule;
  for (const Rule& rule : rules) {
    if (cell.member == rule.member && rule.of_verdict == (cell.place == "verdict")) return &rule;
  }
  return nullptr;  // a maximum
}

Json rule_json(const Rule& rule) {
  return {{"id", rule.id},
          {"shortDescription", {{"text", rule.sentence}}},
          {"defaultConfiguration", {{"level", rule.level}}}};
}

class Log {
 public:
  explicit Log(const Run& run) : record_(run.record), held_(run.ratchet), outcomes_(outcomes_of(run.record)) {
    failures_ = failures_of(outcomes_);
  }

  Json json() const {
    Json driver = {{"name", "axiscert"}, {"version", record_["plan"]["axiscert"]}, {"rules", Json::array()}};
    for (const Rule& rule : rules) driver["rules"].push_back(rule_json(rule));
    for (const Rule* rule : {&finding_rule, &ratchet_rule, &unchecked_rule}) driver["rules"].push_back(rule_json(*rule));
    Json results = Json::array();
    for (const Cell& cell : cells_of(record_)) {
      const Rule* rule = rule_of(cell);
      if (rule != nullptr && !cell.is_zero()) results.push_back(result(cell, *rule));
    }
    for (const Json& failure : held_.is_null() ? Json::array() : held_["failures"])
      results.push_back(ratchet_result(failure));
    for (const LevelOutcome& outcome : outcomes_) {
      if (outcome.state == LevelState::not_checked) results.push_back(unchecked_result(outcome));
    }
    const Json invocation = {{"executionSuccessful", record_["complete"]}};
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
    const auto witnesses = witnesses_of(record_, cell);
    const Json* const worst = deepest(witnesses);
    const std::string where = fmt::format("{} {} on {}, {}", cell.kernel, cell.precision, cell.family, cell.place);
    std::string message = fmt::format("{}: {} of {} queries. {}", where, thousands(cell.count()),
                                      thousands(cell.of.trials), rule.sentence);
    if (cell.kind == Cell::Kind::finding) message = finding_message(cell);
    if (const std::string depths = depths_of(cell); !depths.empty())
      message += fmt::format(" By depth, of the scene: {}.", depths);
    if (worst != nullptr) message += " Reproduced by: " + replay_command(*worst, record_["plan"]);
    const bool is_unmet = std::any_of(failures_.begin(), failures_.end(), [&](const Failure& failure) {
      return cell.place == "verdict" && failure.kernel == cell.kernel && failure.precision == cell.precision &&
             failure.family == cell.family;
    });
    return {{"ruleId", rule.id},
            {"ruleIndex", &rule == &finding_rule ? std::size(rules) : static_cast<std::size_t>(&rule - rules)},
            {"level", is_unmet ? "error" : rule.level},
            {"message", {{"text", message_text(message)}}},
            {"locations", Json::array({place_of(cell.key(), worst)})},
            {"partialFingerprints", {{"axiscertCell/v1", fingerprint(cell.key())}}}};
  }

  // The depths of a cell's wrong verdicts; empty for any other cell.
  std::string depths_of(const Cell& cell) const {
    if (cell.place != "verdict" || (cell.member != "false_separation" && cell.member != "false_contact")) return "";
    for (const Json& kernel : record_["kernels"]) {
      if (kernel["id"] != cell.kernel || kernel["precision"] != cell.precision) continue;
      const Json& family = kernel["families"][cell.family];
      return has_depths(family) ? depths_text(family["verdict"]["depths"][cell.member]) : "";
    }
    return "";
  }

  Json ratchet_result(const Json& failure) const {
    const Json key = Json::array({failure["kernel"], failure["precision"], failure["family"], failure["cell"]});
    const Json* worst = nullptr;
    for (const Cell& cell : cells_of(record_)) {
      if (cell.key() == key) worst = deepest(witnesses_of(record_, cell));
    }
    return {{"ruleId", ratchet_rule.id},
            {"ruleIndex", std::size(rules) + 1},
            {"level", ratchet_rule.level},
            {"message", {{"text", message_text(failure["text"])}}},
            {"locations", Json::array({place_of(key, worst)})},
            {"partialFingerprints", {{"axiscertRatchet/v1", failure["fingerprint"]}}}};
  }

  Json unchecked_result(const LevelOutcome& outcome) const {
    const Json key = Json::array({outcome.kernel, outcome.precision, "", "requirement." + outcome.asked.text});
    Json result = {{"ruleId", unchecked_rule.id},
                   {"ruleIndex", std::size(rules) + 2},
                   {"level", outcome.is_allowed ? "note" : unchecked_rule.level},
                   {"message", {{"text", message_text(outcome.text())}}},
                   {"locations", Json::array({place_of(key, nullptr)})},
                   {"partialFingerprints", {{"axiscertRequirement/v1", fingerprint(key)}}}};
    if (outcome.is_allowed)
      result["suppressions"] = Json::array({{{"kind", "external"}, {"justification", "--allow-unchecked"}}});
    return result;
  }

  // The line of the witness in witnesses.jsonl, or the first line where there is no witness; and the cell's name.
  Json place_of(const Json& key, const Json* witness) const {
    std::size_t line = 1;
    for (const Json& other : record_["witnesses"]) {
      if (witness == nullptr || &other == witness) break;
      ++line;
    }
    const auto part = [&](std::size_t i) { return key[i].get<std::string>(); };
    return {
        {"physicalLocation", {{"artifactLocation", {{"uri", "witnesses.jsonl"}}}, {"region", {{"startLine", line}}}}},
        {"logicalLocations",
         Json::array({{{"name", part(3)},
                       {"fullyQualifiedName", fmt::format("{}/{}/{}/{}", part(0), part(1), part(2), part(3))}}})}};
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
    for (const Json& finding : record_["findings"]) {
      const auto is = [&](const char* member, const std::string& text) {
        return finding[member].is_null() ? text.empty() : finding[member] == text;
      };
      if (is("kernel", cell.kernel) && is("precision", cell.precision) && is("family", cell.family) &&
          is("kind", cell.member))
        return finding_text(finding);
    }
    return cell.member;
  }

  static const Json* deepest(const std::vector<const Json*>& witnesses) {
    const auto depth = [](const Json* w) { return (*w)["depth"].is_null() ? -1.0 : (*w)["depth"].get<double>(); };
    const auto found = std::max_element(witnesses.begin(), witnesses.end(),
                                        [&](const Json* x, const Json* y) { return depth(x) < depth(y); });
    return found == witnesses.end() ? nullptr : *found;
  }

  const Json &record_, &held_;
  std::vector<LevelOutcome> outcomes_;
  std::vector<Failure> failures_;
};

std::string render_sarif(const Run& run) { return Log(run).json().dump(1) + "\n"; }

}  // namespace

extern const Format sarif_format = {"report.sarif", "for code scanning", render_sarif};

}  // namespace axiscert

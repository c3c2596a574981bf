#include "reports/certificate/findings/asked_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t shown_of_key = 16;  // digits

std::uint64_t asked_count(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

}  // namespace

std::string made_sentence(const Json& predicate) {
  const Json& asked = predicate["asked"];
  const std::string how = asked["effort"] == "replies" ? "from a program's replies"
                                                       : fmt::format("with effort {}", plain_text(asked["effort"]));
  return fmt::format("made by axiscert {} {}, seed {}", plain_text(predicate["materials"]["axiscert"]["version"]), how,
                     asked["seed"].dump());
}

std::string signer_sentence(const Json& predicate) {
  if (predicate["signed_by"].is_null()) return "not signed";
  return fmt::format("signed by the key {}", plain_text(predicate["signed_by"]).substr(0, shown_of_key));
}

std::string asked_sentence(const Json& predicate) {
  const Json& asked = predicate["asked"];
  const std::vector<std::string> precisions = predicate["kernel"]["precisions"];
  return fmt::format("{} queries of {} families and files, in {}", thousands(asked_count(asked, "queries")),
                     asked["families"].size(), fmt::join(precisions, " and "));
}

std::string looked_sentence(const Json& predicate) {
  const Json &asked = predicate["asked"], &out = asked["left_out"];
  std::vector<std::string> parts;
  const auto add = [&](const char* member, const char* what) {
    if (asked_count(out, member) != 0) parts.push_back(fmt::format("{} {}", thousands(asked_count(out, member)), what));
  };
  add("outside_limits", "outside its limits");
  add("touching", "touching, of which it promises nothing");
  const auto without_verdict =
      no_verdict_words({asked_count(out, "declined"), asked_count(out, "invalid"), asked_count(out, "unanswered")});
  parts.insert(parts.end(), without_verdict.begin(), without_verdict.end());
  std::string text = fmt::format("{} looked at; left out: {}", thousands(asked_count(asked, "looked_at")),
                                 parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")));
  if (asked_count(out, "no_query") != 0)
    text += fmt::format("; {} are no query", thousands(asked_count(out, "no_query")));
  return text;
}

std::string no_answers_sentence(const Json& predicate) {
  std::vector<std::string> precisions;
  for (const Json& row : predicate["comparison"]) {
    if (row["kernel"] == predicate["kernel"]["id"] && row["looked_at"] == 0) precisions.push_back(row["precision"]);
  }
  if (precisions.empty() && predicate["asked"]["looked_at"] != 0) return "";
  if (precisions.empty()) return "it gave no answer that counts";
  return fmt::format("it gave no answer that counts in {}", fmt::join(precisions, " and "));
}

std::string state_of_level(const Json& predicate, const std::string& level) {
  std::string state = "NOT CHECKED";
  bool is_first = true;
  for (const Json& entry : predicate["levels"]) {
    if (entry["level"] != level) continue;
    if (entry["state"] == "not met") return "not met";
    if (is_first || entry["state"] == "NOT CHECKED") state = entry["state"];
    is_first = false;
  }
  return state;
}

std::string claim_of_level(const Json& predicate, const std::string& level) {
  // Each of two precisions that cover different families is named.
  std::vector<std::pair<std::string, std::string>> claims;  // and their precisions
  for (const Json& entry : predicate["levels"]) {
    if (entry["level"] != level) continue;
    const std::string claim = entry["claim"], precision = plain_text(entry["precision"]);
    if (claims.empty() || claims.front().first != claim) claims.emplace_back(claim, precision);
  }
  if (claims.empty()) return level;
  if (claims.size() == 1) return claims.front().first;
  std::string text;
  for (const auto& [claim, precision] : claims)
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", claim, precision);
  return text;
}

std::string decided_text(const Json& predicate) {
  const Json &asked = predicate["asked"], &out = asked["left_out"];
  const std::uint64_t decided = asked_count(asked, "looked_at"), declined = asked_count(out, "declined");
  std::string text;
  if (declined != 0) text = fmt::format(" of the {} that it decides", share_rounded_down(decided, decided + declined));
  if (asked_count(out, "touching") != 0) text += " but for touching";
  return text;
}

std::vector<std::string> levels_with(const Json& predicate, const std::string& state) {
  std::vector<std::string> names, claims;
  for (const Json& entry : predicate["levels"]) {
    const std::string level = entry["level"];
    if (std::ranges::find(names, level) != names.end() || state_of_level(predicate, level) != state) continue;
    names.push_back(level);
    claims.push_back(state == "met" ? claim_of_level(predicate, level) : level);
  }
  return claims;
}

}  // namespace axiscert

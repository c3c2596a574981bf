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

}  // namespace

std::string made_sentence(const CertificatePredicate& predicate) {
  const AskedStatement& asked = predicate.asked;
  const std::string how =
      asked.effort == "replies" ? "from a program's replies" : fmt::format("with effort {}", asked.effort);
  return fmt::format("made by axiscert {} {}, seed {}", predicate.materials.axiscert.version, how, asked.seed.value);
}

std::string signer_sentence(const CertificatePredicate& predicate) {
  if (!predicate.signed_by) return "not signed";
  return fmt::format("signed by the key {}", predicate.signed_by->substr(0, shown_of_key));
}

std::string asked_sentence(const CertificatePredicate& predicate) {
  std::vector<std::string_view> precisions;
  for (const Precision precision : predicate.kernel.precisions) precisions.push_back(name(precision));
  return fmt::format("{} queries of {} families and files, in {}", thousands(predicate.asked.queries),
                     predicate.asked.families.size(), fmt::join(precisions, " and "));
}

std::string looked_sentence(const CertificatePredicate& predicate) {
  const LeftOutStatement& out = predicate.asked.left_out;
  std::vector<std::string> parts;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count != 0) parts.push_back(fmt::format("{} {}", thousands(count), what));
  };
  add(out.outside_limits, "outside its limits");
  add(out.touching, "touching, of which it promises nothing");
  const auto without_verdict = no_verdict_words({out.declined, out.invalid, out.unanswered});
  parts.insert(parts.end(), without_verdict.begin(), without_verdict.end());
  std::string text = fmt::format("{} looked at; left out: {}", thousands(predicate.asked.looked_at),
                                 parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")));
  if (out.no_query != 0) text += fmt::format("; {} are no query", thousands(out.no_query));
  return text;
}

std::string no_answers_sentence(const CertificatePredicate& predicate) {
  std::vector<std::string_view> precisions;
  for (const ComparisonStatement& row : predicate.comparison) {
    if (row.kernel == predicate.kernel.id && row.looked_at == 0) precisions.push_back(name(row.precision));
  }
  if (precisions.empty() && predicate.asked.looked_at != 0) return "";
  if (precisions.empty()) return "it gave no answer that counts";
  return fmt::format("it gave no answer that counts in {}", fmt::join(precisions, " and "));
}

LevelState state_of_level(const CertificatePredicate& predicate, const std::string& level) {
  LevelState state = LevelState::not_checked;
  bool is_first = true;
  for (const LevelStatement& entry : predicate.levels) {
    if (entry.level != level) continue;
    if (entry.state == LevelState::not_met) return entry.state;
    if (is_first || entry.state == LevelState::not_checked) state = entry.state;
    is_first = false;
  }
  return state;
}

std::string claim_of_level(const CertificatePredicate& predicate, const std::string& level) {
  // Each of two precisions that cover different families is named.
  std::vector<std::pair<std::string, std::string>> claims;  // and their precisions
  for (const LevelStatement& entry : predicate.levels) {
    if (entry.level != level) continue;
    if (claims.empty() || claims.front().first != entry.claim)
      claims.emplace_back(entry.claim, entry.precision ? name(*entry.precision) : "-");
  }
  if (claims.empty()) return level;
  if (claims.size() == 1) return claims.front().first;
  std::string text;
  for (const auto& [claim, precision] : claims)
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", claim, precision);
  return text;
}

std::string decided_text(const CertificatePredicate& predicate) {
  const LeftOutStatement& out = predicate.asked.left_out;
  const std::uint64_t decided = predicate.asked.looked_at, declined = out.declined;
  std::string text;
  if (declined != 0) text = fmt::format(" of the {} that it decides", share_rounded_down(decided, decided + declined));
  if (out.touching != 0) text += " but for touching";
  return text;
}

std::vector<std::string> levels_with(const CertificatePredicate& predicate, LevelState state) {
  std::vector<std::string> names, claims;
  for (const LevelStatement& entry : predicate.levels) {
    const std::string& level = entry.level;
    if (std::ranges::find(names, level) != names.end() || state_of_level(predicate, level) != state) continue;
    names.push_back(level);
    claims.push_back(state == LevelState::met ? claim_of_level(predicate, level) : level);
  }
  return claims;
}

}  // namespace axiscert

#include "reports/certificate/derived/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fuzz/text/number_text.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// The member of an object, where it is one of that kind; else null, and the schema will say so.
Json* part_at(Json& object, const char* member, Json::value_t kind) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(member);
  return found == object.end() || found->type() != kind ? nullptr : &*found;
}

}  // namespace

std::map<ImageKind, ImageChangesRecord> invariance_again(Json invariance, const std::string& where) {
  for (auto& [kind, changes] : invariance.items()) {
    Json* const wrong = part_at(changes, "wrong", Json::value_t::object);
    if (wrong == nullptr) continue;
    for (const char* side : {"where_small", "where_large"}) {
      Json* const sizes = part_at(*wrong, side, Json::value_t::object);
      Json* const compared = sizes == nullptr ? nullptr : part_at(*sizes, "compared", Json::value_t::array);
      if (compared == nullptr) continue;
      for (Json& size : *compared) {
        for (const char* bound : {"least", "greatest"}) {
          if (Json* const text = part_at(size, bound, Json::value_t::string)) *text = number_of_text(*text, where);
        }
      }
    }
  }
  auto read = form_again<std::map<ImageKind, ImageChangesRecord>>(invariance, where);
  for (const auto& [kind, changes] : read) {
    const bool has_units = changes.range && *changes.range;
    if (has_units != changes.wrong.has_value())
      throw NotValid(fmt::format("{}: {} has no counts of wrong verdicts in other units of length", where, name(kind)));
    if (changes.changed > changes.images)
      throw NotValid(fmt::format("{}: more images changed than were compared", where));
  }
  return read;
}

KernelRecord entry_again(Json entry, const std::string& id, const std::string& where) {
  if (entry["id"] == portable_id) entry["id"] = id;
  for (const char* part : {"limits", "critical_radius"}) {
    Json* const numbers = part_at(entry, part, Json::value_t::object);
    if (numbers == nullptr) continue;
    for (auto& [member, value] : numbers->items()) {
      if (value.is_string()) value = number_of_text(value, fmt::format("{}: {}", where, member));
    }
  }
  entry["families"] = Json::object();
  return form_again<KernelRecord>(entry, where);
}

namespace {

void require_counts(const StretchCounts& counts, std::uint64_t queries, const std::string& where) {
  const TruthCounts& truth = counts.truth;
  const VerdictTally& verdict = counts.verdict;
  const auto require = [&](bool holds, const char* what) {
    if (!holds) throw NotValid(fmt::format("{}: {}", where, what));
  };
  if (counts.trials != queries) {
    throw NotValid(
        fmt::format("{}: {} queries, and its plan has {} there", where, thousands(counts.trials), thousands(queries)));
  }
  require(truth.separated <= queries && truth.contact <= queries &&
              truth.separated + truth.contact + truth.invalid == queries,
          "separated, contact and invalid are not all queries");
  require(truth.touching <= truth.contact, "more queries touch than are contacts");
  const OutsideTally outside = verdict.outside_limits.value_or(OutsideTally());
  const std::uint64_t valid = truth.separated + truth.contact;
  require(outside.trials <= valid, "more queries are outside its limits than are valid");
  require(outside.contact <= std::min(truth.contact, outside.trials) && outside.touching <= outside.contact &&
              outside.trials - outside.contact <= truth.separated,
          "the queries outside its limits are more than those of their truth");
  std::uint64_t answered = outside.trials;
  for (const std::uint64_t count :
       {verdict.false_separation, verdict.false_contact, verdict.undecided, verdict.invalid, verdict.unanswered}) {
    require(count <= queries, "more wrong or missing answers than queries");
    answered += count;
  }
  require(answered <= valid, "more wrong or missing answers than valid queries");
  require(verdict.undecided_contact <= verdict.undecided && verdict.undecided_touching <= verdict.undecided_contact,
          "more declined contacts than declined queries");
  // A touching query that a kernel means to call separated is a contact, and a false one.
  require(verdict.false_separation + verdict.undecided_contact <= truth.contact, "more missed contacts than contacts");
  require(verdict.touching_flips <= verdict.false_separation + verdict.false_contact,
          "more wrong verdicts on touching queries than wrong verdicts");
  require((verdict.false_separation != 0 || verdict.deepest_false_separation.best() == 0) &&
              (verdict.false_contact != 0 || verdict.deepest_false_contact.best() == 0),
          "a depth of wrong verdicts, and none is wrong");
}

}  // namespace

StretchCounts counts_again(const Json& whole, std::uint64_t queries, const std::string& where) {
  StretchCounts none;
  none.verdict.depths.reset();
  none.verdict.engine.reset();
  if (whole.contains("motion")) none.motion.emplace();
  Json counts = json_of(none);
  counts.update(whole, true);
  const Json& verdict = counts["verdict"];
  if (verdict["deepest"] != std::max(verdict["deepest_false_separation"], verdict["deepest_false_contact"]))
    throw NotValid(where + ": the deepest wrong verdict is another than those of the two kinds");
  auto read = form_again<StretchCounts>(counts, where);
  require_counts(read, queries, where);
  return read;
}

}  // namespace axiscert

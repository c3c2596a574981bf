#include "reports/certificate/derived/stated.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fuzz/text/number_text.h"
#include "reports/certificate/derived/counts.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::uint64_t number_at(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

// The member of an object, where it is one of that kind; else null, and the schema will say so.
Json* part_at(Json& object, const char* member, Json::value_t kind) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(member);
  return found == object.end() || found->type() != kind ? nullptr : &*found;
}

}  // namespace

Json invariance_again(Json invariance, const std::string& where) {
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
  require_form<std::map<ImageKind, ImageChangesRecord>>(invariance, where);
  for (const auto& [kind, changes] : invariance.items()) {
    const bool has_units = changes.contains("range") && !changes["range"].is_null();
    if (has_units != changes.contains("wrong"))
      throw NotValid(fmt::format("{}: {} has no counts of wrong verdicts in other units of length", where, kind));
    if (number_at(changes, "changed") > number_at(changes, "images"))
      throw NotValid(fmt::format("{}: more images changed than were compared", where));
  }
  return invariance;
}

Json entry_again(Json entry, const Json& id, const std::string& where) {
  if (entry["id"] == portable_id) entry["id"] = id;
  for (const char* part : {"limits", "critical_radius"}) {
    Json* const numbers = part_at(entry, part, Json::value_t::object);
    if (numbers == nullptr) continue;
    for (auto& [member, value] : numbers->items()) {
      if (value.is_string()) value = number_of_text(value, fmt::format("{}: {}", where, member));
    }
  }
  entry["families"] = Json::object();
  require_form<KernelRecord>(entry, where);
  return entry;
}

void require_counts(const Json& counts, std::uint64_t queries, const std::string& where) {
  const Json &truth = counts["truth"], &verdict = counts["verdict"], &outside = verdict["outside_limits"];
  const auto require = [&](bool holds, const char* what) {
    if (!holds) throw NotValid(fmt::format("{}: {}", where, what));
  };
  if (number_at(counts, "trials") != queries) {
    throw NotValid(fmt::format("{}: {} queries, and its plan has {} there", where,
                               thousands(number_at(counts, "trials")), thousands(queries)));
  }
  const std::uint64_t separated = number_at(truth, "separated"), contact = number_at(truth, "contact");
  require(separated <= queries && contact <= queries && separated + contact + number_at(truth, "invalid") == queries,
          "separated, contact and invalid are not all queries");
  require(number_at(truth, "touching") <= contact, "more queries touch than are contacts");
  const std::uint64_t valid = separated + contact,
                      outside_trials = outside.is_null() ? 0 : number_at(outside, "trials");
  require(outside_trials <= valid, "more queries are outside its limits than are valid");
  if (!outside.is_null()) {
    require(number_at(outside, "contact") <= std::min(contact, outside_trials) &&
                number_at(outside, "touching") <= number_at(outside, "contact") &&
                outside_trials - number_at(outside, "contact") <= separated,
            "the queries outside its limits are more than those of their truth");
  }
  std::uint64_t answered = outside_trials;
  for (const char* member : {"false_separation", "false_contact", "undecided", "invalid", "unanswered"}) {
    require(number_at(verdict, member) <= queries, "more wrong or missing answers than queries");
    answered += number_at(verdict, member);
  }
  require(answered <= valid, "more wrong or missing answers than valid queries");
  require(number_at(verdict, "undecided_contact") <= number_at(verdict, "undecided") &&
              number_at(verdict, "undecided_touching") <= number_at(verdict, "undecided_contact"),
          "more declined contacts than declined queries");
  // A touching query that a kernel means to call separated is a contact, and a false one.
  require(number_at(verdict, "false_separation") + number_at(verdict, "undecided_contact") <= contact,
          "more missed contacts than contacts");
  require(number_at(verdict, "touching_flips") <=
              number_at(verdict, "false_separation") + number_at(verdict, "false_contact"),
          "more wrong verdicts on touching queries than wrong verdicts");
  for (const auto& [depth, count] :
       {std::pair("deepest_false_separation", "false_separation"), {"deepest_false_contact", "false_contact"}}) {
    require(number_at(verdict, count) != 0 || verdict[depth] == 0, "a depth of wrong verdicts, and none is wrong");
  }
  require(verdict["deepest"] == std::max(verdict["deepest_false_separation"].get<double>(),
                                         verdict["deepest_false_contact"].get<double>()),
          "the deepest wrong verdict is another than those of the two kinds");
}

}  // namespace axiscert

#include "reports/certificate/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <regex>
#include <span>

#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/sha256.h"
#include "reports/certificate/canonical.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

bool is_nothing(const Json& value) {
  if (value.is_structured()) return value.empty();
  return value.is_null() || (value.is_number() && value == 0);
}

// An error beyond binary64, whose six digits a record has as text: "1.5e+620".
bool is_beyond_binary64(const std::string& text) {
  static const std::regex form("[0-9](\\.[0-9]{1,5})?e\\+[0-9]{3,6}");
  double value = 0;
  return std::regex_match(text, form) &&
         std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc::result_out_of_range;
}

}  // namespace

void RadiiAdded::merge(CriticalRadiusRecord& into, const CriticalRadiusRecord& from) {
  using Of = CriticalRadiusRecord;
  for (const auto count :
       {&Of::sampled, &Of::unbounded, &Of::unanswered, &Of::undecided, &Of::invalid, &Of::early, &Of::late})
    into.*count += from.*count;
  into.largest_ulps = std::max(into.largest_ulps, from.largest_ulps);
}

Json sparse_counts(const Json& counts) {
  if (counts.is_number_float()) return fmt::format("{}", counts.get<double>());
  if (!counts.is_object()) return counts;
  Json sparse = Json::object();
  for (const auto& [name, value] : counts.items()) {
    if (is_nothing(value)) continue;
    if (Json part = sparse_counts(value); !is_nothing(part)) sparse[name] = std::move(part);
  }
  return sparse;
}

TallyMaterial tally_of_stretch(const std::vector<const Kernel*>& kernels, const Stretches& stretches,
                               const Entry& entry) {
  TallyMaterial tally{entry.stretch, stretches.text(entry.stretch), {}, {}};
  const Precision precision = stretches.at(entry.stretch).precision;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const Kernel& kernel = *kernels[k];
    tally.sha256.emplace_back(sha256_hex(std::as_bytes(std::span(entry.tallies[k]))));
    JsonObject& counts = tally.counts.emplace_back();
    if (kernel.has(precision))
      counts.json = sparse_counts(counts_json(kernel, decode_tally(entry.tallies[k], *kernel.predicate)));
  }
  return tally;
}

Json no_counts(const KernelRecord& entry, const Predicate& predicate) {
  Kernel kernel;  // of which nothing is asked but what it promises and shows
  kernel.predicate = &predicate;
  if (has_limits(entry)) kernel.limits.least_radius = 1;
  if (entry.measures) kernel.measure_count = entry.measures->size();
  if (entry.digest) kernel.file = "a file";  // it was asked again
  Tally nothing = empty_tally(predicate);
  if (entry.limits && entry.limits->margin && nothing.contacts.separation)
    nothing.contacts.separation->less_margin.emplace();
  Json none = counts_json(kernel, nothing);
  if (entry.reference.value_or(false)) none["verdict"]["clear"] = nullptr;
  none["critical_radius"]["largest_ulps"] = 0.0;
  if (none.contains("classes")) {
    for (const InputClass which : enumerators<InputClass>)
      none["classes"][std::string(input_class_names[which])] = {
          {"false_separation", 0u}, {"false_contact", 0u}, {"deepest", 0.0}};
  }
  for (const std::string_view kind : finding_kind_names) none["findings"][std::string(kind)] = 0u;
  return none;
}

Json number_of_text(const Json& text, const std::string& where) {
  if (text.is_number_integer()) return text;
  double value = 0;
  if (text.is_string()) {
    const auto& digits = text.get_ref<const std::string&>();
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem == std::errc() && end == digits.data() + digits.size() && std::isfinite(value)) return value;
  }
  throw NotValid(fmt::format("{} is {}, which is no number", where, shown(text.dump())));
}

Json whole_counts(const Json& none, const Json& sparse, std::uint64_t most, const std::string& where) {
  if (none.is_object()) {
    if (!sparse.is_object()) throw NotValid(fmt::format("{} is {}, not counts", where, shown(sparse.dump())));
    Json whole = none;
    for (const auto& [member, value] : sparse.items()) {
      const auto place = whole.find(member);
      if (place == whole.end())
        throw NotValid(fmt::format("{} has {}, which no count is called", where, shown(member)));
      *place = whole_counts(*place, value, most, fmt::format("{}: {}", where, member));
    }
    return whole;
  }
  if (none.is_number_float()) {
    const bool is_error = where.ends_with("_in_u") || where.ends_with("_ulps");
    if (is_error && sparse.is_string() && is_beyond_binary64(sparse.get_ref<const std::string&>())) return sparse;
    Json value = number_of_text(sparse, where);
    if (value < 0) throw NotValid(fmt::format("{} is {}, below 0", where, shown(sparse.dump())));
    return value.get<double>();
  }
  if (none.is_string()) {  // a mark of answers
    if (!sparse.is_string()) throw NotValid(fmt::format("{} is {}, not a text", where, shown(sparse.dump())));
    return sparse;
  }
  const bool is_count = none.is_number_integer() && sparse.is_number_integer();
  if (!is_count || sparse < 0 || sparse > most) {
    throw NotValid(fmt::format("{} is {}: a count there is from 0 to {}", where, shown(sparse.dump()), most));
  }
  return sparse;
}

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

ImageNumbersRecord image_numbers_again(Json numbers, const std::string& where) {
  for (const char* size : {"largest_separation", "largest_angle", "largest_point"}) {
    Json* const text = part_at(numbers, size, Json::value_t::string);
    if (text == nullptr) continue;
    *text = number_of_text(*text, where);
    if (*text < 0) throw NotValid(fmt::format("{}: {} is below 0", where, size));
  }
  return form_again<ImageNumbersRecord>(numbers, where);
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
  for (const std::uint64_t count : {verdict.decided_contacts, verdict.decided_separations, verdict.undecided,
                                    verdict.invalid, verdict.unanswered}) {
    require(count <= queries, "more verdicts or missing answers than queries");
    answered += count;
  }
  require(verdict.false_separation <= verdict.decided_contacts && verdict.false_contact <= verdict.decided_separations,
          "more wrong answers than verdicts");
  require(outside.decided_contacts <= outside.trials && outside.decided_separations <= outside.trials,
          "more verdicts than queries outside its limits");
  require(outside.false_separation <= outside.decided_contacts &&
              outside.false_contact <= outside.decided_separations && outside.decided() <= outside.trials,
          "more wrong answers than verdicts outside its limits");
  const ClearTally clear = verdict.clear.value_or(ClearTally());
  require(clear.queries <= queries && clear.undecided <= queries && clear.decided_contacts <= queries &&
              clear.decided_separations <= queries && clear.decided() + clear.undecided <= clear.queries,
          "more answers to clear queries than there are");
  // A touching query may be neither right nor wrong.
  require(answered <= valid && valid <= answered + truth.touching, "more or fewer answers than valid queries");
  require(verdict.undecided_contact <= verdict.undecided && verdict.undecided_touching <= verdict.undecided_contact,
          "more declined contacts than declined queries");
  // A touching query that a kernel means to call separated is a contact, and a false one.
  require(verdict.decided_contacts + verdict.undecided_contact <= truth.contact, "more decided contacts than contacts");
  require(verdict.touching_flips <= verdict.false_separation + verdict.false_contact &&
              verdict.touching_flips <= verdict.decided_touching && verdict.decided_touching <= truth.touching,
          "more wrong verdicts on touching queries than wrong verdicts, or than verdicts on them");
  require((verdict.false_separation != 0 || verdict.deepest_false_separation.best() == 0) &&
              (verdict.false_contact != 0 || verdict.deepest_false_contact.best() == 0),
          "a depth of wrong verdicts, and none is wrong");
}

}  // namespace

StretchCounts counts_again(const Json& whole, std::uint64_t queries, const std::string& where) {
  StretchCounts none;
  none.verdict.depths.reset();
  none.verdict.engine.reset();
  if (whole.contains("contacts")) none.contacts.emplace();
  Json counts = json_of(none);
  put_unseen(counts, none);
  counts.update(whole, true);
  const Json& verdict = counts["verdict"];
  if (verdict["deepest"] != std::max(verdict["deepest_false_separation"], verdict["deepest_false_contact"]))
    throw NotValid(where + ": the deepest wrong verdict is another than those of the two kinds");
  auto read = form_again<StretchCounts>(counts, where);
  require_counts(read, queries, where);
  return read;
}

}  // namespace axiscert

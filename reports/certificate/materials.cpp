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
#include "reports/run_folder/count_checks.h"
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

void require_counts(const StretchCounts& counts, TouchingPolicy touching, std::uint64_t queries,
                    const std::string& where) {
  if (counts.trials != queries) {
    throw NotValid(
        fmt::format("{}: {} queries, and its plan has {} there", where, thousands(counts.trials), thousands(queries)));
  }
  auto fault = fault_of_verdicts(touching, counts);
  if (!fault) fault = fault_of_contacts(touching, counts);
  if (fault) throw NotValid(fmt::format("{}: {}", where, *fault));
  const VerdictTally& verdict = counts.verdict;
  if ((verdict.false_separation == 0 && verdict.deepest_false_separation.best() != 0) ||
      (verdict.false_contact == 0 && verdict.deepest_false_contact.best() != 0))
    throw NotValid(where + ": a depth of wrong verdicts, and none is wrong");
}

}  // namespace

StretchCounts counts_again(const Json& whole, TouchingPolicy touching, std::uint64_t queries,
                           const std::string& where) {
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
  require_counts(read, touching, queries, where);
  return read;
}

}  // namespace axiscert

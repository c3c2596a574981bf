#include "reports/run_folder/identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/sha256.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

constexpr std::size_t shown_digits = 12;  // of a digest, in a sentence

const KernelRecord* kernel_entry(const Record& record, const std::string& id) {
  const auto found = std::ranges::find_if(record.kernels, [&](const KernelRecord& kernel) { return kernel.id == id; });
  return found == record.kernels.end() ? nullptr : &*found;
}

// The names that more than one kernel of the record declares.
std::set<std::string> shared_names(const Record& record) {
  std::set<std::string> seen, shared;
  for (const std::string& id : record.plan.kernels) {
    const std::string name = declared_name(record, id);
    if (!name.empty() && !seen.insert(name).second) shared.insert(name);
  }
  return shared;
}

Identities identities(const Record& record, const std::set<std::string>& shared) {
  Identities all;
  for (const std::string& id : record.plan.kernels) {
    const std::string name = declared_name(record, id);
    const bool is_known_by_name = !name.empty() && !shared.contains(name);
    all[id] = is_known_by_name ? fmt::format("{}/{}", id.substr(0, id.find(':')), name) : id;
  }
  return all;
}

std::string digest(const DigestRecord& part) { return part.sha256.substr(0, shown_digits); }

const DigestRecord* part_of(const Digests& all, const std::string& kind) {
  const auto found = std::ranges::find_if(all, [&](const DigestRecord& part) { return part.kind == kind; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::string declared_name(const Record& record, const std::string& id) {
  const KernelRecord* const entry = kernel_entry(record, id);
  return entry == nullptr ? "" : entry->name.value_or("");
}

Digests digests_of(const Record& record, const std::string& id) {
  const KernelRecord* const entry = kernel_entry(record, id);
  return entry == nullptr ? Digests() : entry->digest.value_or(Digests());
}

Identities identities_of(const Record& record) { return identities(record, shared_names(record)); }

std::pair<Identities, Identities> identities_of(const Record& before, const Record& after) {
  std::set<std::string> shared = shared_names(before);
  shared.merge(shared_names(after));
  return {identities(before, shared), identities(after, shared)};
}

std::vector<const KernelRecord*> precision_entries(const Record& record, const std::string& id) {
  std::vector<const KernelRecord*> entries;
  for (const KernelRecord& kernel : record.kernels) {
    if (kernel.id == id) entries.push_back(&kernel);
  }
  return entries;
}

const KernelRecord* precision_entry(const Record& record, const std::string& id, Precision precision) {
  for (const KernelRecord* entry : precision_entries(record, id)) {
    if (entry->precision == precision) return entry;
  }
  return nullptr;
}

std::string digest_change(const Digests& before, const Digests& after) {
  if (before.empty() || after.empty() || before == after) return "";
  std::vector<std::string> parts;
  for (const DigestRecord& now : after) {
    const DigestRecord* const then = part_of(before, now.kind);
    if (then == nullptr) parts.push_back(fmt::format("its {} is new", static_cast<const std::string&>(now.kind)));
    else if (*then != now) {
      parts.push_back(fmt::format("its {} was SHA-256 {}..., and is {}...", static_cast<const std::string&>(now.kind),
                                  digest(*then), digest(now)));
    }
  }
  for (const DigestRecord& then : before) {
    if (part_of(after, then.kind) == nullptr)
      parts.push_back(fmt::format("its {} is gone", static_cast<const std::string&>(then.kind)));
  }
  return parts.empty() ? "its files are in another order" : fmt::format("{}", fmt::join(parts, "; "));
}

std::string short_sha256(const std::string& text) { return sha256_hex(std::as_bytes(std::span(text))).substr(0, 16); }

Json queries_of(const PlanRecord& plan, const std::string& family, Precision precision) {
  // The number of queries of a run that was stopped by time or by hand does not follow from its plan.
  if (plan.units_done) return nullptr;
  const auto* trials = plan.trials.find(family);
  if (trials == nullptr || !trials->contains(precision)) return nullptr;
  Json queries = {{"generator", plan.generators.at(family).version}, {"trials", trials->at(precision)}};
  bool is_list = false;
  for (const FileRecord& file : plan.files) {
    if (family != file.family_name()) continue;
    queries["sha256"] = json_of(file.sha256);
    is_list |= file.has_queries();
  }
  if (!is_list) queries["seed"] = json_of(plan.seed);  // a list of queries is the same with every seed
  return queries;
}

std::string plan_fingerprint(const PlanRecord& plan) {
  if (plan.units_done) return "";
  Json all = {{"tolerance", json_of(plan.tolerance)}, {"families", Json::object()}};
  if (const std::string_view name = written_name(predicate_of(plan)); !name.empty()) all["predicate"] = name;
  for (const std::string& family : plan.families) {
    for (const Precision precision : plan.precisions)
      all["families"][family][std::string(name(precision))] = queries_of(plan, family, precision);
  }
  return short_sha256(all.dump());
}

}  // namespace axiscert

#include "reports/run_folder/identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

namespace axiscert {
namespace {

constexpr std::size_t shown_digits = 12;  // of a digest, in a sentence

const Json* kernel_entry(const Json& record, const std::string& id) {
  const Json& kernels = record["kernels"];
  const auto found =
      std::find_if(kernels.begin(), kernels.end(), [&](const Json& kernel) { return kernel["id"] == id; });
  return found == kernels.end() ? nullptr : &*found;
}

// The names that more than one kernel of the record declares.
std::set<std::string> shared_names(const Json& record) {
  std::set<std::string> seen, shared;
  for (const Json& id : record["plan"]["kernels"]) {
    const std::string name = declared_name(record, id);
    if (!name.empty() && !seen.insert(name).second) shared.insert(name);
  }
  return shared;
}

Identities identities(const Json& record, const std::set<std::string>& shared) {
  Identities all;
  for (const Json& given : record["plan"]["kernels"]) {
    const std::string id = given, name = declared_name(record, id);
    const bool is_known_by_name = !name.empty() && !shared.contains(name);
    all[id] = is_known_by_name ? fmt::format("{}/{}", id.substr(0, id.find(':')), name) : id;
  }
  return all;
}

std::string digest(const Json& part) { return part["sha256"].get<std::string>().substr(0, shown_digits); }

}  // namespace

std::string declared_name(const Json& record, const std::string& id) {
  const Json* const entry = kernel_entry(record, id);
  return entry == nullptr || (*entry)["name"].is_null() ? "" : (*entry)["name"].get<std::string>();
}

Json digest_of(const Json& record, const std::string& id) {
  const Json* const entry = kernel_entry(record, id);
  return entry == nullptr ? Json(nullptr) : (*entry)["digest"];
}

Identities identities_of(const Json& record) { return identities(record, shared_names(record)); }

std::pair<Identities, Identities> identities_of(const Json& before, const Json& after) {
  std::set<std::string> shared = shared_names(before);
  shared.merge(shared_names(after));
  return {identities(before, shared), identities(after, shared)};
}

std::string digest_change(const Json& before, const Json& after) {
  if (before.is_null() || after.is_null() || before == after) return "";
  std::vector<std::string> parts;
  const auto part_of = [](const Json& all, const Json& kind) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Json& part) { return part["kind"] == kind; });
    return found == all.end() ? nullptr : &*found;
  };
  for (const Json& now : after) {
    const std::string kind = now["kind"];
    const Json* const then = part_of(before, kind);
    if (then == nullptr) parts.push_back(fmt::format("its {} is new", kind));
    else if (*then != now)
      parts.push_back(fmt::format("its {} was SHA-256 {}..., and is {}...", kind, digest(*then), digest(now)));
  }
  for (const Json& then : before) {
    const std::string kind = then["kind"];
    if (part_of(after, kind) == nullptr) parts.push_back(fmt::format("its {} is gone", kind));
  }
  return parts.empty() ? "its files are in another order" : fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace axiscert

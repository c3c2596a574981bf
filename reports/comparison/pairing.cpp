#include "reports/comparison/pairing.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiscert {

KernelPairs::KernelPairs(const Json& before, const Json& after)
    : before_(before), after_(after), identities_(identities_of(before, after)) {
  for (const Json& id : before["plan"]["kernels"]) {
    ComparedKernel& kernel = kernels_.emplace_back();
    kernel.name = identity(id, true);
    kernel.before = id;
  }
  for (const Json& id : after["plan"]["kernels"]) {
    const std::string& name = identity(id, false);
    ComparedKernel* both = called(name);
    if (both == nullptr) both = &kernels_.emplace_back(ComparedKernel{name});
    both->after = id;
  }
  for (ComparedKernel& kernel : kernels_) {
    if (!kernel.is_in_both()) continue;
    const Json then = digest_of(before, kernel.before), now = digest_of(after, kernel.after);
    kernel.has_digests = !then.is_null() && !now.is_null();
    kernel.digest_change = digest_change(then, now);
  }
}

const std::string& KernelPairs::identity(const std::string& id, bool is_before) const {
  const Identities& all = is_before ? identities_.first : identities_.second;
  const auto known = all.find(id);
  return known == all.end() ? id : known->second;
}

ComparedKernel* KernelPairs::called(const std::string& name) {
  const auto found = std::ranges::find(kernels_, name, &ComparedKernel::name);
  return found == kernels_.end() ? nullptr : &*found;
}

ComparedKernel& KernelPairs::of(const Cell& cell, bool is_before) {
  const std::string& name = identity(cell.kernel, is_before);
  if (ComparedKernel* known = called(name)) return *known;
  ComparedKernel& added = kernels_.emplace_back();
  added.name = name;
  (is_before ? added.before : added.after) = cell.kernel;
  return added;
}

std::string KernelPairs::reason(const ComparedKernel& kernel) const {
  const bool is_before = !kernel.before.empty();
  const std::string& id = is_before ? kernel.before : kernel.after;
  const Json &own = is_before ? before_ : after_, &other = is_before ? after_ : before_;
  const char* const which = is_before ? "NEW" : "OLD";
  const Json& ids = other["plan"]["kernels"];
  const std::string name = declared_name(own, id);
  if (std::ranges::any_of(ids, [&](const Json& given) { return given == id; })) {
    const std::string there = declared_name(other, id);
    if (there.empty()) return fmt::format("; in {} it could not be loaded", which);
    return fmt::format("; in {} it declares another name, '{}' and not '{}'", which, there, name);
  }
  for (const Json& given : ids) {
    if (!name.empty() && declared_name(other, given) == name)
      return fmt::format("; several kernels of one run declare the name '{}', so each is known by its id", name);
  }
  return "";
}

std::vector<const Json*> precision_entries(const Json& record, const std::string& id) {
  std::vector<const Json*> entries;
  for (const Json& kernel : record["kernels"]) {
    if (kernel["id"] == id) entries.push_back(&kernel);
  }
  return entries;
}

const Json* precision_entry(const Json& record, const std::string& id, const Json& precision) {
  for (const Json* entry : precision_entries(record, id)) {
    if ((*entry)["precision"] == precision) return entry;
  }
  return nullptr;
}

}  // namespace axiscert

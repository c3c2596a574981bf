#include "reports/comparison/pairing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace axiscert {
KernelPairs::KernelPairs(const Record& before, const Record& after)
    : before_(before), after_(after), identities_(identities_of(before, after)) {
  for (const std::string& id : before.plan.kernels) {
    ComparedKernel& kernel = kernels_.emplace_back();
    kernel.name = identity(id, true);
    kernel.before = id;
  }
  for (const std::string& id : after.plan.kernels) {
    const std::string& name = identity(id, false);
    ComparedKernel* both = called(name);
    if (both == nullptr) both = &kernels_.emplace_back(ComparedKernel{name});
    both->after = id;
  }
  for (ComparedKernel& kernel : kernels_) {
    if (!kernel.is_in_both()) continue;
    const Digests then = digests_of(before, kernel.before), now = digests_of(after, kernel.after);
    kernel.has_digests = !then.empty() && !now.empty();
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
  const Record &own = is_before ? before_ : after_, &other = is_before ? after_ : before_;
  const char* const which = is_before ? "NEW" : "OLD";
  const std::vector<Name>& ids = other.plan.kernels;
  const std::string name = declared_name(own, id);
  if (std::ranges::find(ids, id) != ids.end()) {
    const std::string there = declared_name(other, id);
    if (there.empty()) return fmt::format("; in {} it could not be loaded", which);
    return fmt::format("; in {} it declares another name, '{}' and not '{}'", which, there, name);
  }
  for (const std::string& given : ids) {
    if (!name.empty() && declared_name(other, given) == name)
      return fmt::format("; several kernels of one run declare the name '{}', so each is known by its id", name);
  }
  return "";
}

namespace {

// The names of a kernel's measures, by precision; none in a record of a predicate or of a version without them.
std::map<Precision, std::vector<Name>> measures_by_precision(const Record& record, const std::string& id) {
  std::map<Precision, std::vector<Name>> all;
  for (const KernelRecord& kernel : record.kernels) {
    if (kernel.id == id) all.emplace(kernel.precision, kernel.measures.value_or(std::vector<Name>()));
  }
  return all;
}

// The first that the others have not; empty where they have all.
std::string first_missing(const std::vector<Name>& measures, const std::vector<Name>& others) {
  for (const std::string& measure : measures) {
    if (std::find(others.begin(), others.end(), measure) == others.end()) return measure;
  }
  return "";
}

}  // namespace

void note_given_by_one(const Record& before, const Record& after, const ComparedKernel& kernel,
                       std::vector<NotCompared>& absent) {
  const auto now = measures_by_precision(after, kernel.after);
  for (const auto& [precision, then] : measures_by_precision(before, kernel.before)) {
    const auto found = now.find(precision);
    if (found == now.end()) continue;
    const auto note = [&, precision = precision](const std::string& measure, const char* why, Absence absence) {
      if (measure.empty()) return;
      absent.push_back({fmt::format("{} {}: '{}' of contacts", kernel.name, name(precision), measure), why,
                        kernel.names(), "", absence});
    };
    note(first_missing(then, found->second), "it gives that in OLD and not in NEW", Absence::fails);
    note(first_missing(found->second, then), "it gives that in NEW alone", Absence::only_new);
  }
}

}  // namespace axiscert

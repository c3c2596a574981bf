#include "reports/comparison/given_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace axiscert {
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
      absent.push_back({fmt::format("{} {}: '{}' of first contacts", kernel.name, name(precision), measure), why,
                        kernel.names(), "", absence});
    };
    note(first_missing(then, found->second), "it gives that in OLD and not in NEW", Absence::fails);
    note(first_missing(found->second, then), "it gives that in NEW alone", Absence::only_new);
  }
}

}  // namespace axiscert

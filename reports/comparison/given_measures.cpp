#include "reports/comparison/given_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace axiscert {
namespace {

// The names of a kernel's measures, by precision; none in a record of a test or of a version without them.
std::map<std::string, Json> measures_by_precision(const Json& record, const std::string& id) {
  std::map<std::string, Json> all;
  for (const Json& kernel : record["kernels"]) {
    if (kernel["id"] != id) continue;
    all.emplace(kernel["precision"].get<std::string>(), kernel.value("measures", Json::array()));
  }
  return all;
}

// The first that the others have not; empty where they have all.
std::string first_missing(const Json& measures, const Json& others) {
  for (const Json& measure : measures) {
    if (std::find(others.begin(), others.end(), measure) == others.end()) return measure;
  }
  return "";
}

}  // namespace

void say_given_by_one(const Json& before, const Json& after, const ComparedKernel& kernel,
                      std::vector<NotCompared>& absent) {
  const auto now = measures_by_precision(after, kernel.after);
  for (const auto& [precision, then] : measures_by_precision(before, kernel.before)) {
    const auto found = now.find(precision);
    if (found == now.end()) continue;
    const auto say = [&](const std::string& measure, const char* why, Absence absence) {
      if (measure.empty()) return;
      absent.push_back({fmt::format("{} {}: '{}' of first contacts", kernel.name, precision, measure), why,
                        kernel.names(), "", absence});
    };
    say(first_missing(then, found->second), "it gives that in OLD and not in NEW", Absence::fails);
    say(first_missing(found->second, then), "it gives that in NEW alone", Absence::only_new);
  }
}

}  // namespace axiscert

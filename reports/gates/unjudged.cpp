#include "reports/gates/unjudged.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/wording/finding.h"

namespace axiscert {
namespace {

struct Queries {
  std::uint64_t valid = 0, within_limits = 0;
};

// Those that one kernel was asked, in all of its precisions; of all families where `family` is null.
Queries queries_of_kernel(const Json& record, const Json& id, const Json& family) {
  Queries sum;
  for (const Json& kernel : record["kernels"]) {
    if (kernel["id"] != id) continue;
    for (const auto& [name, result] : kernel["families"].items()) {
      if (!family.is_null() && family != name) continue;
      const auto number = [](const Json& count) { return count.get<std::uint64_t>(); };
      const Json& outside = result["verdict"]["outside_limits"];
      const std::uint64_t valid = number(result["trials"]) - number(result["truth"]["invalid"]);
      sum.valid += valid;
      sum.within_limits += valid - (outside.is_null() ? 0 : number(outside["trials"]));
    }
  }
  return sum;
}

}  // namespace

std::vector<std::string> unjudged(const Json& record) {
  std::vector<std::string> sentences;
  const std::vector<std::string> unloaded = not_judged(record);
  for (const std::string& id : unloaded) {
    std::string why;
    for (const Json& finding : record["findings"]) {
      if (finding["kernel"] == id) why = ": " + finding["detail"].get<std::string>();
    }
    sentences.push_back(fmt::format("{}: NOT JUDGED: it could not be loaded{}", id, why));
  }
  for (const Json& id : record["plan"]["kernels"]) {
    const std::string kernel = id;
    if (std::find(unloaded.begin(), unloaded.end(), kernel) != unloaded.end()) continue;
    std::vector<std::string> empty;
    for (const Json& family : record["plan"]["families"]) {
      if (queries_of_kernel(record, id, family).valid == 0) empty.push_back(family);
    }
    if (!empty.empty()) {
      sentences.push_back(fmt::format("{}: NOT JUDGED on {}: no valid query in a precision in which it exists", kernel,
                                      fmt::join(empty, ", ")));
    } else if (queries_of_kernel(record, id, nullptr).within_limits == 0) {
      sentences.push_back(
          fmt::format("{}: NOT JUDGED: every valid query is outside the limits that it declares", kernel));
    }
  }
  return sentences;
}

}  // namespace axiscert

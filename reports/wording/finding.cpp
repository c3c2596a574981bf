#include "reports/wording/finding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/queries/address.h"
#include "kernel/base/error.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

template <class Real>
void put_query_of(Json& into, std::uint64_t seed, const Source& source, std::uint64_t position) {
  Query<Real> q;
  source.make(seed, position, q);
  put_query(into, q);
}

std::string times(const Json& count) { return count == 1 ? "once" : thousands(count.get<std::uint64_t>()) + " times"; }

}  // namespace

void require_loaded(const Kernel& kernel) {
  if (kernel.has(Precision::binary32) || kernel.has(Precision::binary64)) return;
  std::string why;
  for (const Finding& finding : kernel.findings) why += fmt::format("; {}: {}", name(finding.kind), finding.detail);
  throw Error(fmt::format("--kernel {}: it could not be loaded{}", kernel.id, why));
}

void put_loading_findings(Json& findings, const Kernel& kernel) {
  for (const Finding& finding : kernel.findings) {
    Json& entry = findings.emplace_back();
    entry = {{"kernel", kernel.id}, {"precision", nullptr},     {"family", nullptr}, {"kind", name(finding.kind)},
             {"count", 1},          {"detail", finding.detail}, {"address", nullptr}};
    for (const char* member : {"a", "b", "c", "p", "r"}) entry[member] = nullptr;
  }
}

void put_findings(Json& findings, const Kernel& kernel, std::uint64_t seed, const Source& source, Precision precision,
                  const Tally& tally) {
  for (std::size_t i = 0; i < finding_kind_count; ++i) {
    const FindingTally& found = tally.findings[i];
    if (found.count == 0) continue;
    Json& entry = findings.emplace_back();
    entry = {{"kernel", kernel.id},
             {"precision", name(precision)},
             {"family", source.name()},
             {"kind", finding_kind_names[i]},
             {"count", found.count},
             {"detail", found.detail},
             {"address", text(address_of(source, seed, precision, found.first))}};
    if (precision == Precision::binary32) put_query_of<float>(entry, seed, source, found.first);
    else put_query_of<double>(entry, seed, source, found.first);
  }
}

std::string finding_text(const Json& finding) {
  const auto text = [&](const char* member) { return finding[member].get<std::string>(); };
  if (finding["family"].is_null()) return fmt::format("{}: {}: {}", text("kernel"), text("kind"), text("detail"));
  return fmt::format("{} {}: {} on family {}, {}, first at {}: {}", text("kernel"), text("precision"), text("kind"),
                     text("family"), times(finding["count"]), text("address"), text("detail"));
}

std::string FindingGroup::others_text() const {
  std::vector<std::string> families;
  for (const Json* other : others) {
    families.push_back(fmt::format("{} ({})", (*other)["family"].get<std::string>(), times((*other)["count"])));
  }
  return families.empty() ? "" : fmt::format("also on family {}", fmt::join(families, ", "));
}

std::vector<FindingGroup> finding_groups(const Json& record) {
  std::vector<FindingGroup> groups;
  for (const Json& finding : record["findings"]) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
      const auto equal = [&](const char* member) { return (*group.first)[member] == finding[member]; };
      return equal("kernel") && equal("precision") && equal("kind") && !finding["family"].is_null();
    });
    if (same == groups.end()) groups.push_back({&finding, {}});
    else same->others.push_back(&finding);
  }
  return groups;
}

bool is_about(const Json& finding, const Json& kernel) {
  return finding["kernel"] == kernel["id"] &&
         (finding["precision"].is_null() || finding["precision"] == kernel["precision"]);
}

std::vector<std::string> not_judged(const Json& record) {
  std::vector<std::string> ids;
  for (const Json& id : record["plan"]["kernels"]) {
    const auto& entries = record["kernels"];
    const bool judged = std::any_of(entries.begin(), entries.end(), [&](const Json& e) { return e["id"] == id; });
    if (!judged) ids.push_back(id);
  }
  return ids;
}

}  // namespace axiscert

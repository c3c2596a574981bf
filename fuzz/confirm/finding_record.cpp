#include "fuzz/confirm/finding_record.h"

#include <fmt/format.h>

#include "fuzz/confirm/witness.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Real>
void put_query_of(Json& into, const SeededSource& of, std::uint64_t position) {
  put_query(into, of.source.test().entries[of.source.entry()], of.source.make<Real>(of.seed, position));
}

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
    for (const ColumnGroup& group : groups_of(kernel.test->entries[kernel.entry])) {
      entry[std::string(group.name)] = nullptr;
    }
  }
}

void put_findings(Json& findings, const Kernel& kernel, const SeededSource& of, const Tally& tally) {
  for (std::size_t i = 0; i < finding_kind_count; ++i) {
    const FindingTally& found = tally.findings[i];
    if (found.count == 0) continue;
    Json& entry = findings.emplace_back();
    entry = {{"kernel", kernel.id},
             {"precision", name(of.precision)},
             {"family", of.source.name()},
             {"kind", finding_kind_names[i]},
             {"count", found.count},
             {"detail", found.detail},
             {"address", of.address(found.first)}};
    if (of.precision == Precision::binary32) put_query_of<float>(entry, of, found.first);
    else put_query_of<double>(entry, of, found.first);
  }
}

}  // namespace axiscert

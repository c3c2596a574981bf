#include "fuzz/confirm/finding_record.h"

#include <fmt/format.h>

#include "fuzz/confirm/witness.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Real>
NamedValues<std::optional<GroupNumbers>> numbers_of(const SeededSource& of, std::uint64_t position) {
  NamedValues<std::optional<GroupNumbers>> numbers;
  for (auto& [group, values] :
       groups_of_numbers(of.source.predicate().entries[of.source.entry()], of.source.make<Real>(of.seed, position)))
    numbers.put(group) = std::move(values);
  return numbers;
}

}  // namespace

void require_loaded(const Kernel& kernel) {
  if (kernel.has(Precision::binary32) || kernel.has(Precision::binary64)) return;
  std::string why;
  for (const Finding& finding : kernel.findings) why += fmt::format("; {}: {}", name(finding.kind), finding.detail);
  throw Error(fmt::format("--kernel {}: it could not be loaded{}", kernel.id, why));
}

void put_loading_findings(std::vector<FindingRecord>& findings, const Kernel& kernel) {
  for (const Finding& finding : kernel.findings) {
    FindingRecord& record = findings.emplace_back();
    record.kernel = kernel.id;
    record.kind = finding.kind;
    record.count = 1;
    record.detail = finding.detail;
    for (const ColumnGroup& group : groups_of(kernel.predicate->entries[kernel.entry])) record.numbers.put(group.name);
  }
}

void put_findings(std::vector<FindingRecord>& findings, const Kernel& kernel, const SeededSource& of,
                  const Tally& tally) {
  for (const FindingKind kind : enumerators<FindingKind>) {
    const FindingTally& found = tally.findings[kind];
    if (found.count == 0) continue;
    findings.push_back({kernel.id, of.precision, Name(of.source.name()), kind, found.count, found.detail,
                        Name(of.address(found.first)),
                        of.precision == Precision::binary32 ? numbers_of<float>(of, found.first)
                                                            : numbers_of<double>(of, found.first)});
  }
}

}  // namespace axiscert

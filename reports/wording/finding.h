// Findings: what somebody else's kernel did wrong beside its answers, as the record has it and as people read it.
#pragma once

#include <string>
#include <vector>

#include "fuzz/confirm/record.h"

namespace axiscert {

// Throws Error with what was found in loading it, where a kernel exists in no precision.
void require_loaded(const Kernel& kernel);

// Appends what was found when the kernel was loaded: of no precision, family or query.
void put_loading_findings(Json& findings, const Kernel& kernel);
// Appends what was found on one source, one entry a kind, with the first query that showed it.
void put_findings(Json& findings, const Kernel& kernel, std::uint64_t seed, const Source& source, Precision precision,
                  const Tally& tally);

// "plugin:x.so binary32: out_of_bounds on family general, 3 times, first at ADDRESS: DETAIL"; of loading,
// "plugin:x.so: load: DETAIL".
std::string finding_text(const Json& finding);
// The findings of a record, those of one kind, kernel and precision together: the first of them, then on which other
// families it showed. In the record's order.
struct FindingGroup {
  const Json* first;
  std::vector<const Json*> others;

  // "also on family tangent (4 times), scale (once)"; empty where there are no others.
  std::string others_text() const;
};
std::vector<FindingGroup> finding_groups(const Json& record);
// Whether it is about a record's kernel entry; one of loading is about every entry of its kernel.
bool is_about(const Json& finding, const Json& kernel);
// The kernels of the plan that exist in no precision, because they could not be loaded.
std::vector<std::string> not_judged(const Json& record);

}  // namespace axiscert

// Findings of a record, faults of a kernel other than wrong answers, as people read them.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

// "plugin:x.so binary32: out_of_bounds on family general, 3 times, first at ADDRESS: DETAIL"; for a finding made in
// loading, "plugin:x.so: load: DETAIL".
std::string finding_text(const FindingRecord& finding);
// The findings of a record, grouped by kind, kernel and precision: the first of each group, then the other families on
// which it occurred. In the record's order.
struct FindingGroup {
  const FindingRecord* first;
  std::vector<const FindingRecord*> others;

  // "also on family tangent (4 times), scale (once)"; empty where there are no others.
  std::string others_text() const;
};
std::vector<FindingGroup> finding_groups(const Record& record);
// Whether the finding is about this kernel of a record; one made in loading is about every entry of its kernel.
bool is_about(const FindingRecord& finding, const KernelRecord& kernel);
// The kernels of the plan that exist in no precision, because they could not be loaded.
std::vector<std::string> not_judged(const Record& record);

}  // namespace axiscert

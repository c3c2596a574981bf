// The kernels of two records, paired by what both know them by.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/comparison/compare.h"
#include "reports/run_folder/identity.h"

namespace axiscert {
class KernelPairs {
 public:
  // The records have to outlive this.
  KernelPairs(const Record& before, const Record& after);

  std::vector<ComparedKernel>& all() { return kernels_; }
  const std::string& identity(const std::string& id, bool is_before) const;
  // That of a cell; one that the plan does not name is added.
  ComparedKernel& of(const Cell& cell, bool is_before);
  // Why the other record does not have a kernel, where more than its absence is to be said.
  std::string reason(const ComparedKernel& kernel) const;

 private:
  ComparedKernel* called(const std::string& name);

  const Record &before_, &after_;
  std::pair<Identities, Identities> identities_;
  std::vector<ComparedKernel> kernels_;  // OLD's, then those that only NEW has
};

// Measures that a kernel gives in one of two runs alone.

// Adds an entry for each precision that both runs judged: one that fails where OLD gave more, so that something is not
// checked any more, and another where NEW gives more. `kernel` is in both records.
void note_given_by_one(const Record& before, const Record& after, const ComparedKernel& kernel,
                       std::vector<NotCompared>& absent);

}  // namespace axiscert

// Questions of a run to its kernels beside its queries: a first look before them, and the units of length after them.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.h"
#include "fuzz/record/record.h"
#include "kernel/kernel.h"

namespace axiscert {

// Faults of a kernel at first sight, before anything is asked of it that takes time: a few hundred queries in
// each precision that it has; of a program, which may take long to start, in the first alone. One line: it leaves
// queries without an answer, and why; or its verdicts are exchanged. Empty: neither. Throws Error where a program fails
// before it is asked anything, and OracleDisagreement.
std::string first_look(const Kernel& kernel);

// Puts into each kernel of a record the units of length in which it answers as in that of its queries; none where the
// answers are replies, or the run was interrupted. Depends on the kernels, the precisions and the seed alone.
void put_windows(Record& record, const Plan& plan, const CampaignResult& result);

}  // namespace axiscert

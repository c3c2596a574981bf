// The units of length in which a kernel answers as in that of its queries, for a run.
#pragma once

#include "fuzz/campaign/campaign.h"
#include "fuzz/record/record.h"

namespace axiscert {

// Asks each kernel of a record; none where the answers are replies, or the run was interrupted. Depends on the kernels,
// the precisions and the seed alone.
void put_windows(Record& record, const Plan& plan, const CampaignResult& result);

}  // namespace axiscert

// The look at clear queries, of kernels whose wrong verdicts have no links to tell the cause.
#pragma once

#include "fuzz/campaign/unit.h"

namespace axiscert {

// Counts the answers to the clear queries of a batch that the runs were asked last; those of kernels with a reference
// are not counted. Asks no oracle.
template <class Real>
void look_at_clear(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs);

}  // namespace axiscert

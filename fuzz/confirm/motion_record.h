// The members of the record about the first contacts that a kernel reports.
#pragma once

#include "exact/trait/examine.h"
#include "fuzz/campaign/counts/motion_tally.h"
#include "fuzz/text/json.h"

namespace axiscert {

// The names of the measures that the kernel gives.
Json given_measures_json(const Kernel& kernel);

// The kernel's promises about motions.
Json policy_json(const MotionPolicy& policy);

// Those of one family. A measure that the kernel does not give is null.
Json motion_json(const MotionTally& tally, const Kernel& kernel);

// The measures that a kernel gave beside a contact, by name, numbers as a query has them, and how they are wrong, where
// that contact is right; of a missed contact its tunnel. Null where there is neither.
Json measures_json(const TestDescription& test, const Examination& found);

// The exact first contact of a query whose verdict is `truth`, by name: the details of the oracles of its entry and,
// where there is contact, its point and normal as numbers of binary64. Null of a query that is invalid.
template <class Real>
Json first_contact_json(const Oracles& oracles, const Truth& truth, const Numbers<Real>& numbers);

}  // namespace axiscert

// The first contact, as a witness has it.
#pragma once

#include <optional>

#include "exact/trait/examine.h"
#include "fuzz/record/witness_record.h"

namespace axiscert {

// The measures that a kernel gave beside a contact, by name, numbers as a query has them, and how they are wrong, where
// that contact is right; of a missed contact its tunnel. Empty where there is neither.
std::optional<MeasuresRecord> measures_of(const Predicate& predicate, const Examination& found);

// The exact first contact of a query whose verdict is `truth`: the details of the oracles of its entry and, where there
// is contact, its point and normal as numbers of binary64. Empty of a query that is invalid.
template <class Real>
std::optional<FirstContactRecord> first_contact_of(const Oracles& oracles, const Truth& truth,
                                                   const Numbers<Real>& numbers);

}  // namespace axiscert

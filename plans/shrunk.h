// A query made small, as a line of a query file that states what it keeps.
#pragma once

#include <string>

#include "fuzz/campaign/progress.h"
#include "fuzz/files/query_file.h"
#include "fuzz/record/record.h"
#include "fuzz/shrink/pair.h"
#include "fuzz/shrink/shrink.h"
#include "reports/instrument/query_data.h"

namespace axiscert {

// The smaller query as a stored one, named "shrunk-" and the name of the given one.
StoredQuery smaller_query(const StoredQuery& stored, AnyNumbers numbers);
// The image of a stored query as one, with "-image" after its name.
StoredQuery image_of(const StoredQuery& stored, AnyNumbers image);

// The smaller query, named "shrunk-" and the name of the given one, together with the symptom that it keeps and the
// given query.
template <class Real>
ShrunkQuery shrunk_query(const StoredQuery& stored, const Symptom& kept, const ShrinkResult<Real>& found,
                         const Kernel& kernel);

// The same for a pair: the line has the smaller query's image as its member `image`, and the given one's in `before`.
template <class Real>
ShrunkQuery shrunk_pair(const StoredQuery& stored, const Pair<Real>& pair, const ShrunkPair<Real>& found,
                        const Kernel& kernel);

// One line for every witness of a record on which its kernel is wrong: the first symptom that it shows (verdict before
// axes before comparisons before measures), made smaller with at most this many evaluations; and for every other
// witness of an asymmetry, the pair.
std::string shrunk_witnesses(const Record& record, const std::string& target, std::uint64_t evaluations,
                             const ShowProgress& report);

}  // namespace axiscert

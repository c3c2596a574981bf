// A query made small, as a line of a query file that says what it keeps.
#pragma once

#include <string>

#include "fuzz/files/query_file.h"
#include "fuzz/shrink/shrink.h"
#include "fuzz/text/json.h"

namespace axiscert {

// The smaller query, named "shrunk-" and the name of the one given, and beside it what it keeps and what the other was.
template <class Real>
Json shrunk_json(const StoredQuery& stored, const Symptom& kept, const Shrunk<Real>& found, const Kernel& kernel);

// Of every witness of a record on which its kernel is wrong, one line: what it shows first (verdict before axes before
// comparisons), smaller by at most so many evaluations.
std::string shrunk_witnesses(const Json& record, const std::string& target, std::uint64_t evaluations);

}  // namespace axiscert

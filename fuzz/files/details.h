// The details that a predicate's oracles know of a query beside its verdict (exact/trait/oracles.h), as query lines
// have them.
#pragma once

#include "exact/trait/oracles.h"
#include "fuzz/text/json.h"

namespace axiscert {

// A number as query lines have it, a name, an array of names; null where the query has none.
Json detail_json(const Detail& detail);

}  // namespace axiscert

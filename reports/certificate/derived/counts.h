// The counts of a stretch in a certificate: a record's family without zeros.
#pragma once

#include <string>

#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/text/json.h"
#include "kernel/test.h"

namespace axiscert {

// The counts of counts_json (fuzz/confirm/record.h) without zeros, nulls and empty objects; fractions are decimal
// texts.
Json sparse_counts(const Json& counts);

// A finished stretch as a certificate has it: "stretch", "of", and by kernel "sha256", of its encoded tally, and
// "counts".
Json stretch_json(const std::vector<const Kernel*>& kernels, const Stretches& stretches, const Entry& entry);

// All counts that a kernel's entry of a record has in a family, each zero.
Json no_counts(const Json& entry, const TestDescription& test);

// The whole counts again, from `none`, what no_counts gave. Throws NotValid, which begins with `where`, for a member
// that is not there, a number that is none, or a count above `most`.
Json whole_counts(const Json& none, const Json& sparse, std::uint64_t most, const std::string& where);

// Decimal text as a number again. Throws NotValid, which begins with `where`, for what is none, or not finite.
Json number_of_text(const Json& text, const std::string& where);

}  // namespace axiscert

// Members that follow from the materials of a certificate: `certify` states them, and `verify` finds them again.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// The members of a predicate that follow from its others, which conform to certificate.schema.json: "kernel" (its
// promise and precisions), "asked", "levels", "comparison", "situations", "breaks_first" and "limits". `record` is the
// reduced one.
//
// A link as the cause of what breaks first is known of a witness alone: then another, or nothing, comes out here.
Json derived_members(const Json& predicate, const Record& record);

// Whether the sources that made it are those of this axiscert.
bool is_made_by_this(const Json& predicate);

// Holds a predicate to its materials, and returns the reduced record. Throws NotValid, which begins with `name`, for
// the first thing that is stated otherwise, by name. The sentences of another axiscert are not compared.
Record require_derived(const Json& predicate, const std::string& name);

// Whether the kernel called a promised query separated or contact in every precision in which it was asked.
bool has_answers(const Record& record, const std::string& kernel);

// Whether the numbers of queries are those of the stated effort and kind of kernel. Throws NotValid, which begins with
// `name`.
void require_effort(const Json& predicate, const std::string& name);

}  // namespace axiscert

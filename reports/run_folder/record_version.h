// The versions of a record: earlier ones are read as the present one.
#pragma once

#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// The record as one of the present version. Version 1 has no plan.test: its test is sphere-triangle. A value that has
// no schema, or no plan, is returned as it is, for the check against the schema to refuse. Throws Error that names the
// file for any other version: what it is, and which are read.
Json present_record(Json record, const std::string& name);
// The same for a plan alone, which has no version of its own: one without `test` gets that of version 1.
Json present_plan(const Json& plan);

}  // namespace axiscert

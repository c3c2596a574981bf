// How deep wrong verdicts are, to which side a kernel errs, and what is left of that on engine-like queries, as the
// formats show them. Records of earlier versions do not have these figures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {

// The columns of a table of depths, shares of the scene, each from its name to the next one's: "zero", "< 1e-8",
// "1e-8",
// ..., "0.1"; and the counts of a record's decades in them.
const std::vector<std::string>& depth_columns();
std::vector<std::uint64_t> depth_counts(const Json& decades);

// The tables' rows below take a kernel's families combined (all_families), or one family.
bool has_depths(const Json& family);
// "zero: 3, 1e-8: 12": the columns that are not zero; "none".
std::string depths_text(const Json& decades);
// "12 missed and 3 phantom contacts on 1,234 engine-like queries"; empty where these were not counted.
std::string engine_text(const Json& family);
// "4 phantom contacts for each missed one; critical radius early on 3, late on 1 of 512, signed median -0.5 ulps";
// empty where nothing is wrong and no radius was measured.
std::string bias_text(const Json& family);

}  // namespace axiscert

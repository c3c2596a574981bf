// How deep wrong verdicts are, to which side a kernel errs, and what is left of that on engine-like queries, as the
// formats show them; and whether a kernel keeps the margin that it declares.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/record/family_record.h"
#include "fuzz/record/kernel_record.h"
#include "fuzz/record/record.h"

namespace axiscert {

// The columns of a table of depths, shares of the scene, each from its name to the next one's: "zero", "< 1e-8",
// "1e-8", ..., "0.1"; and the counts of decades in them.
const std::vector<std::string>& depth_columns();
std::vector<std::uint64_t> depth_counts(const DecadeCounts& decades);

// "zero: 3, 1e-8: 12": the columns that are not zero; "none".
std::string depths_text(const DecadeCounts& decades);
// "12 missed and 3 phantom contacts on 1,234 engine-like queries", of a kernel's families combined (all_families) or of
// one family; empty where these were not counted. Then ", of which it decided 34" where it left some without a verdict.
std::string engine_text(const FamilyRecord& family);
// "4 phantom contacts for each missed one; critical radius early on 3, late on 1 of 512, signed median -0.5 ulps", or
// "phantom contacts alone, with 0 of 900 contacts decided"; empty where nothing is wrong and no radius was measured.
std::string bias_text(const KernelRecord& kernel, const FamilyRecord& family);

// What kernels say beside their verdicts, as rows of a table: of motions how late, how early, and how deep that lets
// the sphere in; else how far separations, normals and points are off.
const std::vector<std::string>& contact_columns(bool moves);
// A cell for each column, of the results of a family or of all; "-" where the kernel does not give what it is about.
// Empty where nothing is said, and of motions where the kernel gives no time and misses nothing by more than touching.
std::vector<std::string> contact_cells(const FamilyRecord& family);
// The meaning of the columns.
const char* contact_note(bool moves);

// What a kernel says of two that are apart by no more than the margin that it declares.

struct WithinMargin {
  std::uint64_t answered = 0, contacts = 0;
};
// Empty where the record does not say: without a margin, or with other limits, whose queries are counted together.
std::optional<WithinMargin> within_margin(const KernelRecord& kernel, const FamilyRecord& result);
// Why no query shows whether the kernel keeps a margin.
std::string why_no_margin(const KernelRecord& kernel);
// "declares a margin of 0.005, and calls 12 of 90 queries that are apart by no more not contact"; empty where it calls
// all so, or none is.
std::string broken_margin_text(const KernelRecord& kernel);

}  // namespace axiscert

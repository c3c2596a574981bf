// A safe margin follows in part from other numbers of the certificate.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/record/kernel_record.h"

namespace axiscert {

// How the reason begins where a kernel has no safe margin since it is not the same kernel twice.
inline constexpr std::string_view margin_answered_otherwise =
    "the kernel answered otherwise when it was asked the same again: ";

// `margin` is a member of the predicate's safe_margin.precisions, `entry` the kernel's entry of the reduced record in
// that precision. Says what does not agree, "it missed 12 contacts of the run, and its counts say 13"; empty where all
// does.
//
// Held to the counts: the run's queries, phantoms and contacts, by what the kernel answered to each. Held to itself:
// parts add up to the whole, the greatest of the parts is the one stated, and factor and amount are those of r and the
// radius from which the kernel says contact. Not derived: that radius, and how many phantoms a growth makes.
std::string margin_fault(const Json& margin, const KernelRecord& entry);

}  // namespace axiscert

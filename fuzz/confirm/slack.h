// Slacks of a kernel: found by asking it on scenes of which the exact turn is known.
#pragma once

#include <optional>
#include <string>

#include "fuzz/record/slack_record.h"
#include "kernel/kernel.h"

namespace axiscert {

// Nothing is said by fewer queries: so many have to agree, of so many at least that could show it.
inline constexpr std::uint64_t least_agreeing = 24, least_bracketed = 32;

// Asks the kernel some ten thousands of queries, in about sixty batches. Depends on the kernel, the precision and the
// seed alone. Empty where the predicate has no such scenes in the kernel's entry. Throws OracleDisagreement.
std::optional<SlacksRecord> slacks_of(const Kernel& kernel, Precision precision, std::uint64_t seed,
                                      const std::string& target);

// "contacts 1e-04 r too early on 61 of 64 spheres over the face: a slack"
std::string slack_text(const SlackRecord& slack);
// "no slack on 640 queries whose turn is bracketed; one of 1e-04 of a length would be seen".
std::string no_slack_text(const SlacksRecord& slacks);
// "the answer turns on fewer than 32 of the queries nearest to a vertex"; empty where it turns on those of every kind.
std::string blind_text(const SlacksRecord& slacks);

// By how much a kind's answers are off, and the kind that is off by most; null where none is off by a size that is
// seen.
std::optional<double> off_by(const SlackLook& look, SlackKind kind);
const SlackLook* most_off(const SlacksRecord& slacks, SlackKind kind);
// "24 of 64 queries nearest to a vertex or more turn off the exact turn by 0.08 of a length or more".
std::string off_text(const SlackLook& look, SlackKind kind);

// The least part of a length, and the least length, that would be seen on the queries of some kind; empty: none would.
std::optional<double> least_relative(const SlacksRecord& slacks);
std::optional<double> least_absolute(const SlacksRecord& slacks);

}  // namespace axiscert

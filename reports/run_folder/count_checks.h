// Conditions on the counts of a record that its fields cannot express: how they add up, and what cannot be together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/record/kernel_record.h"
#include "kernel/predicate.h"

namespace axiscert {

// Says what contradicts the family's other counts; empty if nothing does, or the family has no classes.
std::optional<std::string> fault_of_classes(const KernelRecord& kernel, const FamilyRecord& family);
// The same of its truths and verdicts, by what the kernel promises of touch: which of them can be wrong.
std::optional<std::string> fault_of_verdicts(TouchingPolicy touching, const FamilyCounts& counts);
// The same of the depths of a family of `valid` queries, and of those on engine-like queries.
std::optional<std::string> fault_of_depths(const VerdictTally& verdict, std::uint64_t valid);
// The same of what is said beside verdicts that have no fault_of_verdicts().
std::optional<std::string> fault_of_contacts(TouchingPolicy touching, const FamilyCounts& counts);
// Of its counts by size, which certificates leave out.
std::optional<std::string> fault_of_sizes(const ContactTally& contacts);
// Of the parts that are there, for a kernel of the predicate with so many measures.
std::optional<std::string> fault_of_parts(const ContactTally& contacts, const Predicate& predicate,
                                          std::size_t measure_count);
// Of answers to images, and of what is said beside those to so many `images` that have their base's verdict.
std::optional<std::string> fault_of_asymmetry(const AsymmetryRecord& found);
std::optional<std::string> fault_of_image_numbers(const ImageNumbersRecord& numbers, std::uint64_t images);

}  // namespace axiscert

// What a kernel says of two that are apart by no more than the margin that it declares.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

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

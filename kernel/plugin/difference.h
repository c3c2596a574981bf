// The first difference between two sets of outputs, in words.
#pragma once

#include <optional>

#include "kernel/plugin/caller.h"

namespace axiscert::plugin {

struct Difference {
  std::size_t query;   // of `b`
  std::string detail;  // "verdict contact, then separated"
};

// Query i of `b` is query first + i of `a`. Only what `b` has is compared; a NaN equals any other, since what its bits
// are is no part of an answer.
template <class Real>
std::optional<Difference> first_difference(const Predicate& predicate, const Outputs<Real>& a, std::size_t first,
                                           const Outputs<Real>& b);

// "contact", or "7, which is no verdict".
std::string verdict_text(std::uint8_t verdict);
inline bool is_verdict(std::uint8_t byte) { return byte <= static_cast<std::uint8_t>(Verdict::invalid); }

}  // namespace axiscert::plugin

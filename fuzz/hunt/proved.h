// What is proved of the errors that a hunt looks for.
#pragma once

#include <optional>

#include "exact/error_measure.h"
#include "kernel/kernel.h"

namespace axiscert {

// A bound on Goal::error of a kernel's comparison, in u, that a checker accepted; nothing while it is open. Every
// attained error has to be at most that: a greater one refutes the proof or its reading.
inline std::optional<Decimal6> proved_error(const Kernel& /*kernel*/, Precision /*precision*/, Comparison /*which*/) {
  return std::nullopt;
}

}  // namespace axiscert

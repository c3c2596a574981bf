#include "reports/gates/gate.h"

#include "reports/gates/requirement.h"

namespace axiscert {

Gate gate_at(const std::string& level) {
  return [level](const Record& record) {
    std::vector<GateFailure> failures;
    for (const Failure& failure : unmet(record, level))
      failures.push_back({failure.kernel, failure.precision, failure.family, failure.what});
    return failures;
  };
}

}  // namespace axiscert

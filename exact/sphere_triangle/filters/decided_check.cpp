#include "exact/sphere_triangle/filters/decided_check.h"

#include <fmt/format.h>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {

template <class Real>
void require_same(const DecidedSigns& decided, const ExactTruth& truth, const Query<Real>& q) {
  const Signs exact = signs_of(*truth.sides);
  if (decided.signs == exact && verdict_of(exact) == truth.verdict && is_touching(exact, q.r == 0) == truth.touching) {
    return;
  }
  throw OracleDisagreement(
      fmt::format("the step `{}` of the filter has the signs {:016b} ties {:016b} (bit 0 is the first comparison); "
                  "exact arithmetic {:016b} ties {:016b}, {}{}",
                  name(decided.step), decided.signs.strict, decided.signs.ties, exact.strict, exact.ties,
                  name(truth.verdict), truth.touching ? ", touching" : ""),
      Numbers<Real>(q), sphere_triangle_predicate());
}
template void require_same(const DecidedSigns&, const ExactTruth&, const Query<float>&);
template void require_same(const DecidedSigns&, const ExactTruth&, const Query<double>&);

}  // namespace axiscert

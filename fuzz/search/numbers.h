// The aims of a search about the numbers beside verdicts: by what the predicate says of its measures, for each that the
// kernel gives.
#pragma once

#include <vector>

#include "fuzz/search/method.h"

namespace axiscert {

// In the order of MeasureFault. None of motions, whose times are of contacts alone; none of faults without a size.
std::vector<Aim> number_aims(const Kernel& kernel);

// Each evaluation asks the exact numbers.
inline constexpr IslandShare number_share = {1, 1 << 10};

// The kernel's numbers on a query, as far as an aim is about them.
struct NumberSeen {
  bool is_judged = false;                  // the query is promised, and the number is given and compared
  std::optional<MeasureError> error = {};  // empty where nothing is wrong with it
};
template <class Real>
NumberSeen number_seen(const Aim& aim, const Kernel& kernel, const Numbers<Real>& q, Verdict said,
                       std::span<const double> measures);

// A query scores the error of the number. Keeps a reference to the kernel.
template <class Real>
class NumberGuide final : public Guide<Real> {
 public:
  NumberGuide(const Kernel& kernel, std::string_view target);
  void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                std::vector<Verdict>& said) override;
  void settle(Numbers<Real>& q) const override;
  std::uint64_t judged() const override { return judged_; }

 private:
  const Kernel& kernel_;
  Implementation<Real> implementation_;
  std::uint64_t judged_ = 0;
};

}  // namespace axiscert

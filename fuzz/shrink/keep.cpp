#include "fuzz/shrink/keep.h"

#include <algorithm>

namespace axiscert {

template <class Real>
Keep::Keep(const Predicate& predicate, const Numbers<Real>& q, const Severity& severity, std::size_t entry)
    : predicate_(&predicate), entry_(entry), classes_(classes_of(predicate, q, entry)) {
  if (const auto* depth = std::get_if<ExactDepth>(&severity.exact)) {
    // |sqrt(dd) - r| / sqrt(ss) times the factor.
    greatest_ = {
        ExactDepth{Rational(depth->dd * depth_factor * depth_factor), Rational(depth->r * depth_factor), depth->ss},
        ""};
  }
  if (const auto* depth = std::get_if<RoundedDepth>(&severity.exact))
    greatest_ = {RoundedDepth{depth->value * depth_factor}, ""};
}
template Keep::Keep(const Predicate&, const Numbers<float>&, const Severity&, std::size_t);
template Keep::Keep(const Predicate&, const Numbers<double>&, const Severity&, std::size_t);

template <class Real>
bool Keep::allows(const Numbers<Real>& q, const Severity& severity) const {
  if (greatest_ && !is_no_less(*greatest_, severity)) return false;
  if (!classes_) return true;
  const std::vector<std::string_view> meets = classes_of(*predicate_, q, entry_);
  const auto is_kept = [&](std::string_view name) {
    return std::find(classes_->begin(), classes_->end(), name) != classes_->end();
  };
  return meets.front() == classes_->front() && std::all_of(meets.begin(), meets.end(), is_kept);
}
template bool Keep::allows(const Numbers<float>&, const Severity&) const;
template bool Keep::allows(const Numbers<double>&, const Severity&) const;

}  // namespace axiscert

#include "fuzz/shrink/keep.h"

#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {

template <class Real>
Keep::Keep(const Query<Real>& q, const Severity& severity) : classes_(input_classes(q, squared_distance(q))) {
  const auto* depth = std::get_if<ExactDepth>(&severity.exact);
  if (depth == nullptr) return;
  // |sqrt(dd) - r| / sqrt(ss) times the factor.
  greatest_ = {Rational(depth->dd * depth_factor * depth_factor), Rational(depth->r * depth_factor), depth->ss};
}
template Keep::Keep(const Query<float>&, const Severity&);
template Keep::Keep(const Query<double>&, const Severity&);

template <class Real>
bool Keep::allows(const Query<Real>& q, const Severity& severity) const {
  if (greatest_ && compare(std::get<ExactDepth>(severity.exact), *greatest_) > 0) return false;
  if (!classes_) return true;
  const InputClassSet meets = input_classes(q, squared_distance(q));
  return class_of(meets) == class_of(*classes_) && classes_->contains_all(meets);
}
template bool Keep::allows(const Query<float>&, const Severity&) const;
template bool Keep::allows(const Query<double>&, const Severity&) const;

}  // namespace axiscert

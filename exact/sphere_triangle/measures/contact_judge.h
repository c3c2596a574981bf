// The judge of what a kernel says of a sphere and a triangle beside its verdict: separation, feature, normal and point.
#pragma once

#include <vector>

#include "exact/judge/contact_judgement.h"
#include "exact/judge/contact_numbers.h"
#include "exact/sphere_triangle/measures/nearest_place.h"
#include "kernel/predicate.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// `Real` is the precision of the kernel and of the query. Which features are right, which numbers contradict each
// other, which normals are flips and what is left of a penetration is decided exactly.
template <class Real>
class SphereTriangleJudge final : public ContactJudge {
 public:
  // Precondition: the query is valid.
  explicit SphereTriangleJudge(const Query<double>& q);

  ContactJudgement judge(Verdict said, std::span<const double> measures) override;
  ContactPlace place() const override;
  double scene() const override;

 private:
  void judge_separation(Verdict said, double given, ContactJudgement& out) const;
  void judge_feature(double number, ContactJudgement& out) const;
  void judge_normal(const RationalVector& normal, ContactJudgement& out) const;

  NearestPlace nearest_;
  std::array<RationalVector, 3> vertex_;  // seen from the centre
  RationalVector point_, away_;           // the nearest, seen from the centre; from there to the centre
  Rational r_, dd_, scene_;               // the squares of the distance and of the scene's extent
  std::array<double, 3> centre_;
};

}  // namespace axiscert

// The judge of a kernel's separation, normal and points of two boxes, or of a box and a triangle.
#pragma once

#include <functional>
#include <optional>

#include "exact/boxes/contact.h"
#include "exact/judge/contact_judgement.h"

namespace axiscert::boxes {

// `Real` is the precision of the kernel and of the query. What is left, flips and errors of points are decided exactly.
template <class Real>
class BoxContactJudge final : public ContactJudge {
 public:
  // The exact numbers are found when one is asked for first: beside `separated` most kernels give none.
  explicit BoxContactJudge(std::function<ExactContact()> find) : find_(std::move(find)) {}

  ContactJudgement judge(Verdict said, std::span<const double> measures) override;
  ContactPlace place() const override;
  double scene() const override;

 private:
  const ExactContact& exact() const;
  void measure_separation(Verdict said, double separation, ContactJudgement& out) const;
  void measure_normal(const Point& normal, ContactJudgement& out) const;
  void measure_points(const Point& a, const Point& b, const std::optional<Point>& normal, ContactJudgement& out) const;

  std::function<ExactContact()> find_;
  mutable std::optional<ExactContact> exact_;
};

}  // namespace axiscert::boxes

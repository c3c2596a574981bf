// The judge of a kernel's time, feature, normal and point of a first contact.
#pragma once

#include "exact/judge/contact_judgement.h"
#include "exact/moving_sphere/first_contact.h"

namespace axiscert::moving_sphere {

// `Real` is the precision of the kernel and of the query. Which times are late, early or best, which features are right
// and which tunnels reach what is decided exactly, by the comparisons of first_contact.h.
template <class Real>
class FirstContactJudge final : public ContactJudge {
 public:
  // Precondition: the query is valid and has contact.
  explicit FirstContactJudge(const GivenMotion& q);

  ContactJudgement judge(Verdict said, std::span<const double> measures) override;
  ContactPlace place() const override;
  double scene() const override;

 private:
  TimeVerdict time_verdict(double time) const;
  void measure_time(double time, ContactJudgement& out) const;
  void measure_feature(double feature, ContactJudgement& out);
  void measure_place(std::span<const double> measures, ContactJudgement& out);
  // The least squared distance of the motion until a time in [0, 1], and the squared distance at that time.
  Rational least_squared(const Rational& until) const;
  Rational squared_distance(const Rational& at) const;
  // The nearest point of the triangle at the first contact, and the vector from it to the centre; seen from P.
  struct Place {
    portable::Vec3<Rational> point, to_centre;
  };
  Place found_place() const;
  const Place& known_place();
  portable::Vec3<Rational> exact_centre() const;  // P

  GivenMotion q_;
  MotionPieces motion_;
  FirstContact contact_;
  Rational r_, scene_;  // the scene's extent is squared
  std::optional<Place> place_;
};

}  // namespace axiscert::moving_sphere

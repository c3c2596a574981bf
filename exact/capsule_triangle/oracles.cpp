// The truth of a capsule is that of a moving sphere by its ends: feature by feature in rationals, compared on every
// query with CGAL's distance and, by the theorem of docs/moving.md, with the twenty axes.
#include "exact/boxes/contact_judge.h"
#include "exact/capsule_triangle/contact.h"
#include "exact/judge/oracles_of.h"
#include "exact/moving_sphere/trait.h"
#include "kernel/capsule_triangle/capsule.h"

namespace axiscert {
namespace {

// Details and policies are of motions alone. The numbers beside a verdict are those of two bodies.
struct CapsuleTrait : Capsule {
  using Motion = moving_sphere::MovingEndsTrait;
  using AllFormulae = Motion::AllFormulae;
  using ClearForms = Motion::ClearForms;

  static bool is_valid(const Numbers<double>& numbers) { return Motion::is_valid(numbers); }
  static Truth geometric_truth(const Numbers<double>& numbers) { return Motion::geometric_truth(numbers); }
  static std::string contradiction(const Numbers<double>& numbers, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    return Motion::contradiction(numbers, truth, holds, ties);
  }
  static ExactDepth exact_depth(const Numbers<double>& numbers) { return capsule::exact_depth(Motion::query(numbers)); }
  static Distance distance(const Numbers<double>& numbers) { return Motion::distance(numbers); }
  template <class Real>
  static bool is_degenerate(const Numbers<double>& numbers) {
    return Motion::is_degenerate<Real>(numbers);
  }
  template <class Real>
  static std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& numbers) {
    return std::make_unique<boxes::BodyContactJudge<Real, capsule::ExactContact>>(
        [numbers] { return capsule::ExactContact(Motion::query(numbers)); });
  }
};

}  // namespace

template class OraclesOf<CapsuleTrait>;

const Oracles& capsule_triangle_oracles(std::size_t) {
  static const OraclesOf<CapsuleTrait> oracles;
  return oracles;
}

}  // namespace axiscert

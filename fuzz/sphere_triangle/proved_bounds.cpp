#include "fuzz/sphere_triangle/search.h"
#include "fuzz/sphere_triangle/search_box.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/proved_bounds.h"
#include "kernel/sphere_triangle/reference/scalar.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {
namespace {

class SphereTriangleBounds final : public ProvedBounds {
 public:
  // Both precisions have the same bound in u.
  std::optional<Decimal6> error(const Kernel& kernel, Precision, std::size_t comparison) const override {
    const bool published = formulae_of(kernel) == Formulae::published,
               reduced = formulae_of(kernel) == Formulae::reduced;
    const bool plain = kernel.arithmetic == Arithmetic::plain, fma = kernel.arithmetic == Arithmetic::fma;
    if (!kernel.is_reference || !(published || reduced) || !(plain || fma)) return std::nullopt;
    const auto row = (reduced ? 2u : 0u) + (fma ? 1u : 0u);
    return round_up(Rational(proved_sixteenths[row][comparison], 16));
  }
  bool cover(const Numbers<float>& q) const override { return is_in_box(query_from(q)); }
  bool cover(const Numbers<double>& q) const override { return is_in_box(query_from(q)); }
  bool are_as_claimed(const Kernel& kernel, const Numbers<float>& q, const Answers<float>& answers,
                      std::size_t i) const override {
    return are_claimed(kernel, query_from(q), sides_at(answers, i));
  }
  bool are_as_claimed(const Kernel& kernel, const Numbers<double>& q, const Answers<double>& answers,
                      std::size_t i) const override {
    return are_claimed(kernel, query_from(q), sides_at(answers, i));
  }

 private:
  template <class Real>
  static bool are_claimed(const Kernel& kernel, const Query<Real>& q, const Sides<Real>& sides) {
    Sides<Real> claimed;
    reference(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q, &claimed);
    return claimed.lhs == sides.lhs && claimed.rhs == sides.rhs;
  }
};

}  // namespace

const ProvedBounds& sphere_triangle_proved_bounds() {
  static const SphereTriangleBounds bounds;
  return bounds;
}

}  // namespace axiscert

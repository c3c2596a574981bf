// What the corpus keeps of sphere-triangle: the exact answers, and one query of all its images.
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/sphere_triangle/canonical_form.h"

namespace axiscert {
namespace {

// By CGAL, the exact formulae and MPFR.
ExactAnswers kept_answers(const StoredQuery& stored) {
  return std::visit(
      [](const auto& q) -> ExactAnswers {
        const ExactTruth truth = exact_truth(q, true);
        if (!truth.formula) return {truth.verdict, truth.touching};
        return {truth.verdict, truth.touching, squared_distance(q), truth.formula->strict, truth.formula->ties};
      },
      sphere_triangle_query(stored));
}

}  // namespace

extern const KeptAnswers sphere_triangle_answers = {kept_answers};
extern const ImagesOfQuery sphere_triangle_images = {least_image_text};

}  // namespace axiscert

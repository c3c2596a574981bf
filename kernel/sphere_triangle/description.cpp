#include "kernel/sphere_triangle/query.h"

#include <algorithm>
#include <string>

#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"
#include "kernel/predicate.h"

namespace axiscert {
namespace {

// "ax", "ay" and "az" form the group "a", a vertex; "r" is a group of its own.
PredicateEntry vertices() {
  PredicateEntry entry{"vertices", "every number finite, the radius not negative; -0 is 0", {}};
  for (const std::string_view name : coordinate_names) {
    entry.columns.push_back({name, name == "r" ? Role::length : Role::coordinate, name.substr(0, 1)});
  }
  entry.shared_columns = 9;  // the triangle
  return entry;
}

// The names with hyphens: "closest-point" for `closest_point`.
const EnumArray<Formulae, std::string>& spelt_formulae() {
  static const auto all = [] {
    EnumArray<Formulae, std::string> spelt = {
#define AXISCERT_NAME(name, type, kind) #name,
        AXISCERT_FORMULAE(AXISCERT_NAME)
#undef AXISCERT_NAME
    };
    for (std::string& name : spelt) std::replace(name.begin(), name.end(), '_', '-');
    return spelt;
  }();
  return all;
}

std::vector<PredicateMeasure> contact_measures() {
  constexpr std::string_view normal = "of the unit vector from the triangle's nearest point to the centre",
                             angle =
                                 "of the three, the angle in radians where the two are apart; and what a push by the "
                                 "exact depth leaves of it",
                             point = "of the triangle's point nearest to the centre, in the unit of the coordinates",
                             distance = "of the three, the distance relative to the scene, as a depth";
  return {{"separation", "distance of the centre less the radius, in the unit of the coordinates; NaN: none is given",
           "relative to the scene, in ulps of the number nearest to the exact one, and in u of the scene",
           MeasureKind::separation},
          {"feature", "0, 1, 2: vertex a, b, c; 3, 4, 5: edge ab, bc, ca; 6: face; NaN: none is given",
           "wrong where another part of the triangle is nearer to the centre", MeasureKind::feature},
          {"normal_x", normal, angle, MeasureKind::normal},
          {"normal_y", normal, angle, MeasureKind::normal},
          {"normal_z", normal, angle, MeasureKind::normal},
          {"point_x", point, distance, MeasureKind::point},
          {"point_y", point, distance, MeasureKind::point},
          {"point_z", point, distance, MeasureKind::point}};
}

Predicate described() {
  Predicate predicate{
      .id = "sphere-triangle",
      .asks = "does a closed solid sphere have a point in common with a closed triangle",
      .touching = "the distance from the centre to the triangle is exactly the radius",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {vertices()},
      .comparisons = {},
      .clauses = {},
      .measures = contact_measures(),
      .certified = "certified",
      .usual_formulae = "published",
      .has_strictness = true,
      .claims_arithmetic = true,
      .has_front = true,
      .is_implied = true,
  };
  for (const Formulae formulae : enumerators<Formulae>) {
    if (!has_comparisons(formulae)) predicate.methods.push_back(name(formulae));
  }
  for (const ComparisonInfo& comparison : comparisons) {
    predicate.comparisons.push_back({comparison.name, index_of(comparison.axis), comparison.is_radius});
  }
  for (std::size_t i = 0; i < axis_count; ++i) predicate.clauses.push_back({axis_names[i], axis_comparisons[i]});
  return checked(std::move(predicate));
}

}  // namespace

const Predicate& sphere_triangle_predicate() {
  static const Predicate predicate = described();
  return predicate;
}

std::string_view name(Formulae formulae) {
  return formulae == Formulae::none ? std::string_view() : spelt_formulae()[formulae];
}

Formulae formulae_of(const Kernel& kernel) {
  if (kernel.predicate != &sphere_triangle_predicate()) return Formulae::none;
  const auto& known = spelt_formulae();
  const auto found = std::find(known.begin(), known.end(), kernel.formulae);
  return static_cast<Formulae>(found - known.begin());
}

}  // namespace axiscert

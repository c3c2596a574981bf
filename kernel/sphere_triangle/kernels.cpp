// The kernels of sphere-triangle, one line each.
#include "kernel/kernel.h"
#include "kernel/permitted/graph.h"
#include "kernel/sphere_triangle/certified_kernels.h"
#include "kernel/sphere_triangle/forms/filter_kernels.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"
#include "kernel/sphere_triangle/forms/pair_forms.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/sphere_triangle/forms/simd.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr auto strict = Strictness::strict, nonstrict = Strictness::nonstrict, not_less = Strictness::not_less;

// A kernel with the scalar form only.
template <Formulae formulae, Strictness strictness = strict>
Kernel scalar(std::string id, std::string summary) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .predicate = &sphere_triangle_predicate(),
          .formulae = std::string(name(formulae)),
          .strictness = strictness,
          .exposes = has_comparisons(formulae) ? Exposure::sides : Exposure::verdict,
          .measure_count = measure_count_of<formulae>(),
          .binary32 = [](std::string_view) { return scalar_implementation<formulae, strictness, float>(); },
          .binary64 = [](std::string_view) { return scalar_implementation<formulae, strictness, double>(); },
          .takes_arithmetic = kind_of(formulae) == FormulaeKind::rung};
}

// A kernel that evaluates the formulae as they stand: the scalar form, and one query in each lane on every other target
// where forms/simd.cpp lists them.
template <Formulae formulae, Strictness strictness = strict>
Kernel evaluated(std::string id, std::string summary) {
  Kernel kernel = scalar<formulae, strictness>(std::move(id), std::move(summary));
  if (strictness == not_less || !has_simd_form(formulae)) return kernel;
  kernel.has_simd = true;
  // Numbers beside the verdict are the scalar form's on every target.
  const auto on = []<class Real>(std::string_view target, std::type_identity<Real>) {
    Implementation<Real> scalar = scalar_implementation<formulae, strictness, Real>();
    if (target == scalar_target) return scalar;
    Implementation<Real> there = simd_forms(formulae)->on<Real>(target, strictness);
    there.measure = scalar.measure;
    return there;
  };
  kernel.binary32 = [on](std::string_view target) { return on(target, std::type_identity<float>()); };
  kernel.binary64 = [on](std::string_view target) { return on(target, std::type_identity<double>()); };
  return kernel;
}

template <Strictness strictness>
Kernel packed(std::string id, std::string summary) {
  Kernel kernel = scalar<Formulae::published, strictness>(std::move(id), std::move(summary));
  kernel.takes_arithmetic = false;
  kernel.binary32 = [](std::string_view) { return packed_implementation<strictness, float>(); };
  kernel.binary64 = [](std::string_view) { return packed_implementation<strictness, double>(); };
  return kernel;
}

Kernel eigen(std::string id, std::string summary) {
  Kernel kernel = scalar<Formulae::published>(std::move(id), std::move(summary));
  kernel.is_reference = false;
  kernel.takes_arithmetic = false;
  kernel.binary32 = [](std::string_view) { return eigen_implementation<float>(); };
  kernel.binary64 = [](std::string_view) { return eigen_implementation<double>(); };
  return kernel;
}

constexpr std::string_view certified_proof =
    "where the query is of binary32, or of binary64 with numbers that are multiples of one power of two by integers "
    "of at most 126 bits: that the verdict is right, by Coq (certified_is_exact_within_286_bits, "
    "certified_is_exact_binary32), of margins, verdict and sizes of integers recorded from the code, if the signs told "
    "by the steps before are right. Coq proves the latter of the coarse step (coarse_known_is_sound64), of balls "
    "(balls_tell_right), and of the fine step in binary32 (fine_tells_right32) and, where nothing underflows, in "
    "binary64 (fine_known_is_sound). The deep step, that underflow and wider numbers are argued and tested. "
    "docs/proofs.md#the-certified-predicate-step-by-step has what is trusted besides";
constexpr std::string_view conservative_proof =
    "where the square of the scene's size is from 2^-42 to 2^60 in binary32, 2^-400 to 2^400 in binary64: that no "
    "contact is missed, by Coq, of the code as recorded (recorded_conservative_is_right32, "
    "recorded_conservative_is_right64). Other sizes, which are scaled first, are argued on paper: "
    "docs/proofs.md#the-conservative-test-of-the-certified-predicate";

// The certified kernels show only a verdict, whatever they compute on the way.
template <certified::Question question>
Kernel certified_kernel(std::string id, std::string summary, ProvedProperty proved, std::string_view proof) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .predicate = &sphere_triangle_predicate(),
          .exposes = Exposure::verdict,
          .binary32 = [](std::string_view target) { return certified_implementation<float>(target, question); },
          .binary64 = [](std::string_view target) { return certified_implementation<double>(target, question); },
          .has_simd = true,
          .is_reference = false,
          .proved = proved,
          .proof = proof};
}

// The exact answer with separation, feature, normal and point.
Kernel contact_kernel(std::string id, std::string summary) {
  Kernel kernel = certified_kernel<certified::Question::closed_sphere>(std::move(id), std::move(summary),
                                                                       ProvedProperty::nothing, {});
  kernel.binary32 = [](std::string_view target) { return contact_implementation<float>(target); };
  kernel.binary64 = [](std::string_view target) { return contact_implementation<double>(target); };
  kernel.measure_count = sphere_triangle_predicate().measures.size();
  return kernel;
}

// The filter of formulae whose non-strict form is right for every triangle. It shows only a verdict, whatever it
// computes.
template <FilterForm form>
Kernel filter_kernel(std::string id, std::string summary) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .predicate = &sphere_triangle_predicate(),
          .exposes = Exposure::verdict,
          .binary32 = [](std::string_view target) { return filter_implementation<float>(form, target); },
          .binary64 = [](std::string_view target) { return filter_implementation<double>(form, target); },
          .has_simd = true,
          .is_reference = false,
          .may_decline = true};
}

}  // namespace

// clang-format off
std::vector<Kernel> sphere_triangle_kernels() {
  using enum Formulae;
  return {
      evaluated<published>("published", "the article's last block: sixteen strict comparisons, seven axes"),
      evaluated<published, nonstrict>("nonstrict", "the same with >= in the nine side comparisons: right for degenerate triangles too"),
      evaluated<reduced>("reduced", "edge axes of degree 4, |A x B|^2 > rr e: the published signs over the reals"),
      evaluated<reduced, nonstrict>("reduced-nonstrict", "the same with >= in the nine side comparisons: right for every triangle"),
      evaluated<reduced_along>("reduced-along", "reduced, the edge normals along the edges: A x AB for A x B"),
      evaluated<reduced_along, nonstrict>("reduced-along-nonstrict", "the same with >= in the nine side comparisons: right for every triangle"),
      evaluated<reduced_determinant>("reduced-determinant", "reduced, the plane's offset as a determinant: C.(A x B) for A.V"),
      evaluated<reduced_shared>("reduced-shared", "reduced, V = A x B + B x C + C x A from the edges' normals: fewest operations"),
      evaluated<reduced_shared, nonstrict>("reduced-shared-nonstrict", "the same with >= in the nine side comparisons"),
      evaluated<ladder_0>("ladder-0", "nothing rewritten: normals of length 1, roots, divisions"),
      evaluated<ladder_1>("ladder-1", "then the plane: squared, one division by |V|"),
      evaluated<ladder_2>("ladder-2", "then the plane: no root, (A.V)^2 / (V.V) > rr"),
      evaluated<ladder_3>("ladder-3", "then the plane: no division, cross-multiplied"),
      evaluated<ladder_4>("ladder-4", "then the vertices: squared, differences distributed, A.B > A.A"),
      evaluated<ladder_5>("ladder-5", "then the edges: squared"),
      evaluated<ladder_6>("ladder-6", "then the edges: multiplied by e^2"),
      evaluated<ladder_7>("ladder-7", "then the edges: no division, Q = A e + d AB"),
      evaluated<ladder_8>("ladder-8", "then the edges: centred, d = A.AB"),
      evaluated<ladder_9>("ladder-9", "then the edges: d = A.B - A.A; this is published, bit for bit"),
      evaluated<edges_world_multiplied_rooted_6>("edges-world-multiplied-rooted-6", "ladder-7, the edges rooted: |P e - Q e| > r e"),
      evaluated<edges_world_divided_rooted_4>("edges-world-divided-rooted-4", "ladder-4, the edges by their normals: N = A x B - P x AB"),
      evaluated<edges_world_divided_squared_4>("edges-world-divided-squared-4", "ladder-5, the edges by their normals: |N|^2 / e > rr"),
      evaluated<edges_world_multiplied_rooted_4>("edges-world-multiplied-rooted-4", "the same without division, rooted: |N| > r |AB|"),
      evaluated<edges_world_multiplied_squared_4>("edges-world-multiplied-squared-4", "ladder-7, the edges by their normals: |N|^2 > rr e"),
      evaluated<edges_centred_divided_rooted_6>("edges-centred-divided-rooted-6", "ladder-4, the edges centred: Q = A - (d/e) AB, |Q| > r"),
      evaluated<edges_centred_divided_squared_6>("edges-centred-divided-squared-6", "ladder-5, the edges centred: Q.Q > rr"),
      evaluated<edges_centred_multiplied_rooted_6>("edges-centred-multiplied-rooted-6", "ladder-8, the edges rooted: |Q e| > r e"),
      evaluated<edges_centred_divided_rooted_4>("edges-centred-divided-rooted-4", "reduced, the edges divided and rooted: |A x B| / |AB| > r"),
      evaluated<edges_centred_divided_squared_4>("edges-centred-divided-squared-4", "reduced, the edges divided: |A x B|^2 / e > rr"),
      evaluated<edges_centred_multiplied_rooted_4>("edges-centred-multiplied-rooted-4", "reduced, the edges rooted: |A x B| > r |AB|"),
      evaluated<plane_divided_rooted>("plane-divided-rooted", "ladder-2, the plane rooted: |A.V| / |V| > r"),
      evaluated<plane_multiplied_rooted>("plane-multiplied-rooted", "ladder-3, the plane rooted: |A.V| > r |V|"),
      evaluated<minkowski>("minkowski", "the centre against three spheres, three cylinders and a prism; right for every triangle"),
      evaluated<closest_point>("closest-point", "closest point by Voronoi regions, then a distance; A = B gives 0/0"),
      evaluated<segments>("segments", "edge axes through the closest point of each segment, no vertex axes"),
      packed<strict>("packed", "published, one pair at a time: sixteen comparisons in four 4-lane compares"),
      packed<not_less>("packed-nonstrict", "the same with a >= b as !(b > a) in the sides: a NaN side holds"),
      eigen("eigen", "published, written with Eigen's vectors, whose reductions choose their order"),
      certified_kernel<certified::Question::closed_sphere>("certified", "the exact answer: filtered in the input's precision, then in doubles, then in integers", ProvedProperty::no_wrong_verdict, certified_proof),
      contact_kernel("contact", "the exact answer, with separation, feature, normal and point within stated bounds"),
      certified_kernel<certified::Question::conservative>("conservative", "never a missed contact; phantom depth at most 20 sqrt(u): 0.00489, in binary64 2.11e-7", ProvedProperty::no_missed_contact, conservative_proof),
      filter_kernel<FilterForm::reduced>("certified-filter", "reduced with thresholds proved of it as a program: separated, contact or undecided"),
      filter_kernel<FilterForm::published>("certified-filter-published", "the same with the published formulae, whose thresholds are wider"),
      evaluated<first_publication>("first-publication", "the article as first published: QC = C e + Q, wrong in exact arithmetic"),
      evaluated<vertex_typo>("vertex-typo", "the vertex section as printed: ac = dot(B, B), wrong in exact arithmetic"),
  };
}
// clang-format on

}  // namespace axiscert

namespace axiscert::permitted {
namespace {

using T = RecordedNumber;

portable::Problem<T> problem(auto&& load) {
  const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
  return {vector(0), vector(3), vector(6), vector(9), load(12), T(0.0)};
}

template <class F>
Recording recording(const Permissions& permissions, Strictness strictness) {
  return recorded(permissions, comparison_count, nonstrict_comparisons(strictness), [](auto&& load, auto&& sink) {
    F::comparisons(problem(load),
                   [&](Comparison which, const T& lhs, const T& rhs) { sink(index_of(which), lhs, rhs); });
  });
}

template <Formulae f>
void put(const Kernel& kernel, Recorder& found) {
  using F = FormulaeType<f>;
  if (formulae_of(kernel) != f) return;
  if constexpr (!has_comparisons(f)) {
    found = [](const Permissions& permissions) {
      return recorded_paths(permissions, [](auto&& load) { return F::separated(problem(load)); });
    };
  } else if constexpr (F::is_ring) {
    found = [s = kernel.strictness](const Permissions& permissions) { return recording<F>(permissions, s); };
  }
}

}  // namespace

Recorder sphere_triangle_recorder(const Kernel& kernel) {
  Recorder found;
#define AXISCERT_PUT(name, type, kind) put<Formulae::name>(kernel, found);
  AXISCERT_FORMULAE(AXISCERT_PUT)
#undef AXISCERT_PUT
  return found;
}

}  // namespace axiscert::permitted

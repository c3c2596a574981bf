// The probes of a diagnosis, and the values of the properties: an enum for each, with its names as files have them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/diagnosis/subject.h"
#include "kernel/base/enums.h"

namespace axiscert::diagnosis {

// The answer at a distance of exactly r, where no rounding is to blame.
enum class AtTouching : std::uint8_t { closed, open, neither };
// Triangles of which the centre lies on the one side or the other: front is the side of (B - A) x (C - A).
enum class Sides : std::uint8_t { both, front_only, back_only };
// An overlap before the motion: always a contact; not where nothing moves; only where the distance falls at first;
// never.
enum class Starts : std::uint8_t { reported, moving, approaching, ignored };
// Triangles of area 0: right on all; always separated; always contact; `invalid`; wrong on some.
enum class Degenerate : std::uint8_t { handled, skipped, always_hit, refused, wrong_on_some };
// Something is compared with a number that has a length in it; or the length of a quaternion with any number.
enum class Threshold : std::uint8_t { none_found, present, quaternions };
// The powers of two times which the answers are those at scale 1: all that the precision has, or fewer.
enum class Window : std::uint8_t { whole, limited };
// Subnormal numbers are numbers, or zero.
enum class Subnormals : std::uint8_t { kept, flushed };
// The sums of three products: x and y first; another pair first; fused multiply-add.
enum class Order : std::uint8_t { left_to_right, other_order, contracted };
// The operations of a built-in form: as they stand; changed as one permission of kernel/permitted allows; as several
// do.
enum class Evaluated : std::uint8_t { as_written, fused, flushed, faithful, reassociated, several };
// The precision of the computation against that of the query.
enum class Inner : std::uint8_t { narrower, own, wider };
// The same batch asked again.
enum class RepeatedBatch : std::uint8_t { same, differs };
// The same query in another place.
enum class Place : std::uint8_t { independent, depends };
// A length by which it answers as if a shape were larger, or smaller.
enum class Slack : std::uint8_t { none_found, early, late };
// The numbers beside the verdict. Separations: never above 0; with the other sign; of another thing (the predicate's
// contact likenesses); off by one length everywhere; wrong without a rule; right, and missing beside other numbers.
enum class Separations : std::uint8_t { right, never_positive, negated, against_plane, margin, scaled, wrong, missing };
// Normals: to the other side; of another thing; off by one angle everywhere; of another length than 1.
enum class Normals : std::uint8_t { right, flipped, of_centres, of_face, tilted, not_normalised, wrong, missing };
// Features: the same number whatever is nearest.
enum class Features : std::uint8_t { right, one_part, wrong, missing };
// Points of contact: of the body that has none; of two, each said to be the other's.
enum class Points : std::uint8_t { right, other_body, exchanged, wrong, missing };
// Clear queries that have a trait (fuzz/queries/capabilities.h).
enum class ByTrait : std::uint8_t { right, wrong };

}  // namespace axiscert::diagnosis

namespace axiscert {

#define AXISCERT_VALUES(Enum, count, names, ...)                            \
  template <>                                                               \
  inline constexpr std::size_t enum_count<diagnosis::Enum> = count;         \
  namespace diagnosis {                                                     \
  inline constexpr EnumArray<Enum, std::string_view> names = {__VA_ARGS__}; \
  constexpr std::string_view name(Enum value) { return names[value]; }      \
  }
AXISCERT_VALUES(AtTouching, 3, at_touching_names, "closed", "open", "neither")
AXISCERT_VALUES(Sides, 3, sides_names, "both", "front_only", "back_only")
AXISCERT_VALUES(Starts, 4, starts_names, "reported", "moving", "approaching", "ignored")
AXISCERT_VALUES(Degenerate, 5, degenerate_names, "handled", "skipped", "always_hit", "refused", "wrong_on_some")
AXISCERT_VALUES(Threshold, 3, threshold_names, "none_found", "present", "quaternions")
AXISCERT_VALUES(Window, 2, window_names, "whole", "limited")
AXISCERT_VALUES(Subnormals, 2, subnormals_names, "kept", "flushed")
AXISCERT_VALUES(Order, 3, order_names, "left_to_right", "other_order", "contracted")
AXISCERT_VALUES(Evaluated, 6, evaluated_names, "as_written", "fused", "flushed", "faithful", "reassociated", "several")
AXISCERT_VALUES(Inner, 3, inner_names, "narrower", "own", "wider")
AXISCERT_VALUES(RepeatedBatch, 2, repeated_names, "same", "differs")
AXISCERT_VALUES(Place, 2, place_names, "independent", "depends")
AXISCERT_VALUES(Slack, 3, slack_names, "none_found", "early", "late")
AXISCERT_VALUES(Separations, 8, separations_names, "right", "never_positive", "negated", "against_plane", "margin",
                "scaled", "wrong", "missing")
AXISCERT_VALUES(Normals, 8, normals_names, "right", "flipped", "of_centres", "of_face", "tilted", "not_normalised",
                "wrong", "missing")
AXISCERT_VALUES(Features, 4, features_names, "right", "one_part", "wrong", "missing")
AXISCERT_VALUES(Points, 5, points_names, "right", "other_body", "exchanged", "wrong", "missing")
AXISCERT_VALUES(ByTrait, 2, by_trait_names, "right", "wrong")
#undef AXISCERT_VALUES

}  // namespace axiscert

namespace axiscert::diagnosis {
// The probes, one for each property. Each asks the kernel, and gives a value only where the answers decide it.

// Probes whose scenes are the predicate's own, or made of its families and columns (fuzz/diagnosis/scenes.h);
// operation_order is of predicates with near ties alone, overlap_at_start of motions.
template <class Real>
ProbeFinding at_touching(Subject<Real>& subject);
template <class Real>
ProbeFinding sides_hit(Subject<Real>& subject);
template <class Real>
ProbeFinding overlap_at_start(Subject<Real>& subject);
template <class Real>
ProbeFinding degenerate_triangles(Subject<Real>& subject);
template <class Real>
ProbeFinding slack(Subject<Real>& subject);
template <class Real>
ProbeFinding subnormal_numbers(Subject<Real>& subject);
template <class Real>
ProbeFinding operation_order(Subject<Real>& subject);
template <class Real>
ProbeFinding inner_precision(Subject<Real>& subject);

// Probes that need nothing of the scene.
template <class Real>
ProbeFinding absolute_thresholds(Subject<Real>& subject);
template <class Real>
ProbeFinding range_window(Subject<Real>& subject);
template <class Real>
ProbeFinding repeated(Subject<Real>& subject);
template <class Real>
ProbeFinding nearest_form(Subject<Real>& subject);
template <class Real>
ProbeFinding evaluation(Subject<Real>& subject);
// Probes of a kernel that gives the same batch the same answers.
template <class Real>
ProbeFinding position_in_batch(Subject<Real>& subject);
template <class Real>
ProbeFinding batch_length(Subject<Real>& subject);
template <class Real>
ProbeFinding neighbours(Subject<Real>& subject);
// Probes of the numbers beside the verdicts of clear queries (contacts.cpp).
template <class Real>
ProbeFinding separations(Subject<Real>& subject);
template <class Real>
ProbeFinding normals(Subject<Real>& subject);
template <class Real>
ProbeFinding features(Subject<Real>& subject);
template <class Real>
ProbeFinding contact_points(Subject<Real>& subject);
// Probes of clear queries by their traits.
template <class Real>
ProbeFinding on_regions(Subject<Real>& subject);
template <class Real>
ProbeFinding on_triangle(Subject<Real>& subject);
template <class Real>
ProbeFinding on_obtuse(Subject<Real>& subject);
template <class Real>
ProbeFinding on_parallel(Subject<Real>& subject);
template <class Real>
ProbeFinding on_flat(Subject<Real>& subject);
template <class Real>
ProbeFinding on_aligned(Subject<Real>& subject);

}  // namespace axiscert::diagnosis

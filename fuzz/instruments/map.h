// The map of a kernel on a plane through query space: for each pixel, whether its comparisons, axes and verdict are
// wrong.
#pragma once

#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/instruments/plane.h"
#include "fuzz/files/query_file.h"
#include "kernel/kernel.h"

namespace axiscert {

// The class of a pixel in the picture of a verdict, an axis or a comparison. If several apply, the first in this order.
enum class PixelClass : std::uint8_t {
  no_query,           // not finite, or a radius below zero
  outside_limits,     // the kernel promises nothing there, whatever it says
  false_separation,   // the kernel wrongly says yes; for a verdict a missed contact
  missed_separation,  // the kernel wrongly says no; for a verdict a phantom contact
  undecided,          // the kernel declines to say
  invalid,            // it calls a valid query none
  unanswered,         // no answer, or one that is none
  not_finite,         // a right sign of a comparison whose computed sides are not both finite
  tie,                // exactly on the boundary: for a verdict, the sphere touches
  boundary,           // not yes, next to a pixel that is yes
  yes_uncertain,      // yes: holds, separates; within the uncertain band
  no_uncertain,       // no, within the uncertain band
  yes,                // yes, certainly
  no,
};
template <>
inline constexpr std::size_t enum_count<PixelClass> = 14;
inline constexpr std::size_t pixel_class_count = enum_count<PixelClass>;
inline constexpr EnumArray<PixelClass, std::string_view> pixel_class_names = {"no_query",
                                                                              "outside_limits",
                                                                              "false_separation",
                                                                              "missed_separation",
                                                                              "undecided",
                                                                              "invalid",
                                                                              "unanswered",
                                                                              "not_finite",
                                                                              "tie",
                                                                              "boundary",
                                                                              "yes_uncertain",
                                                                              "no_uncertain",
                                                                              "yes",
                                                                              "no"};
constexpr std::string_view name(PixelClass which) { return pixel_class_names[which]; }
// Whether the kernel said yes or no there, within its limits: only such a pixel shows anything about it.
constexpr bool is_decided(PixelClass pixel) {
  return pixel != PixelClass::no_query && pixel != PixelClass::outside_limits && pixel != PixelClass::undecided &&
         pixel != PixelClass::invalid && pixel != PixelClass::unanswered;
}

// The subject of one picture: the verdict, an axis or a comparison.
struct MapSubject {
  Level level;
  std::uint8_t index;  // 0 for the verdict
  bool operator==(const MapSubject&) const = default;
};
std::string_view name(const MapSubject& subject, const Predicate& predicate);
// The verdict, the axes and the comparisons, in this order; a comparison that is an axis by itself, of its name, once.
std::vector<MapSubject> map_subjects(const Predicate& predicate);

struct MapPlan {
  const Kernel* kernel;  // has to exist in the witness's precision
  std::string target;    // resolved
  StoredQuery witness;   // of the kernel's predicate
  Plane plane;
  std::vector<MapSubject> subjects;  // only the verdict if the kernel exposes no comparisons of its own formulae
};
// Whether anything but the verdict can be drawn.
bool has_comparison_maps(const Kernel& kernel);

struct MapPicture {
  MapSubject subject;
  std::vector<PixelClass> pixels;  // row by row, the uppermost first
  EnumArray<PixelClass, std::uint64_t> counts;

  std::uint64_t decided() const {
    std::uint64_t all = 0;
    for (const PixelClass c : enumerators<PixelClass>) all += is_decided(c) ? counts[c] : 0;
    return all;
  }
};

// Draws on all cores; the result is the same for any number of them. `report` counts pixels as queries. For every
// 4096th pixel, and for every 64th of those that needed integers of any size, the signs are decided again by CGAL, the
// exact formulae and MPFR: throws OracleDisagreement.
//
// A predicate without filters (Oracles::has_filters) is drawn by its oracles at every pixel, some hundred times as
// slowly, and has no uncertain band.
//
// The uncertain band of a comparison is the region where a bound does not determine its sign: the proved bound for the
// kernel's own sides if there is one and it covers the query (fuzz/search/confirm.h), otherwise that of the quickest
// filter (docs/error_model.md). For an axis and for a verdict, it is the region where the certain comparisons do not
// settle it.
std::vector<MapPicture> draw_map(const MapPlan& plan, const ShowProgress& report = {});

}  // namespace axiscert

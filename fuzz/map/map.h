// The map of a kernel on a plane through query space: pixel by pixel, where its comparisons, axes and verdicts are
// wrong.
#pragma once

#include <vector>

#include "exact/sphere_triangle/filters/cascade.h"
#include "exact/judge/judge.h"
#include "fuzz/map/plane.h"
#include "fuzz/files/query_file.h"
#include "kernel/kernel.h"

namespace axiscert {

// What a pixel shows of a verdict, an axis or a comparison. Where several hold, the first in this order.
enum class PixelClass : std::uint8_t {
  no_query,           // not finite, or a radius below zero
  false_separation,   // the kernel says yes wrongly; of a verdict a missed contact
  missed_separation,  // the kernel says no wrongly; of a verdict a phantom contact
  declined,           // no answer, or neither yes nor no
  not_finite,         // a right sign of a comparison whose computed sides are not both finite
  tie,                // exactly on the boundary: of a verdict, the sphere touches
  boundary,           // not yes, beside a pixel that is
  yes_uncertain,      // yes: holds, separates; in the uncertain band
  no_uncertain,       // no, in that band
  yes,                // certainly
  no,
};
inline constexpr std::size_t pixel_class_count = 11;
inline constexpr std::array<std::string_view, pixel_class_count> pixel_class_names = {
    "no_query", "false_separation", "missed_separation", "declined", "not_finite", "tie",
    "boundary", "yes_uncertain",    "no_uncertain",      "yes",      "no"};

// One picture: of the verdict, an axis or a comparison.
struct MapSubject {
  Level level;
  std::uint8_t index;  // 0 for the verdict
  bool operator==(const MapSubject&) const = default;
};
std::string_view name(const MapSubject& subject);
// The verdict, seven axes and sixteen comparisons, in this order.
std::vector<MapSubject> map_subjects();

struct MapPlan {
  const Kernel* kernel;  // exists in the witness's precision
  std::string target;    // resolved
  StoredQuery witness;
  Plane plane;
  std::vector<MapSubject> subjects;  // the verdict alone where the kernel shows no comparisons of its own formulae
};
// Whether there is anything but the verdict to draw.
bool has_comparison_maps(const Kernel& kernel);

struct MapPicture {
  MapSubject subject;
  std::vector<PixelClass> pixels;  // row by row, the uppermost first
  std::array<std::uint64_t, pixel_class_count> counts;
};

// On all cores; the same on any number of them. Of every 4096th pixel, and of each that needed integers of any size,
// every 64th, the signs are decided again by CGAL, the exact formulae and MPFR: throws OracleDisagreement.
//
// The uncertain band of a comparison is where a bound does not tell its sign: the proved bound of the kernel's own
// sides where there is one and the query is in its box (fuzz/search/proved.h), else that of the lanes of the filter
// (docs/error_model.md). Of an axis and of a verdict, where the certain comparisons do not settle it.
std::vector<MapPicture> draw_map(const MapPlan& plan);

}  // namespace axiscert

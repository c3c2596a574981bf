// Motions given by their ends: those of families in the entry `displacement`, with P1 = P + D rounded.
#include "fuzz/moving_sphere/parts.h"

namespace axiscert::moving_sphere {

// The families whose motions are taken.
extern const Family moving_sphere_general_family, moving_sphere_graze_family, moving_sphere_touch_end_family,
    moving_sphere_slide_family, moving_sphere_along_edge_family, moving_sphere_approach_family,
    moving_sphere_huge_d_family, moving_sphere_zero_d_family, moving_sphere_line_sweep_family,
    moving_sphere_point_family, moving_sphere_lattice_family, moving_sphere_scene_walk_family,
    moving_sphere_reach_family, moving_sphere_starts_family, moving_sphere_alongside_family,
    moving_sphere_far_past_family;

namespace {

// The place of P + D. `nearer`: seven tenths of its way from A, with digits of A's size, so that P1 - P has more
// digits than a number does where P is far.
enum class End { as_it_is, nearer };

// In both entries A is in columns 0 to 2, P in 9 to 11, and D or P1 in the three after it.
template <const Family& motions, End end, class Real>
void fill_ends(const StreamName& stream, std::uint64_t first, const MutableColumns<Real>& out) {
  if constexpr (sizeof(Real) == 4) motions.binary32(stream, first, out);
  else motions.binary64(stream, first, out);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < out.size; ++i) {
      const Real a = out.column[k][i], p1 = out.column[9 + k][i] + out.column[12 + k][i];
      out.column[12 + k][i] = end == End::nearer ? a + (p1 - a) * Real(0.7) : p1;
    }
  }
}

template <const Family& motions, End end = End::as_it_is, int version = 1>
constexpr Family ends_family(std::string_view name, const Situation& situation, std::string_view purpose,
                             bool exact_arithmetic = false) {
  return {.predicate = moving_sphere_predicate,
          .name = name,
          .purpose = purpose,
          .version = version,
          .exact_arithmetic = exact_arithmetic,
          .binary32 = fill_ends<motions, end, float>,
          .binary64 = fill_ends<motions, end, double>,
          .situation = &situation,
          .entry = MovingEnds::entry};
}

}  // namespace

extern const Family moving_sphere_ends_general_family = ends_family<moving_sphere_general_family>(
    "moving-sphere/ends_general", situation::everyday, "general, by its ends P and P1");
extern const Family moving_sphere_ends_graze_family =
    ends_family<moving_sphere_graze_family>("moving-sphere/ends_graze", situation::touching, "graze, by its ends");
extern const Family moving_sphere_ends_touch_family = ends_family<moving_sphere_touch_end_family>(
    "moving-sphere/ends_touch", situation::touching, "touch_end, by its ends: in touch at P1, or by ulps not");
extern const Family moving_sphere_ends_slide_family =
    ends_family<moving_sphere_slide_family>("moving-sphere/ends_slide", situation::parallel, "slide, by its ends");
extern const Family moving_sphere_ends_along_family = ends_family<moving_sphere_along_edge_family>(
    "moving-sphere/ends_along", situation::parallel, "along_edge, by its ends");
extern const Family moving_sphere_ends_approach_family = ends_family<moving_sphere_approach_family, End::nearer>(
    "moving-sphere/ends_approach", situation::far,
    "approach, by its ends, P1 nearer to A: P1 - P is no number of the precision");
extern const Family moving_sphere_ends_huge_family =
    ends_family<moving_sphere_huge_d_family>("moving-sphere/ends_huge", situation::far, "huge_d, by its ends");
extern const Family moving_sphere_ends_still_family = ends_family<moving_sphere_zero_d_family>(
    "moving-sphere/ends_still", situation::no_motion, "P1 = P, the static query");
extern const Family moving_sphere_ends_line_family = ends_family<moving_sphere_line_sweep_family>(
    "moving-sphere/ends_line", situation::zero_area, "line_sweep, by its ends");
extern const Family moving_sphere_ends_point_family =
    ends_family<moving_sphere_point_family>("moving-sphere/ends_point", situation::point, "point, by its ends");
// P1 is an integer of at most 2 m, and so is every difference of `lattice` again.
extern const Family moving_sphere_ends_lattice_family =
    ends_family<moving_sphere_lattice_family>("moving-sphere/ends_lattice", situation::small_integers,
                                              "lattice, by its ends: every operation of ends-twenty is exact", true);
extern const Family moving_sphere_ends_walk_family = in_metres(ends_family<moving_sphere_scene_walk_family>(
    "moving-sphere/ends_walk", situation::everyday, "scene_walk, by its ends, in metres"));
extern const Family moving_sphere_ends_reach_family = ends_family<moving_sphere_reach_family, End::as_it_is, 2>(
    "moving-sphere/ends_reach", situation::everyday, "reach, by its ends");
extern const Family moving_sphere_ends_starts_family =
    ends_family<moving_sphere_starts_family>("moving-sphere/ends_starts", situation::starts, "starts, by its ends");
extern const Family moving_sphere_ends_alongside_family = ends_family<moving_sphere_alongside_family, End::as_it_is, 2>(
    "moving-sphere/ends_alongside", situation::parallel, "alongside, by its ends");
extern const Family moving_sphere_ends_far_past_family =
    ends_family<moving_sphere_far_past_family>("moving-sphere/ends_far_past", situation::far, "far_past, by its ends");

}  // namespace axiscert::moving_sphere

#include "reports/wording/motion.h"

#include "reports/wording/summary.h"

namespace axiscert {

const char* const motion_note =
    "Late is after the exact first contact, early before the best time, the greatest number that is not late. A tunnel "
    "is how far the sphere goes in until a late time, or in a missed contact, as a share of its radius; with 1 its "
    "centre comes to the triangle. Angles are in radians, errors of points shares of the scene.";

const std::vector<std::string>& motion_columns() {
  static const std::vector<std::string> columns = {
      "contacts", "late",    "by ulps",        "by u",          "tunnel",       "early",           "by ulps",
      "by u",     "no time", "wrong features", "normal off by", "point off by", "missed, through", "missed, tunnel"};
  return columns;
}

std::vector<std::string> motion_cells(const FamilyRecord& family) {
  if (!family.motion) return {};
  const MotionTally& motion = *family.motion;
  if (!motion.time && motion.missed.deepest.best().is_zero()) return {};
  std::vector<std::string> cells = {thousands(motion.hits)};
  if (!motion.time) {
    cells.resize(9, "-");
  } else {
    const TimeTally& time = *motion.time;
    const auto put_side = [&](std::uint64_t count, const TimeErrors& errors) {
      cells.push_back(thousands(count));
      cells.push_back(error_amount(errors.largest_ulps.best()));
      cells.push_back(error_amount(errors.largest_in_u.best()));
    };
    put_side(time.late, time.late_errors);
    cells.push_back(error_amount(time.late_tunnels.deepest.best()));
    put_side(time.early, time.early_errors);
    cells.push_back(thousands(time.none + time.invalid));
  }
  cells.push_back(motion.feature ? thousands(motion.feature->wrong) : "-");
  cells.push_back(motion.normal ? amount(motion.normal->largest_angle.best(), 3) : "-");
  cells.push_back(motion.point ? amount(motion.point->largest_error.best(), 3) : "-");
  cells.push_back(thousands(motion.missed.through));
  cells.push_back(error_amount(motion.missed.deepest.best()));
  return cells;
}

}  // namespace axiscert

#include "reports/wording/motion.h"

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string count_in(const Json& object, const char* member) { return thousands(object[member].get<std::uint64_t>()); }

}  // namespace

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

std::vector<std::string> motion_cells(const Json& family) {
  const auto found = family.find("motion");
  if (found == family.end()) return {};
  const Json &motion = *found, &time = motion["time"], &missed = motion["missed"];
  if (time.is_null() && missed["deepest_tunnel"] == 0) return {};
  std::vector<std::string> cells = {count_in(motion, "hits")};
  if (time.is_null()) {
    cells.resize(9, "-");
  } else {
    const auto put_side = [&](const char* side, const Json& errors) {
      cells.push_back(count_in(time, side));
      cells.push_back(error_amount(errors["largest_ulps"]));
      cells.push_back(error_amount(errors["largest_in_u"]));
    };
    put_side("late", time["late_errors"]);
    cells.push_back(error_amount(time["late_tunnels"]["deepest_tunnel"]));
    put_side("early", time["early_errors"]);
    cells.push_back(thousands(time["none"].get<std::uint64_t>() + time["invalid"].get<std::uint64_t>()));
  }
  const auto put = [&](const char* measure, const auto& text) {
    cells.push_back(motion[measure].is_null() ? "-" : text(motion[measure]));
  };
  put("feature", [](const Json& feature) { return count_in(feature, "wrong"); });
  put("normal", [](const Json& normal) { return amount(normal["largest_angle"].get<double>(), 3); });
  put("point", [](const Json& point) { return amount(point["largest_error"].get<double>(), 3); });
  cells.push_back(count_in(missed, "through"));
  cells.push_back(error_amount(missed["deepest_tunnel"]));
  return cells;
}

}  // namespace axiscert

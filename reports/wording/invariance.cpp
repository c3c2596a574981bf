#include "reports/wording/invariance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string compared_text(const Json& size) {
  const double least = size["least"].get<double>(), greatest = size["greatest"].get<double>();
  const double near = std::sqrt(least) * std::sqrt(greatest);
  return fmt::format("near {} (squared {}) were compared with {}", amount(near, 4), amount(near * near, 4),
                     size["quantity"].get<std::string>());
}

// Empty where no answer is wrong in this direction.
std::string direction_text(const Json& sizes, const std::string& where) {
  if (sizes["bases"] == 0) return "";
  std::vector<std::string> texts;
  for (const Json& size : sizes["compared"]) texts.push_back(compared_text(size));
  if (texts.empty()) return fmt::format("where numbers are {}, and no one number of its own explains it", where);
  return fmt::format("where numbers are {}, as if an absolute number {}", where, fmt::join(texts, ", or one "));
}

}  // namespace

const Json* changes_of(const Json& family, const std::string& kind) {
  const auto invariance = family.find("invariance");
  if (invariance == family.end()) return nullptr;
  const auto found = invariance->find(kind);
  return found == invariance->end() ? nullptr : &*found;
}

const Json* units_of(const Json& family) {
  const Json* scale = changes_of(family, "scale");
  return scale == nullptr || (*scale)["range"].is_null() ? nullptr : scale;
}

int least_size(const Json& by_size) {
  int least = std::numeric_limits<int>::max();
  for (const auto& [text, count] : by_size.items()) least = std::min(least, std::stoi(text));
  return least;
}

std::string powers_text(const Json& by_size) {
  std::optional<int> down, up;  // the powers nearest to 1
  for (const auto& [text, count] : by_size.items()) {
    const int exponent = std::stoi(text);
    if (exponent < 0) down = std::max(down.value_or(exponent), exponent);
    else up = std::min(up.value_or(exponent), exponent);
  }
  std::vector<std::string> parts;
  if (down) parts.push_back(fmt::format("from 2^{} down", *down));
  if (up) parts.push_back(fmt::format("from 2^{} up", *up));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string absolute_number_text(const Json& wrong) {
  std::vector<std::string> texts;
  for (const auto& [member, where] : {std::pair{"where_small", "small"}, std::pair{"where_large", "large"}}) {
    const std::string text = direction_text(wrong[member], where);
    if (!text.empty()) texts.push_back(text);
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

UnitChange unit_change(const Json& scale) {
  const Json& wrong = scale["wrong"];
  UnitChange found;
  found.count = wrong["count"].get<std::uint64_t>();
  if (found.count != 0) {
    found.first = wrong["first"];
    found.what = fmt::format(
        "wrong verdicts in another unit of length alone (times powers of two {}), on queries that are no close calls; "
        "{}",
        powers_text(wrong["by_size"]), absolute_number_text(wrong));
    return found;
  }
  found.count = scale["changed"].get<std::uint64_t>();
  found.first = scale["first"];
  if (found.count == 0) return found;
  found.what = fmt::format("verdicts that change with the unit of length (times powers of two {})",
                           powers_text(scale["by_size"]));
  const std::string number = absolute_number_text(wrong);
  if (!number.empty()) found.what += "; " + number;
  return found;
}

}  // namespace axiscert

#include "reports/wording/invariance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string compared_text(const ComparedQuantity& size) {
  const double near = std::sqrt(size.least) * std::sqrt(size.greatest);
  return fmt::format("near {} (squared {}) were compared with {}", amount(near, 4), amount(near * near, 4),
                     size.quantity);
}

// Empty where no answer is wrong in this direction.
std::string direction_text(const AbsoluteSizeRecord& sizes, std::string_view where) {
  if (sizes.bases == 0) return "";
  std::vector<std::string> texts;
  for (const ComparedQuantity& size : sizes.compared) texts.push_back(compared_text(size));
  if (texts.empty()) return fmt::format("where numbers are {}, and no one number of its own explains it", where);
  return fmt::format("where numbers are {}, as if an absolute number {}", where, fmt::join(texts, ", or one "));
}

}  // namespace

const ImageChangesRecord* changes_of(const FamilyRecord& family, ImageKind kind) {
  if (!family.invariance) return nullptr;
  const auto found = family.invariance->find(kind);
  return found == family.invariance->end() ? nullptr : &found->second;
}

const ImageChangesRecord* units_of(const FamilyRecord& family) {
  const ImageChangesRecord* scale = changes_of(family, ImageKind::scale);
  return scale != nullptr && scale->range.value_or(std::nullopt) ? scale : nullptr;
}

std::string powers_text(const CountsBySize& by_size) {
  std::optional<int> down, up;  // the powers nearest to 1
  for (const auto& [exponent, count] : by_size) {
    if (exponent < 0) down = exponent;
    else if (!up) up = exponent;
  }
  std::vector<std::string> parts;
  if (down) parts.push_back(fmt::format("from 2^{} down", *down));
  if (up) parts.push_back(fmt::format("from 2^{} up", *up));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string absolute_number_text(const UnitFaultsRecord& wrong) {
  std::vector<std::string> texts = {direction_text(wrong.where_small, "small"),
                                    direction_text(wrong.where_large, "large")};
  std::erase(texts, "");
  return fmt::format("{}", fmt::join(texts, "; "));
}

UnitChange unit_change(const ImageChangesRecord& scale) {
  const UnitFaultsRecord wrong = scale.wrong.value_or(UnitFaultsRecord());
  UnitChange found;
  found.count = wrong.count;
  if (found.count != 0) {
    found.first = wrong.first;
    found.what = fmt::format(
        "wrong verdicts in another unit of length alone (times powers of two {}), on queries that are no close calls; "
        "{}",
        powers_text(wrong.by_size), absolute_number_text(wrong));
    return found;
  }
  found.count = scale.changed;
  found.first = scale.first;
  if (found.count == 0) return found;
  found.what =
      fmt::format("verdicts that change with the unit of length (times powers of two {})", powers_text(scale.by_size));
  const std::string number = absolute_number_text(wrong);
  if (!number.empty()) found.what += "; " + number;
  return found;
}

}  // namespace axiscert

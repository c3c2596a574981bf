#include "fuzz/record/record.h"

#include <algorithm>
#include <cmath>

#include "fuzz/text/json_form.h"

namespace axiscert {

CriticalRadiusRecord summary_of(CriticalRadiusTally tally) {
  std::vector<double>& errors = tally.errors_ulps;
  const auto count_if = [&](const auto& is) {
    return static_cast<std::uint64_t>(std::count_if(errors.begin(), errors.end(), is));
  };
  CriticalRadiusRecord summary;
  summary.sampled = errors.size() + tally.unbounded;
  summary.unbounded = tally.unbounded;
  summary.unanswered = tally.unanswered;
  summary.undecided = tally.undecided;
  summary.invalid = tally.invalid;
  if (errors.empty()) return summary;
  const std::size_t middle = (errors.size() - 1) / 2;
  std::sort(errors.begin(), errors.end());
  summary.signed_median_ulps = SignedNumber{errors[middle]};
  summary.early = count_if([](double error) { return error < 0; });
  // The least float that is not below the distance is up to one ulp above the distance's nearest.
  summary.late = count_if([](double error) { return error > 1; });
  for (double& error : errors) error = std::abs(error);
  std::sort(errors.begin(), errors.end());
  summary.median_ulps = errors[middle];
  summary.largest_ulps = errors.back();
  return summary;
}

Json JsonForm<RequiredLevels>::write(const RequiredLevels& value) {
  if (value.levels.empty()) return nullptr;
  return value.levels.size() == 1 ? json_of(value.levels.front()) : json_of(value.levels);
}
void JsonForm<RequiredLevels>::read(const JsonPlace& place, RequiredLevels& into) {
  into = {};
  if (place.value().is_null()) return;
  if (place.value().is_array()) {
    if (place.value().size() < 2) place.refuse("with too few items");
    read_json(place, into.levels);
  } else {
    read_json(place, into.levels.emplace_back());
  }
}
Json JsonForm<RequiredLevels>::schema() {
  Json several = json_schema_of<std::vector<LevelText>>();
  several["minItems"] = 2;
  return {{"anyOf", {{{"type", "null"}}, json_schema_of<LevelText>(), std::move(several)}}};
}

Json JsonForm<GroupNumbers>::write(const GroupNumbers& value) {
  return value.numbers.size() == 1 ? json_of(value.numbers.front()) : json_of(value.numbers);
}
void JsonForm<GroupNumbers>::read(const JsonPlace& place, GroupNumbers& into) {
  into = {};
  if (!place.value().is_array()) return read_json(place, into.numbers.emplace_back());
  if (place.value().size() < 2) place.refuse("with too few items");
  if (place.value().size() > 64) place.refuse("with too many items");
  read_json(place, into.numbers);
}
Json JsonForm<GroupNumbers>::schema() {
  Json several = json_schema_of<std::vector<HexNumber>>();
  several["minItems"] = 2;
  several["maxItems"] = 64;
  return {{"anyOf", {json_schema_of<HexNumber>(), std::move(several)}}};
}

}  // namespace axiscert

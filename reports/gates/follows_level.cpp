// follows=E: what is said beside the verdict on an exact image of a query is what is said of the query, mapped as it
// is.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

double most_difference(const AskedLevel& asked) {
  return number_argument(asked, {"E", "a share of the extent, and an angle in radians, from 0 to 1", "0.001", 0, 1});
}

// The families of the run's predicate whose images are maps of places.
std::string families_of_images(const Subject& subject) {
  std::vector<std::string> options;
  for (const Family* family : families_of(predicate_of(subject.record().plan))) {
    const ImageGroup* group = image_group(family->name);
    if (group != nullptr && group->parts == 1 && !subject.families().contains(family->name))
      options.push_back(fmt::format("--family {}", family->name));
  }
  return options.empty() ? "no other family of this predicate makes one"
                         : fmt::format("add {}", fmt::join(options, " "));
}

void add_failures(const Subject& subject, const std::string& family, const ImageNumbersRecord& numbers, double most,
                  std::vector<Failure>& failures) {
  // The record has the worst pair, and not how many are worse than is allowed.
  const auto add = [&](const std::optional<double>& largest, const char* what, const char* unit,
                       const std::optional<AddressPair>& pair) {
    if (!largest || *largest <= most) return;
    subject.add_pair(failures, family, 1,
                     fmt::format("{} of an image off by {:.4g} {} from what its query has: {} is allowed", what,
                                 *largest, unit, most),
                     pair);
  };
  add(numbers.largest_separation, "the separation", "of the extent", numbers.worst_separation);
  add(numbers.largest_angle, "the normal", "radians", numbers.worst_angle);
  add(numbers.largest_point, "a point", "of the extent", numbers.worst_point);
  subject.add_pair(failures, family, numbers.features.value_or(0),
                   "images with another feature than their query, one of the two wrong", numbers.first_feature);
  subject.add_pair(failures, family, numbers.lost,
                   "images with a number that their query lacks, or without one that it has", numbers.first_lost);
}

LevelFindings judge_follows(const AskedLevel& asked, const Subject& subject) {
  const double most = most_difference(asked);
  LevelFindings found;
  ImageNumbersRecord all;
  bool has_images = false;
  std::vector<std::string> families;
  for (const auto& [family, result] : subject.families()) {
    has_images |= result.asymmetry.has_value();
    const ImageNumbersRecord* numbers =
        result.asymmetry && result.asymmetry->numbers ? &*result.asymmetry->numbers : nullptr;
    if (numbers == nullptr || numbers->compared == 0) {
      found.unseen.push_back(family);
      continue;
    }
    all.compared += numbers->compared;
    all.separations += numbers->separations;
    all.angles += numbers->angles;
    all.points += numbers->points;
    all.compared_features += numbers->compared_features;
    families.push_back(family);
    found.families[family] = {numbers->images, numbers->compared};
    add_failures(subject, family, *numbers, most, found.failures);
  }
  if (all.compared == 0) {
    found.not_checked =
        has_images ? "the kernel gives no separation, feature, normal or point beside two images' verdicts"
                   : fmt::format("no answered query is an exact image of another; {}", families_of_images(subject));
    return found;
  }
  found.covers = fmt::format(
      "{} queries of {}, each an exact image of another: {} separations, {} features, {} normals and the points of {}",
      thousands(all.compared), fmt::join(families, ", "), thousands(all.separations), thousands(all.compared_features),
      thousands(all.angles), thousands(all.points));
  found.leaves_out =
      "images with another verdict, which invariant=KIND asks about; where two answers are right, either";
  return found;
}

constexpr std::string_view certified_share[] = {"0.001"};

}  // namespace

extern const GateLevel follows_level = {
    .usage = "follows=E",
    .meaning = "no number beside the verdict on an exact image of a query that is off by more than E from the query's",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format(
              "no separation or point of an image off by more than {} of the extent from what its query has, no "
              "normal by more radians, and no other feature",
              most_difference(asked));
        },
    .judge = judge_follows,
    .in_certificates = certified_share};

}  // namespace axiscert

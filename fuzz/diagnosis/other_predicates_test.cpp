// Probes on kernels of predicates other than sphere-triangle: of each value one that is so, and one that is not.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/diagnosis/made_of_any_predicate_testing.h"
#include "fuzz/diagnosis/probes/probes.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using namespace made;

constexpr Precision single = Precision::binary32, twice = Precision::binary64;

template <class Real>
diagnosis::ProbeFinding found_of(const Kernel& kernel, const std::string& property, std::uint64_t seed) {
  using namespace diagnosis;
  const std::map<std::string, ProbeFinding (*)(Subject<Real>&)> probes = {
      {"touching", at_touching<Real>},
      {"sides", sides_hit<Real>},
      {"overlap_at_start", overlap_at_start<Real>},
      {"degenerate_triangles", degenerate_triangles<Real>},
      {"subnormal_numbers", subnormal_numbers<Real>},
      {"operation_order", operation_order<Real>},
      {"inner_precision", inner_precision<Real>},
      {"absolute_threshold", absolute_thresholds<Real>},
      {"range_window", range_window<Real>}};
  DiagnosisOptions options;
  options.precision = precision_of<Real>;
  options.seed = seed;
  Subject<Real> subject(kernel, options);
  return probes.at(property)(subject);
}
diagnosis::ProbeFinding found_of(const Kernel& kernel, Precision precision, const std::string& property,
                                 std::uint64_t seed = 1) {
  return precision == single ? found_of<float>(kernel, property, seed) : found_of<double>(kernel, property, seed);
}

// The value that a probe has to find of a kernel.
struct Row {
  std::string property, value;
  Precision precision;
  Kernel kernel;
};

std::vector<Row> rows() {
  const Kernel &moving = find_kernel("moving-sphere/twenty-nonstrict"), &boxes = find_kernel("box-box/projected"),
               &triangle = find_kernel("box-triangle/thirteen");
  const Verdict apart = Verdict::separated, hit = Verdict::contact, refused = Verdict::invalid;
  return {
      {"touching", "closed", single, moving},
      {"touching", "open", single, opened(moving)},
      {"touching", "neither", twice, half_opened(moving)},
      {"touching", "not_known", single, with_slack(moving)},
      {"touching", "closed", twice, boxes},
      {"touching", "open", twice, opened(boxes)},
      {"touching", "neither", single, half_opened(boxes)},
      {"touching", "closed", single, triangle},
      {"touching", "open", twice, opened(triangle)},
      {"touching", "not_known", single, with_slack(triangle)},
      {"touching", "not_asked", single, find_kernel("box-triangle/thirteen-minmax")},
      {"sides", "both", single, moving},
      {"sides", "front_only", single, one_sided(moving, true)},
      {"sides", "back_only", twice, one_sided(moving, false)},
      {"sides", "both", single, find_kernel("moving-sphere/ends-twenty")},
      {"sides", "both", twice, triangle},
      {"sides", "front_only", twice, one_sided(triangle, true)},
      {"sides", "back_only", single, one_sided(triangle, false)},
      {"sides", "not_asked", single, boxes},
      {"overlap_at_start", "reported", single, moving},
      {"overlap_at_start", "reported", twice, find_kernel("moving-sphere/ends-twenty-nonstrict")},
      {"overlap_at_start", "moving", twice, missing_starts(moving, MissedStarts::still)},
      {"overlap_at_start", "approaching", single, missing_starts(moving, MissedStarts::leaving_and_still)},
      {"overlap_at_start", "ignored", twice, missing_starts(moving, MissedStarts::all_starts)},
      {"overlap_at_start", "not_asked", single, boxes},
      {"degenerate_triangles", "handled", single, moving},
      {"degenerate_triangles", "wrong_on_some", single, find_kernel("moving-sphere/twenty")},
      {"degenerate_triangles", "skipped", twice, flat_triangles(moving, apart)},
      {"degenerate_triangles", "always_hit", single, flat_triangles(moving, hit)},
      {"degenerate_triangles", "refused", single, flat_triangles(moving, refused)},
      {"degenerate_triangles", "handled", twice, triangle},
      {"degenerate_triangles", "skipped", single, flat_triangles(triangle, apart)},
      {"degenerate_triangles", "always_hit", twice, flat_triangles(triangle, hit)},
      {"degenerate_triangles", "not_asked", single, boxes},
      {"subnormal_numbers", "kept", single, moving},
      {"subnormal_numbers", "kept", twice, moving},
      {"subnormal_numbers", "flushed", single, flushing(moving)},
      {"subnormal_numbers", "flushed", twice, flushing(moving)},
      {"subnormal_numbers", "kept", single, boxes},
      {"subnormal_numbers", "flushed", single, flushing(boxes)},
      {"subnormal_numbers", "kept", twice, triangle},
      {"subnormal_numbers", "flushed", twice, flushing(triangle)},
      {"inner_precision", "own", twice, moving},
      {"inner_precision", "narrower", twice, computing_in<float>(moving)},
      {"inner_precision", "wider", single, computing_in<double>(moving)},
      {"inner_precision", "not_known", single, moving},
      {"inner_precision", "own", twice, boxes},
      {"inner_precision", "narrower", twice, computing_in<float>(boxes)},
      {"inner_precision", "wider", single, computing_in<double>(boxes)},
      {"inner_precision", "not_asked", twice, triangle},
      {"operation_order", "not_asked", twice, moving},
      {"absolute_threshold", "none_found", single, moving},
      {"absolute_threshold", "present", single, clamped(moving)},
      {"absolute_threshold", "none_found", twice, find_kernel("box-box/textbook")},
      {"absolute_threshold", "present", twice, clamped(find_kernel("box-box/textbook"))},
      {"absolute_threshold", "present", single, clamped(find_kernel("box-box/cofactor-turned"))},
      {"absolute_threshold", "none_found", twice, triangle},
      {"absolute_threshold", "present", twice, clamped(triangle)},
  };
}

TEST(DiagnosisOfOtherPredicatesLong, FindsWhatIsSo) {
  for (const Row& row : rows()) {
    const diagnosis::ProbeFinding found = found_of(row.kernel, row.precision, row.property);
    EXPECT_EQ(found.value, row.value) << fmt::format("{} in {}: {}: {} {}", row.kernel.id, name(row.precision),
                                                     row.property, found.sentence, found.measured.dump());
    EXPECT_FALSE(found.sentence.empty());
  }
}

TEST(DiagnosisOfOtherPredicatesLong, FindsItWithOtherSeeds) {
  for (const std::uint64_t seed : {2, 3}) {
    for (const Row& row : rows()) {
      // A kernel that is so may be not known with another seed, but nothing else.
      const diagnosis::ProbeFinding found = found_of(row.kernel, row.precision, row.property, seed);
      EXPECT_TRUE(found.value == row.value || found.value == not_known)
          << fmt::format("{} in {}, seed {}: {} is {}: {} {}", row.kernel.id, name(row.precision), seed, row.property,
                         found.value, found.sentence, found.measured.dump());
    }
  }
}

TEST(DiagnosisOfOtherPredicates, HasAKernelForEachValueThatTheyCanHave) {
  std::map<std::string, std::set<std::string>> by_property;
  for (const Row& row : rows()) by_property[row.property].insert(row.value);
  for (const PropertyKind& kind : property_kinds()) {
    const auto found = by_property.find(std::string(kind.name));
    if (found == by_property.end() || found->second == std::set<std::string>{"not_asked"}) continue;
    for (const std::string_view value : kind.values)
      EXPECT_TRUE(found->second.contains(std::string(value))) << kind.name << " " << value;
  }
}

// The probes that need nothing of the scene are asked of every test, and those that are not say why in a sentence.
TEST(DiagnosisOfOtherPredicates, AsksWhatNeedsNothingOfTheScene) {
  for (const char* id : {"moving-sphere/twenty", "box-triangle/thirteen"}) {
    DiagnosisOptions options;
    const Diagnosis diagnosis = diagnose(find_kernel(id), options);
    for (const auto& [property, value] : std::map<std::string, std::string>{{"repeated", "same"},
                                                                            {"position_in_batch", "independent"},
                                                                            {"batch_length", "independent"},
                                                                            {"neighbours", "independent"}}) {
      EXPECT_EQ(diagnosis.find(property)->value, value) << id << ": " << diagnosis.find(property)->sentence;
    }
    EXPECT_EQ(diagnosis.find("operation_order")->value, not_asked);
    EXPECT_THAT(diagnosis.find("operation_order")->sentence, HasSubstr("sphere-triangle"));
    for (const Property& property : diagnosis.properties) EXPECT_FALSE(property.sentence.empty()) << property.name;
  }
}

}  // namespace
}  // namespace axiscert

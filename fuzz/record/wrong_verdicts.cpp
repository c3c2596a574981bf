#include "fuzz/record/wrong_verdicts.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/queries/capabilities.h"
#include "fuzz/record/tally.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

// The nearest binary64 of each: a compiler rounds a literal so.
constexpr double powers_of_ten[] = {1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10,
                                    1e-9,  1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0};
static_assert(std::size(powers_of_ten) == decade_count - 2);

}  // namespace

std::size_t decade_of(double depth) {
  if (depth == 0) return 0;
  return 1 + static_cast<std::size_t>(std::upper_bound(std::begin(powers_of_ten), std::end(powers_of_ten), depth) -
                                      std::begin(powers_of_ten));
}

std::size_t decade_of(DepthOf& depth) {
  if (depth.is_touching()) return 0;
  const auto above_zero = [](double x) { return std::max(decade_of(x), std::size_t{1}); };
  const std::size_t low = above_zero(depth.at_least());
  return low == above_zero(depth.at_most()) ? low : above_zero(depth.exactly());
}

std::string decade_name(std::size_t decade) {
  if (decade == 0) return "zero";
  if (decade == 1) return "less";
  return std::to_string(static_cast<int>(decade) - 2 + least_decade);
}

bool WrongBothWays::are_exchanged() const {
  const auto nearly_all = [](std::uint64_t wrong, std::uint64_t all) { return all >= 8 && 20 * wrong >= 19 * all; };
  return separated + contact >= 64 && nearly_all(false_contact, separated) && nearly_all(false_separation, contact);
}

std::string WrongBothWays::text(const Kernel& kernel) const {
  return fmt::format(
      "its verdicts are exchanged: it says contact (0) on {} of {} queries where the two are apart, and separated (1) "
      "on "
      "{} of {} where they are in contact; the values are in {}",
      false_contact, separated, false_separation, contact,
      kernel.file.empty() || plugin::is_program(kernel) ? "docs/pipe.md" : "axiscert/plugin.h");
}

void DepthTally::count(FlipKind kind, std::size_t decade) {
  ++of(kind)[decade];
  deep += decade >= decade_of(1e-3);
}

void count_depth(DepthTally& depths, EngineTally& engine, FlipKind kind, DepthOf& depth) {
  const std::size_t decade = decade_of(depth);
  depths.count(kind, decade);
  const double threshold = depth.engine_threshold();
  if (depth.at_most() <= threshold) return;
  if (depth.at_least() > threshold || depth.exactly() > threshold) engine.wrong.count(kind, decade);
}

namespace {

bool is_at_most(double bound, DepthOf& depth) {
  if (depth.at_most() <= bound) return true;
  return depth.at_least() <= bound && depth.exactly() <= bound;
}

// class_of(input_classes()), without the depth and the shape where they do not decide.
template <class Real>
InputClass class_of_wrong(const Query<Real>& q, bool is_touching, DepthOf& depth, bool use_filter) {
  if (is_touching) return InputClass::tie;
  if (is_at_most(near_tie_depth<Real>, depth)) return InputClass::near_tie;
  const InputClassSet shape = shape_classes(q, use_filter);
  return shape.empty() ? InputClass::ordinary : class_of(shape);
}

}  // namespace

bool has_input_classes(const Kernel& kernel) {
  const Capabilities& has = capabilities_of(*kernel.predicate);  // a screen counts them
  return has.input_classes != nullptr && has.screens != nullptr && !has_reference(kernel);
}

template <class Real>
void count_class(ClassTally& tally, std::uint64_t position, FlipKind kind, const Query<Real>& q, bool is_touching,
                 DepthOf& depth, bool use_filter) {
  ClassCount& count = tally.classes[class_of_wrong(q, is_touching, depth, use_filter)];
  ++(kind == FlipKind::false_separation ? count.false_separation : count.false_contact);
  if (count.deepest.could_keep({depth.at_most(), position})) count.deepest.offer({depth.exactly(), position});
  if (position < nearest_queries) tally.first_wrong.push_back(position);
}
template void count_class(ClassTally&, std::uint64_t, FlipKind, const Query<float>&, bool, DepthOf&, bool);
template void count_class(ClassTally&, std::uint64_t, FlipKind, const Query<double>&, bool, DepthOf&, bool);

}  // namespace axiscert

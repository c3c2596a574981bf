#include "fuzz/campaign/counts/class_tally.h"

#include "fuzz/campaign/counts/tally.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {
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
  return has.input_classes != nullptr && has.screens != nullptr && (kernel.formulae.empty() || !kernel.is_reference);
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

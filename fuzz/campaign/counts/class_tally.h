// Wrong verdicts by the class of the input: what is known of why a kernel is wrong whose links do not say it.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/judge/judge.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/campaign/counts/leaders.h"
#include "kernel/kernel.h"

namespace axiscert {

// Whether wrong verdicts of a kernel are counted by class: where it has no reference, its links are `unattributed`, or
// the specification's alone. Predicates without InputClasses have none.
bool has_input_classes(const Kernel& kernel);

// A nearest kernel is looked for on this many of the first queries of a source (fuzz/confirm/nearest_kernel.h).
inline constexpr std::uint64_t nearest_queries = 1024;

struct ClassCount {
  std::uint64_t false_separation = 0, false_contact = 0;
  Leaders<double> deepest;  // of both kinds, ranked by depth

  static constexpr std::string_view about = "The wrong verdicts on input of one class.";
  static constexpr auto fields(auto&& visit) {
    return visit(field(&ClassCount::false_separation, {"false_separation", "Missed contacts."}),
                 field(&ClassCount::false_contact, {"false_contact", "Phantom contacts."}),
                 field(&ClassCount::deepest, {"deepest", "The greatest depth of them.", "of the scene"}));
  }
};

// Empty for a kernel without classes. The result of merging does not depend on the order.
struct ClassTally {
  EnumArray<InputClass, ClassCount> classes;
  std::vector<std::uint64_t> first_wrong;  // positions of wrong verdicts below nearest_queries, in any order

  static constexpr auto fields(auto&& visit) {
    return visit(journalled(&ClassTally::classes), journalled(&ClassTally::first_wrong));
  }
};

class DepthOf;

// Counts one wrong verdict on `q`, a query within the kernel's limits. `use_filter`: enclosures decide where they can;
// the result is the same.
template <class Real>
void count_class(ClassTally& tally, std::uint64_t position, FlipKind kind, const Query<Real>& q, bool is_touching,
                 DepthOf& depth, bool use_filter);

}  // namespace axiscert

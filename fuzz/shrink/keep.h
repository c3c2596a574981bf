// The properties that a smaller query keeps besides its symptom: the class of its input, and a depth that is not
// another fault's.
#pragma once

#include <optional>

#include "fuzz/shrink/query_class.h"
#include "fuzz/shrink/symptom.h"

namespace axiscert {

// A depth may grow to this many times that of the given query: a missed contact by an ulp does not become one by a
// fifth of the scene, which would be another fault.
inline constexpr int depth_factor = 4;

class Keep {
 public:
  // Keeps nothing besides the symptom: as small as it goes.
  Keep() = default;
  // Keeps the class of this valid query of the entry, which has this severity.
  template <class Real>
  Keep(const Predicate& predicate, const Numbers<Real>& q, const Severity& severity, std::size_t entry = 0);

  // Whether a smaller query has the same class and meets no definition of a class that the given one does not, and a
  // depth of at most depth_factor times the given one's. Only a depth is limited, not a margin or an error.
  template <class Real>
  bool allows(const Numbers<Real>& q, const Severity& severity) const;

  // The definitions of classes that the given query meets, the first of them its class; empty if nothing is kept.
  const std::optional<std::vector<std::string_view>>& classes() const { return classes_; }

 private:
  const Predicate* predicate_ = nullptr;
  std::size_t entry_ = 0;
  std::optional<std::vector<std::string_view>> classes_;
  std::optional<Severity> greatest_;
};

}  // namespace axiscert

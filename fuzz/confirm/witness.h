// Witnesses: the queries that a run keeps, made again from their positions and examined by all oracles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/judge/examine.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/confirm/record.h"
#include "fuzz/record/witness_record.h"

namespace axiscert {
// The two sides of a witness's comparisons: exact, computed, and their difference.

class WitnessSides {
 public:
  // For each comparison: the exact lhs, rhs and margin to 17 significant digits, the computed sides as hex-floats, the
  // error of each side in ulps of the exact one and that of their difference in u (rounded up). Includes every
  // comparison of an axis with a flip and those in `largest_errors`; all if a verdict is wrong without a flip. Empty
  // for a kernel that claims no formulae with comparisons, and for a query without a truth.
  virtual std::optional<NamedValues<SidesRecord>> of(const Numbers<float>& q, const Kernel& kernel,
                                                     const Examination& found, ComparisonBits largest_errors) const = 0;
  virtual std::optional<NamedValues<SidesRecord>> of(const Numbers<double>& q, const Kernel& kernel,
                                                     const Examination& found, ComparisonBits largest_errors) const = 0;

 protected:
  ~WitnessSides() = default;
};

// What a kernel says beside its verdict, and what is exact, as a witness has it.

// The measures that a kernel gave, by name, numbers as a query has them, and how they are wrong: of motions beside a
// contact, and of a missed one its tunnel. Empty where there is nothing.
std::optional<MeasuresRecord> measures_of(const Predicate& predicate, const Examination& found);

// The exact contact of a query whose verdict is `truth`, by the oracles of its entry, with numbers of binary64; of
// motions the details of these and, where there is contact, its place. Empty of a query that is invalid.
template <class Real>
std::optional<ExactContactRecord> exact_contact_of(const Oracles& oracles, const Truth& truth,
                                                   const Numbers<Real>& numbers);

class WitnessWriter {
 public:
  // The kernels are asked on a target; where there are replies, they are the answers of the one kernel.
  WitnessWriter(const StoredReplies* replies, const std::string& target) : replies_(replies), target_(target) {}
  // Adds the deepest wrong verdicts of each kind, with each broken link and on input of each class; for each comparison
  // a flip of each kind, a decisive one if there is one, and the largest error; the worst of each kind of measure; for
  // an asymmetry, and for each way in which answers change with an image, the first image and its base. A query that
  // shows several of these is stored once.
  void add(const Kernel& kernel, const SeededSource& of, const Tally& tally, const std::optional<Asymmetry>& asymmetry);
  std::vector<WitnessRecord> take() && { return std::move(witnesses_); }

 private:
  // The things that a query shows, in the order found, and the comparisons for which it has the largest error.
  struct Reasons {
    std::vector<std::string> texts;
    ComparisonBits largest_errors = 0;
    std::optional<InputClass> input_class = {};  // as which it was counted
  };
  using ShownReasons = std::map<std::uint64_t, Reasons>;  // by position
  static void note_contacts(const ContactTally& contacts, ShownReasons& shown);
  static void add_pairs(const SeededSource& of, const Asymmetry& asymmetry, ShownReasons& shown);
  template <class Real>
  Examination examined(const Kernel& kernel, const Source& source, std::uint64_t position,
                       const Numbers<Real>& numbers);
  template <class Real>
  void write(const Kernel& kernel, const SeededSource& of, const ShownReasons& shown);

  const StoredReplies* replies_;  // null: the kernels are asked
  const std::string& target_;
  std::optional<Examiner> examiner_;  // for the kernel that was added last
  std::vector<WitnessRecord> witnesses_;
};

}  // namespace axiscert

// Witnesses: the queries that a run keeps, made again from their positions and examined by all oracles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/trait/examine.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/confirm/record.h"

namespace axiscert {

class WitnessWriter {
 public:
  // The kernels are asked on a target; where there are replies, they are the answers of the one kernel.
  WitnessWriter(const StoredReplies* replies, const std::string& target) : replies_(replies), target_(target) {}
  // Adds the deepest wrong verdicts of each kind, with each broken link and on input of each class; for each comparison
  // a flip of each kind, a decisive one if there is one, and the largest error; the worst of each kind of measure; for
  // an asymmetry, and for each way in
  // which answers change with an image, the first image and its base. A query that
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
  static void note_motion(const MotionTally& motion, ShownReasons& shown);
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

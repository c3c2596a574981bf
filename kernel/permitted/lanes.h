// Whether a verdict is within what is permitted, of a vector's lanes of queries at once: the same ends as Evaluation's.
// Where results are faithful, the greatest and the negated least are what the processor rounds upward; else to nearest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/permitted/graph.h"
#include "kernel/query.h"

namespace axiscert::permitted {

class AdversaryInLanes {
 public:
  // Not of operations that are fused and rounded to nearest.
  static bool covers(const Permissions& permissions) { return permissions.faithful || !permissions.fused; }
  // Permissions that `covers` refuses are a HarnessFault. `recording` has to outlive it.
  AdversaryInLanes(const Predicate& predicate, std::size_t entry, const Recording& recording, Verdict wished);

  // Whether `wished` can be, of each query, 1 or 0; of values behind barriers as if each use had one of its own.
  void ask(const QueryColumns<float>& batch, std::uint8_t* can_be) const;

  // What the code for each instruction set reads.
  struct Plan {
    const Recording& recording;
    std::uint64_t number = 0;                            // no two have the same
    std::vector<std::vector<std::uint32_t>> below = {};  // of each comparison the nodes that it needs, children first
    std::vector<std::vector<std::uint32_t>> as_written = {};  // the same but for factorings
    std::vector<std::vector<std::uint32_t>> above = {};       // of each column the nodes that need it
    std::vector<ComparisonBits> comparisons_above = {};
    std::vector<std::uint32_t> divisors = {};  // of each node, divisors_of
    std::vector<std::uint32_t> repeated = {};  // of each node its children that are as the one before, as a mask
    // One suffices, of all its comparisons: the index of each, and whether it holds. As many as `shared` are at the
    // beginning of the way before.
    struct Way {
      std::vector<std::pair<std::size_t, bool>> decisions;
      std::size_t shared;
    };
    std::vector<Way> ways = {};
    std::vector<ComparisonBits> clauses = {};  // where there is no way: of each clause one fails
    std::size_t most_children = 1;
  };
  // The output: a vector for each column, for each node and for each set of the children of one, by mask: the
  // greatest and the negated least, both infinity where a value is indeterminate; and what holds all that may be.
  struct Block {
    std::uint64_t plan = 0;
    std::vector<float> columns, greatest, negated_least, middle, radius;
    std::vector<char> is_known, is_around_known;                                           // by node
    std::array<std::uint64_t, most_comparisons> holds, fails, surely_holds, surely_fails;  // lanes
    ComparisonBits known, around_known;                                                    // comparisons
  };
  // The last blocks are kept: whoever asks again with one column changed, as bisection does, waits for little.
  struct Memory {
    std::array<Block, 16> blocks;
    std::vector<float> greatest_of_subset, negated_least_of_subset;
  };

 private:
  Plan plan_;
};

}  // namespace axiscert::permitted

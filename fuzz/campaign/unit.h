// One unit: 2^16 queries of one source and precision, generated, answered by every kernel, judged and tallied.
#pragma once

#include "fuzz/campaign/campaign.h"

namespace axiscert {

// How many queries a kernel is asked at once: queries, sides and signs of a batch stay in the first-level cache, or the
// second. Odd, so that a vector kernel of any width is left with queries that fill no whole vector, in every batch and
// in the last of a unit, which has 25: what it does with those is judged too.
inline constexpr std::size_t batch_size = 251;
// Another process is asked seldom.
inline constexpr std::size_t batch_size_for_processes = 1024;

struct UnitResult {
  std::vector<Tally> tallies;  // by kernel
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;
};

// Told the size of each batch that is done with; may be empty.
using BatchDone = std::function<void(std::uint64_t queries)>;

// The first `size` queries of unit `number`. What other units of the cell have found, by kernel, saves evaluating what
// can be no maximum; it may be empty. Merged with their tallies the result depends on the other arguments only, but for
// the times.
UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<StandingLeaders>& standing = {}, const BatchDone& asked = {});

// The cells of the questions, with nothing done, for so many kernels: binary64 first, whose units take longest, and the
// last ones decide how long the cores wait for each other.
std::vector<CellResult> cells_of(const Questions& questions, std::size_t kernels);

}  // namespace axiscert

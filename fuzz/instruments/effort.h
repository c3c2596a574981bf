// The efforts of `axiscert certify`: how much is asked of a kernel. An effort is a fixed plan, the same on every
// machine.
#pragma once

#include <cstdint>
#include <string_view>

#include "fuzz/queries/source.h"
#include "kernel/base/enums.h"

namespace axiscert {

enum class Effort : std::uint8_t {
  smoke,  // seconds: to try a workflow, and to test the command
  quick,
  standard,
  deep
};
template <>
inline constexpr std::size_t enum_count<Effort> = 4;
inline constexpr EnumArray<Effort, std::string_view> effort_names = {"smoke", "quick", "standard", "deep"};
// Throws Error that lists the efforts.
Effort parse_effort(std::string_view text);

// Numbers of an effort. Those of queries and evaluations are divided for a predicate without filters, every query of
// which is judged by exact arithmetic, and for a kernel in another process; those of families, where a family says it
// is dear.
struct EffortSize {
  std::uint64_t trials;         // queries of each family in each precision
  std::uint64_t evaluations;    // of the search in each precision
  std::uint64_t probes;         // queries of each family whose critical radius is found
  std::uint64_t mutant_stride;  // of the mutants every so manieth is judged
  std::uint64_t mutant_trials;  // on so many queries of each family
};
// `is_slow`: the kernel answers from another process, or is a program.
EffortSize size_of(Effort effort, const Predicate& predicate, bool is_slow);

// Queries of a source in a run of this effort, in either precision; of a file of queries all that it has.
std::uint64_t trials_of(Effort effort, const Source& source, bool is_slow);
// The same of a source by its name, "general" or "mesh/spider.obj".
std::uint64_t trials_of(Effort effort, const Predicate& predicate, std::string_view source, bool is_slow);

}  // namespace axiscert

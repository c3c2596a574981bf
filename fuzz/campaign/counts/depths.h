// How deep wrong verdicts are: counts by decade of their depth, and those on queries such as an engine asks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "exact/judge/depth_of.h"
#include "exact/judge/judge.h"

namespace axiscert {

// Decades of depths: 0 is a depth of zero, of spheres that touch; 1 is all else below 10^-20, too small for a double or
// not; then [10^k, 10^(k+1)) for k from -20 on; the last one is a depth of 1. Depth and power of ten are the nearest
// binary64 of each.
inline constexpr int least_decade = -20;
inline constexpr std::size_t decade_count = 2 - least_decade + 1;
std::size_t decade_of(double depth);
std::size_t decade_of(DepthOf& depth);
// "zero", "less", "-20" ... "-1", "0".
std::string decade_name(std::size_t decade);

using DecadeCounts = std::array<std::uint64_t, decade_count>;

// Wrong verdicts by direction and decade.
struct DepthTally {
  DecadeCounts false_separation{}, false_contact{};

  DecadeCounts& of(FlipKind kind) { return kind == FlipKind::false_separation ? false_separation : false_contact; }
  void merge(const DepthTally& other);
  bool operator==(const DepthTally&) const = default;
};

// Wrong verdicts on queries such as an engine asks (DepthOf::engine_threshold).
struct EngineTally {
  std::uint64_t queries = 0;  // within the kernel's limits
  DepthTally wrong;
};

// Counts a wrong verdict.
void count_depth(DepthTally& depths, EngineTally& engine, FlipKind kind, DepthOf& depth);

}  // namespace axiscert

// How deep wrong verdicts are: counts by decade of their depth, and those on queries such as an engine asks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "exact/judge/judge.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The depth of a wrong verdict, |d - r| / max(|A-P|, |B-P|, |C-P|, r): exact, and so only computed where it could be
// kept.
class DepthOf {
 public:
  virtual double at_least() = 0;  // both certainly, of exactly() too
  virtual double at_most() = 0;
  virtual double exactly() = 0;  // rounded once, to the nearest binary64
  virtual bool is_touching() = 0;
  // The depth above which a wrong verdict counts as one on an engine-like query; infinity where the query is not one.
  virtual double engine_threshold() = 0;

 protected:
  ~DepthOf() = default;
};

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

// An engine-like query of sphere-triangle: every number is zero or normal, no |coordinate| is above 2^20, and the
// radius is from 2^-20 to 2^20: from a micrometre to a thousand kilometres where the unit is a metre. A wrong verdict
// on one is counted where its depth is above 16 u; below, it is the rounding of the query's own numbers that decides.
template <class Real>
bool is_engine_like(const Query<Real>& q);
template <class Real>
std::uint64_t engine_like_queries(const QueryColumns<Real>& columns);
template <class Real>
inline constexpr double engine_depth = sizeof(Real) == 4 ? 0x1p-20 : 0x1p-49;  // 16 u

struct EngineTally {
  std::uint64_t queries = 0;  // within the kernel's limits
  DepthTally wrong;
};

// Counts a wrong verdict.
void count_depth(DepthTally& depths, EngineTally& engine, FlipKind kind, DepthOf& depth);

}  // namespace axiscert

// Brackets: where a kernel's answer turns on a path, against the exact turn.
#pragma once

#include <string>
#include <vector>

#include "fuzz/confirm/slack_scenes.h"
#include "fuzz/record/slack_record.h"

namespace axiscert {

// One scene with what the kernel made of it.
struct Bracket {
  const SlackScene* scene;
  double early;     // the length by which contact comes too early; below 0: too late
  double rounding;  // a right kernel's own, at most; the exact turn is known as well
  double turn;      // the kernel's, on the path
};

struct Brackets {
  std::vector<SlackScene> scenes;  // within what the kernel promises
  std::uint64_t answers = 0;       // that the kernel was asked for
  std::vector<Bracket> all;        // of those on which exact turn and kernel's are known
};
template <class Real>
Brackets brackets_of(const Kernel& kernel, std::uint64_t seed, const std::string& target);

// The query of the path at x.
template <class Real>
Numbers<Real> query_at(const SlackScene& scene, Real x);

}  // namespace axiscert

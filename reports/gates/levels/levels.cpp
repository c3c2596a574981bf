#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "kernel/base/error.h"
#include "reports/gates/levels/level.h"

// The levels that exist, one line each: X(NAME) is `NAME_level`, which a file of its own defines.
#define AXISCERT_GATE_LEVELS(X) \
  X(logic)                      \
  X(range)                      \
  X(exact)                      \
  X(conservative)               \
  X(depth)                      \
  X(decided)                    \
  X(no_worse_than)              \
  X(invariant)                  \
  X(never_late)                 \
  X(no_tunnel)

namespace axiscert {

#define AXISCERT_DECLARE_LEVEL(name) extern const GateLevel name##_level;
AXISCERT_GATE_LEVELS(AXISCERT_DECLARE_LEVEL)
#undef AXISCERT_DECLARE_LEVEL

std::span<const GateLevel* const> gate_levels() {
#define AXISCERT_POINT_LEVEL(name) &name##_level,
  static const GateLevel* const all[] = {AXISCERT_GATE_LEVELS(AXISCERT_POINT_LEVEL)};
#undef AXISCERT_POINT_LEVEL
  return all;
}

std::vector<const GateLevel*> badge_levels() {
  std::vector<const GateLevel*> levels(gate_levels().begin(), gate_levels().end());
  std::erase_if(levels, [](const GateLevel* level) { return !level->badge; });
  std::ranges::sort(levels, {}, [](const GateLevel* level) { return level->badge->rank; });
  return levels;
}

std::string_view GateLevel::name() const {
  const std::string_view text = usage;
  return text.substr(0, text.find_first_of("[="));
}

double depth_argument(const AskedLevel& asked) {
  double depth = 0;
  const char* const end = asked.argument.data() + asked.argument.size();
  const auto [stop, problem] = std::from_chars(asked.argument.data(), end, depth);
  if (problem != std::errc() || stop != end || !(depth >= 0)) {
    throw Error(fmt::format("requirement '{}': D is a depth, a share of the scene from 0 on, as in {}=0.001",
                            asked.text, asked.name));
  }
  return depth;
}

void accept_no_argument(const AskedLevel&) {}

}  // namespace axiscert

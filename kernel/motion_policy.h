// The promises of a kernel of a predicate of motions, where engines differ. A query beyond a promise is not judged.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/base/enum_array.h"

namespace axiscert {

// Queries in which the two have a point in common before the motion.
enum class StartPolicy : std::uint8_t {
  reported,     // contact, at time 0
  approaching,  // contact, where the distance between them falls at first; else no promise
  ignored,      // no promise
};
template <>
inline constexpr std::size_t enum_count<StartPolicy> = 3;
inline constexpr EnumArray<StartPolicy, std::string_view> start_policy_names = {"reported", "approaching", "ignored"};
constexpr std::string_view name(StartPolicy which) { return start_policy_names[which]; }

// Queries with a displacement of zero.
enum class StillPolicy : std::uint8_t { reported, ignored };
template <>
inline constexpr std::size_t enum_count<StillPolicy> = 2;
inline constexpr EnumArray<StillPolicy, std::string_view> still_policy_names = {"reported", "ignored"};
constexpr std::string_view name(StillPolicy which) { return still_policy_names[which]; }

// Triangles that the motion meets from behind: D.(AB x AC) >= 0, so also those without area.
enum class SidesPolicy : std::uint8_t { both, front };
template <>
inline constexpr std::size_t enum_count<SidesPolicy> = 2;
inline constexpr EnumArray<SidesPolicy, std::string_view> sides_policy_names = {"both", "front"};
constexpr std::string_view name(SidesPolicy which) { return sides_policy_names[which]; }

struct MotionPolicy {
  StartPolicy start = StartPolicy::reported;
  StillPolicy still = StillPolicy::reported;
  SidesPolicy sides = SidesPolicy::both;
  bool operator==(const MotionPolicy&) const = default;
};

}  // namespace axiscert

// A swept parameter: the queries of a source, each changed by the same offset, size or radius, for one value after
// another.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/queries/source.h"

namespace axiscert {

// What becomes of a query; every number is rounded to its precision, and the query is judged as what it has become.
enum class SweepParameter : std::uint8_t {
  offset,  // every coordinate of every point is this much greater
  size,    // points, displacements and lengths are multiplied by it, seen from the last point, the sphere's centre
  radius,  // lengths alone are multiplied by it
};
template <>
inline constexpr std::size_t enum_count<SweepParameter> = 3;
inline constexpr EnumArray<SweepParameter, std::string_view> sweep_parameter_names = {"offset", "size", "radius"};
constexpr std::string_view name(SweepParameter parameter) { return sweep_parameter_names[parameter]; }

struct SweepPoint {
  SweepParameter parameter;
  std::string text;  // as it was given: "2^8"
  double value;

  std::string name() const { return std::string(axiscert::name(parameter)) + "=" + text; }  // "offset=2^8"
  bool operator==(const SweepPoint&) const = default;
};

struct Sweep {
  SweepParameter parameter;
  std::vector<SweepPoint> points;
};

// "offset=2^0..2^20": each power of two; "size=1,3,10" or "radius=2^-4,1": these numbers. Throws Error that says what
// was given and what would be right.
Sweep parse_sweep(std::string_view text);
// Throws Error for a value that this precision does not reach.
void require_within(const Sweep& sweep, Precision precision);

// The source's queries, changed. Its name is "tangent offset=2^8", and "tangent+offset=2^8" in an address: what makes
// the same query again. Throws Error for a radius where queries have none.
SourcePtr swept_source(SourcePtr source, const SweepPoint& point);
// The value that a source's queries have; null where none is swept. And the source without it.
const SweepPoint* swept_point(const Source& source);
const Source& unswept(const Source& source);
// The median size of the source's first 1,000 queries: the greatest distance of a point from the last one, the sphere's
// centre, in one coordinate, or the greatest length.
double median_scene_size(const Source& source, std::uint64_t seed, Precision precision);
// The name of a source in an address, without its point, and the point; empty where it has none. Throws Error.
std::pair<std::string_view, std::optional<SweepPoint>> split_swept(std::string_view address_name);

}  // namespace axiscert

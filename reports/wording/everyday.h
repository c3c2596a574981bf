// What a game programmer reads first of a kernel: everyday scenes in metres, then the queries that nothing rounds, then
// all others, then other units of length.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "fuzz/record/plan_record.h"
#include "fuzz/record/record.h"
#include "reports/wording/evidence.h"

namespace axiscert {

// Families by what a wrong answer on them says.
enum class FamilyGroup : std::uint8_t {
  everyday,  // scenes in metres, as a game has them
  own,       // meshes and query files that were given
  exact,     // nothing is rounded: a wrong answer is the method's
  other      // random ones, which few kernels get wrong, and hard ones; the corpus too
};
template <>
inline constexpr std::size_t enum_count<FamilyGroup> = 4;
FamilyGroup family_group(std::string_view family);
inline constexpr EnumArray<FamilyGroup, std::string_view> family_group_names = {"everyday", "own", "exact", "other"};
constexpr std::string_view name(FamilyGroup group) { return family_group_names[group]; }
// Above the families of a group, in tables.
inline constexpr EnumArray<FamilyGroup, std::string_view> family_group_headings = {
    "Everyday scenes, in metres", "Your own", "Exact: nothing is rounded",
    "Others: random, touching, degenerate, huge, tiny"};

// "16.6 cm": a length of a family's queries as people read it. Empty where it has no meaning, and where it is 0.
std::string length_words(std::string_view family, double length, const PlanRecord& plan);

// The results on the families of one group, merged.
struct GroupResult {
  Evidence evidence;
  std::uint64_t missed = 0, invented = 0;
  double worst_missed = 0, worst_invented = 0;      // lengths in the queries' unit
  double deepest_missed = 0, deepest_invented = 0;  // shares of the scene
  std::string missed_in, invented_in;               // the families of the worst lengths
  // Times of first contacts on one side of the exact one.
  struct Times {
    std::uint64_t count = 0;
    double farthest = 0, largest_share = 0;  // a length in the queries' unit, a share of the way
  };
  Times late, early;
  std::uint64_t times = 0, without_time = 0;              // contacts, of a kernel that gives times
  std::uint64_t separations = 0, without_separation = 0;  // answers of bodies as they are
  std::uint64_t pushes = 0, without_push = 0, sided = 0;  // overlaps; sided: with a normal that has a side
  std::uint64_t points = 0, without_point = 0;            // answers
  double farthest_separation = 0;                         // a length in the queries' unit
  std::uint64_t contradictions = 0, flips = 0;
  std::uint64_t wrong_features = 0;
  double largest_normal_angle = 0, largest_point_error = 0;  // radians, a share of the scene
  std::size_t families = 0;
};
GroupResult group_result(const KernelRecord& kernel, FamilyGroup group);

// "131,072 everyday scenes: 27 contacts invented, worst 16.6 cm, 0.0123 of the scene (scene-edge)", with how late and
// early times are; of the other groups alike, of those with a query. Then "in other units: as in this one only from
// 2^-24 to 2^20 times it (2^-140 to 2^125 were asked)".
std::vector<std::string> first_sentences(const KernelRecord& kernel, const PlanRecord& plan);

// The wrong verdict that a page draws first: the farthest off in length on an everyday scene, else on the user's own
// queries, else the deepest of all. Null where none is wrong.
const WitnessRecord* worst_scene(const Record& record);
// "misses a contact 16.6 cm deep, in a scene of 13.5 m (0.0123 of it)", without the family.
std::string scene_words(const WitnessRecord& witness, const PlanRecord& plan);

}  // namespace axiscert

#include "fuzz/diagnosis/scenes.h"

#include <cmath>
#include <limits>

#include "fuzz/diagnosis/other_units.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/query.h"

namespace axiscert::diagnosis {
namespace {

// Positions that are looked at for each query that is wanted.
constexpr std::uint64_t most_positions = 64;
constexpr std::size_t small_scenes = 32;

// Clear queries in every unit between two, or in every third where there are many.
template <class Real>
Queries<Real> clear_in_units(const Kernel& kernel, std::size_t count, int first, int last) {
  constexpr int step = sizeof(Real) == 4 ? 1 : 3;
  Queries<Real> queries;
  const auto clear = clear_queries<Real>(kernel, count);
  for (int exponent = first; exponent <= last; exponent += step) {
    for (const auto& query : clear) queries.push_back(in_unit(kernel, query.numbers, exponent));
  }
  return queries;
}

}  // namespace

const Family* family_named_general(const Kernel& kernel) {
  for (const Family* family : families_of(*kernel.predicate)) {
    const std::string_view last = family->name.substr(family->name.rfind('/') + 1);
    if (family->entry == kernel.entry && (last.starts_with("general") || last.ends_with("_general"))) return family;
  }
  return nullptr;
}

template <class Real>
std::vector<ClearQuery<Real>> clear_queries(const Kernel& kernel, std::size_t count) {
  return scenes_of<Real>(*kernel.predicate).clear(kernel, count);
}

template <class Real>
std::vector<ClearQuery<Real>> clear_by_depth(const Kernel& kernel, std::size_t count) {
  std::vector<ClearQuery<Real>> found;
  const Oracles& oracles = oracles_of(kernel);
  const Family* family = family_named_general(kernel);
  if (!family || !oracles.has_depth()) return found;
  for (std::uint64_t position = 0; found.size() < count && position < count * most_positions; ++position) {
    const Numbers<Real> numbers = family->make<Real>(1, position);
    const Truth truth = oracles.truth(numbers);
    if (truth.verdict == Verdict::invalid || !is_promised(kernel, numbers)) continue;
    const std::optional<double> depth = oracles.depth(numbers);
    if (depth && *depth > clear_depth) found.push_back({numbers, truth.verdict});
  }
  return found;
}

namespace {

// Queries of `general` with the length at which the answer turns, a quarter less and a quarter more: where the nearest
// part is misjudged, hardly another is in reach.
template <class Real>
Queries<Real> near_turning(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  const Family* family = family_named_general(kernel);
  const std::optional<CriticalLength> length = oracles_of(kernel).critical_length();
  for (std::uint64_t i = 0; family && length && queries.size() < count && i < count; ++i) {
    Numbers<Real> query = family->make<Real>(seed, i);
    const std::optional<Rational> squared = length->squared(in_doubles(query));
    const auto critical = squared ? sqrt_rounded_up<Real>(*squared) : std::nullopt;
    if (!critical || !(*critical > 0)) continue;
    for (const Real factor : {Real(0.75), Real(1.25)}) {
      query[length->column] = *critical * factor;
      queries.push_back(query);
    }
  }
  return queries;
}

}  // namespace

template <class Real>
std::vector<ClearQuery<Real>> clear_of_families(Subject<Real>& subject) {
  constexpr std::size_t of_turning = 96, of_units = 48, of_others = 2;
  constexpr std::uint64_t positions_of_each = 4;
  const Kernel& kernel = subject.kernel();
  const Oracles& oracles = oracles_of(kernel);
  std::vector<ClearQuery<Real>> found;
  if (!oracles.has_depth()) return found;
  const Scaling unit = unit_of_length(kernel);
  const auto add = [&](const Numbers<Real>& numbers) {
    if (!oracles.is_valid(numbers)) return;
    Real greatest = 0;
    for (const std::size_t k : unit.columns) greatest = std::max(greatest, std::abs(numbers[k]));
    if (greatest == 0) return;
    const auto scaled = times_exactly(numbers, unit.columns, -std::ilogb(greatest));
    if (!scaled || !is_promised(kernel, *scaled)) return;
    const std::optional<double> depth = oracles.depth(*scaled);
    if (depth && *depth > clear_depth) found.push_back({*scaled, oracles.truth(*scaled).verdict});
  };
  for (const Numbers<Real>& query : near_turning<Real>(kernel, subject.seed(), of_turning)) add(query);
  for (const Family* family : families_of(*kernel.predicate)) {
    const ImageGroup* group = image_group(family->name);
    if (family->entry != kernel.entry || (group && !group->range)) continue;
    const std::size_t count = group ? of_units : of_others, most = found.size() + count;
    for (std::uint64_t i = 0; found.size() < most && i < positions_of_each * count; ++i)
      add(family->make<Real>(subject.seed(), i * (group ? group->size : 1)));
  }
  return found;
}

Scaling unit_of_length(const Kernel& kernel) {
  // The published formulae have degree 6, and what others do in their place is of degree 8 at most.
  Scaling scaling{{}, 8};
  const std::vector<PredicateColumn>& columns = kernel.predicate->entries[kernel.entry].columns;
  const bool displacements = is_of_motions(*kernel.predicate);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Role role = columns[k].role;
    if (role != Role::time && (role != Role::direction || displacements)) scaling.columns.push_back(k);
  }
  return scaling;
}

std::vector<Scaling> quaternions(const Kernel& kernel) {
  const PredicateEntry& entry = kernel.predicate->entries[kernel.entry];
  std::vector<Scaling> found;
  for (const ColumnGroup& group : groups_of(entry)) {
    if (group.size != 4 || entry.columns[group.first].role != Role::direction) continue;
    // A matrix has degree 2 in its quaternion, and what is made of the squares of its axes degree 4.
    found.push_back({{group.first, group.first + 1, group.first + 2, group.first + 3}, 4});
  }
  return found;
}

template <class Real>
Numbers<Real> in_unit(const Kernel& kernel, const Numbers<Real>& numbers, int exponent) {
  Numbers<Real> scaled = numbers;
  for (const std::size_t k : unit_of_length(kernel).columns) scaled[k] = std::ldexp(numbers[k], exponent);
  return scaled;
}

template <class Real>
Queries<Real> small_of_high_degree(const Kernel& kernel) {
  using Limits = std::numeric_limits<Real>;
  return clear_in_units<Real>(kernel, small_scenes, Limits::min_exponent + Limits::digits + 2, 0);
}

template <class Real>
Queries<Real> small_of_any_degree(const Kernel& kernel) {
  constexpr int subnormal = std::numeric_limits<Real>::min_exponent - 3;
  Queries<Real> queries = small_of_high_degree<Real>(kernel);
  // Where all lengths are zero every answer is contact, so only separated scenes tell, which may be one in six.
  const Queries<Real> lengths = clear_in_units<Real>(kernel, 8 * small_scenes, subnormal, subnormal);
  queries.insert(queries.end(), lengths.begin(), lengths.end());
  return queries;
}

// Families have numbers up to 16, and last bits below those of 1.
ExponentWindow scanned_of_families(Precision precision) {
  const ExponentWindow all = scanned_exponents(precision);
  return {all.low + 30, all.high - 5};
}

template <class Real>
std::optional<std::string> why_not_sound(Subject<Real>& subject) {
  const auto clear = clear_queries<Real>(subject.kernel(), 128);
  if (clear.empty()) return std::nullopt;
  Queries<Real> queries;
  for (const auto& query : clear) queries.push_back(query.numbers);
  const std::vector<Verdict> said = subject.ask(queries);
  std::size_t right = 0, contacts = 0, separated = 0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    right += said[i] == clear[i].truth;
    contacts += said[i] == Verdict::contact;
    separated += said[i] == Verdict::separated;
  }
  if (3 * right >= 2 * said.size() && contacts != 0 && separated != 0) return std::nullopt;
  return fmt::format(
      "It is right on {} of {} queries that are far from every boundary, and says contact on {}: its "
      "answers say nothing about finer things.",
      right, said.size(), contacts);
}

#define AXISCERT_INSTANCES(Real)                                                           \
  template std::vector<ClearQuery<Real>> clear_queries<Real>(const Kernel&, std::size_t);  \
  template std::vector<ClearQuery<Real>> clear_by_depth<Real>(const Kernel&, std::size_t); \
  template std::vector<ClearQuery<Real>> clear_of_families(Subject<Real>&);                \
  template Queries<Real> small_of_high_degree<Real>(const Kernel&);                        \
  template Queries<Real> small_of_any_degree<Real>(const Kernel&);                         \
  template Numbers<Real> in_unit(const Kernel&, const Numbers<Real>&, int);                \
  template std::optional<std::string> why_not_sound(Subject<Real>&);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

const DiagnosisScenes& diagnosis_scenes(const Predicate& predicate) {
  static const DiagnosisScenes by_trait;
  const DiagnosisScenes* own = capabilities_of(predicate).diagnosis_scenes;
  return own ? *own : by_trait;
}

template <class Real>
Queries<Real> sharp_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  if (const auto near_tie = scenes_of<Real>(*kernel.predicate).near_tie) {
    for (std::uint64_t i = 0; i < count; ++i) queries.push_back(near_tie(seed, "sharp", i, no_axis));
    return queries;
  }
  std::vector<const Family*> families;
  for (const Family* family : families_of(*kernel.predicate)) {
    if (family->entry == kernel.entry && image_group(family->name) == nullptr) families.push_back(family);
  }
  for (std::uint64_t i = 0; i < count && !families.empty(); ++i) {
    queries.push_back(families[i % families.size()]->make<Real>(seed, i / families.size()));
  }
  return queries;
}

template <class Real>
Queries<Real> queries_of_general(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  const Family* family = family_named_general(kernel);
  for (std::uint64_t i = 0; i < count && family; ++i) queries.push_back(family->make<Real>(seed, i));
  return queries;
}

#define AXISCERT_INSTANCES(Real)                                                         \
  template Queries<Real> sharp_queries<Real>(const Kernel&, std::uint64_t, std::size_t); \
  template Queries<Real> queries_of_general<Real>(const Kernel&, std::uint64_t, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis

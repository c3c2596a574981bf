#include "fuzz/diagnosis/scenes_by_trait.h"

#include <cmath>

#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/query.h"

namespace axiscert::diagnosis {
namespace {

// Positions that are looked at, of each family.
constexpr std::uint64_t touching_positions = 16384, sided_positions = 4096, flat_positions = 8192,
                        turning_positions = 8192;
// Answers at touching from which on something is said.
constexpr std::size_t least_touching = 16;
// Coordinates of vertices of flat triangles are multiples of this, so that the middle of two is a number.
constexpr double vertex_grid = 0x1p-6;

const std::vector<PredicateColumn>& columns_of(const Kernel& kernel) {
  return kernel.predicate->entries[kernel.entry].columns;
}

Vec3<double> triple(const auto& query, std::size_t first) {
  return {static_cast<double>(query[first]), static_cast<double>(query[first + 1]),
          static_cast<double>(query[first + 2])};
}

// The displacement of a motion; empty of what does not move.
template <class Real>
std::optional<Vec3<double>> displacement(const Kernel& kernel, const Numbers<Real>& query) {
  if (const auto d = first_column(kernel, "d")) return triple(query, *d);
  const auto from = first_column(kernel, "p"), to = first_column(kernel, "p1");
  if (!from || !to) return std::nullopt;
  return triple(query, *to) - triple(query, *from);
}

// Where what is held against the triangle is: the moving centre before the motion, or the centre of the box.
template <class Real>
std::optional<Vec3<double>> place_of(const Kernel& kernel, const Numbers<Real>& query) {
  for (const char* centre : {"p", "box.m"}) {
    if (const auto first = first_column(kernel, centre)) return triple(query, *first);
  }
  const auto low = first_column(kernel, "box.min"), high = first_column(kernel, "box.max");
  if (!low || !high) return std::nullopt;
  return (triple(query, *low) + triple(query, *high)) * 0.5;
}

struct Triangle {
  Vec3<double> a, normal;
  double longest;  // squared edge
  bool is_flat() const { return dot(normal, normal) <= 0x1p-10 * longest * longest; }
};
template <class Real>
std::optional<Triangle> triangle_of(const Kernel& kernel, const Numbers<Real>& query) {
  const auto vertices = vertex_columns(kernel);
  if (!vertices) return std::nullopt;
  const Vec3<double> a = triple(query, (*vertices)[0]), ab = triple(query, (*vertices)[1]) - a,
                     ac = triple(query, (*vertices)[2]) - a, bc = ac - ab;
  return Triangle{a, cross(ab, ac), std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)})};
}

template <class Real>
Numbers<Real> flattened(const Kernel& kernel, Numbers<Real> query, Flat flat, std::uint64_t turn) {
  const std::array<std::size_t, 3> vertices = *vertex_columns(kernel);
  for (const std::size_t first : vertices) {
    for (std::size_t k = first; k < first + 3; ++k)
      query[k] = static_cast<Real>(std::round(static_cast<double>(query[k]) / (2 * vertex_grid)) * 2 * vertex_grid);
  }
  const std::size_t from = vertices[turn % 3], to = vertices[(turn + 1) % 3], last = vertices[(turn + 2) % 3];
  for (std::size_t k = 0; k < 3; ++k) {
    if (flat == Flat::collinear) query[last + k] = (query[from + k] + query[to + k]) / 2;
    else query[to + k] = query[from + k];
    if (flat == Flat::point) query[last + k] = query[from + k];
  }
  return query;
}

}  // namespace

std::optional<std::size_t> first_column(const Kernel& kernel, std::string_view group) {
  for (const ColumnGroup& found : groups_of(kernel.predicate->entries[kernel.entry])) {
    if (found.name == group) return found.first;
  }
  return std::nullopt;
}

std::optional<std::array<std::size_t, 3>> vertex_columns(const Kernel& kernel) {
  const auto a = first_column(kernel, "a"), b = first_column(kernel, "b"), c = first_column(kernel, "c");
  if (!a || !b || !c) return std::nullopt;
  return std::array{*a, *b, *c};
}

bool has_lengths(const Kernel& kernel) {
  return std::ranges::any_of(columns_of(kernel),
                             [](const PredicateColumn& column) { return column.role == Role::length; });
}

template <class Real>
Numbers<Real> without_motion(const Kernel& kernel, Numbers<Real> query) {
  if (const auto d = first_column(kernel, "d")) std::fill_n(query.begin() + *d, 3, Real(0));
  const auto from = first_column(kernel, "p"), to = first_column(kernel, "p1");
  if (from && to) std::copy_n(query.begin() + *from, 3, query.begin() + *to);
  return query;
}

template <class Real>
bool is_plump(const Kernel& kernel, const Numbers<Real>& query) {
  const std::vector<PredicateColumn>& columns = columns_of(kernel);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].role == Role::length && !(query[k] > 0)) return false;
  }
  if (const auto d = displacement(kernel, query); d && dot(*d, *d) == 0) return false;
  const auto triangle = triangle_of(kernel, query);
  return !triangle || !triangle->is_flat();
}

template <class Real>
Numbers<Real> with_lengths_times(const Kernel& kernel, Numbers<Real> query, Real factor) {
  const std::vector<PredicateColumn>& columns = columns_of(kernel);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].role == Role::length) query[k] *= factor;
  }
  return query;
}

// Queries of the families whose arithmetic is exact; plump.
template <class Real>
TouchingScenes<Real> touching_by_trait(Subject<Real>& subject, std::size_t count) {
  const Kernel& kernel = subject.kernel();
  const Oracles& oracles = oracles_of(kernel);
  Queries<Real> found;
  for (const Family* family : families_of(subject.predicate())) {
    if (family->entry != kernel.entry || !family->exact_arithmetic || image_group(family->name)) continue;
    for (std::uint64_t position = 0; position < touching_positions && found.size() < count; ++position) {
      const Numbers<Real> query = family->make<Real>(subject.seed(), position);
      if (!is_plump(kernel, query)) continue;
      const Truth truth = oracles.truth(query);
      if (truth.verdict == Verdict::invalid || !truth.touching) continue;
      if (!is_promised(kernel, query)) continue;
      const Numbers<Real> larger = with_lengths_times(kernel, query, Real(1.5));
      const Truth grown = oracles.truth(larger), shrunk = oracles.truth(with_lengths_times(kernel, query, Real(0.5)));
      if (grown.verdict != Verdict::contact || grown.touching || shrunk.verdict != Verdict::separated) continue;
      if (is_promised(kernel, larger)) found.push_back(query);
    }
  }
  const SceneWords& words = diagnosis_scenes(subject.predicate()).words;
  return {.queries = found,
          .part = std::vector<std::size_t>(found.size(), 0),
          .parts = {"all"},
          .least = std::max(least_touching, (found.size() + 1) / 2),
          .all_tell_of_slack = false,
          .what = words.touching,
          .length = words.length,
          .whole = "What is asked about",
          .where = "where the two touch, exactly,",
          .touches = "the two touch, exactly"};
}

// From where the centre of what is held against the triangle is; or the moving centre before the motion, which goes to
// the other side and is clear of the triangle at first.
template <class Real>
SidedScenes<Real> sided_by_trait(Subject<Real>& subject, std::size_t count) {
  const SceneWords& words = diagnosis_scenes(subject.predicate()).words;
  SidedScenes<Real> scenes = {.queries = {},
                              .apart = {},
                              .what = words.sided,
                              .whose = "what comes from",
                              .front = words.front,
                              .behind = words.behind};
  std::vector<SidedQuery<Real>>& found = scenes.queries;
  const Kernel& kernel = subject.kernel();
  const Family* family = family_named_general(kernel);
  const Oracles& oracles = oracles_of(kernel);
  if (!family || !oracles.has_depth()) return scenes;
  std::array<std::size_t, 2> of_side{};
  for (std::uint64_t position = 0; position < sided_positions && found.size() < count; ++position) {
    const Numbers<Real> query = family->make<Real>(subject.seed(), position);
    const auto triangle = triangle_of(kernel, query);
    const auto place = place_of(kernel, query);
    if (!triangle || !place || triangle->is_flat()) continue;
    const double height = dot(*place - triangle->a, triangle->normal);
    const auto d = displacement(kernel, query);
    const bool is_front = height > 0;
    if (height == 0 || (d && (dot(*d, triangle->normal) > 0) == is_front)) continue;
    if (of_side[is_front] >= count / 2) continue;
    if (oracles.truth(query).verdict != Verdict::contact || !(oracles.depth(query) > clear_depth)) continue;
    if (d && oracles.truth(without_motion(kernel, query)).verdict != Verdict::separated) continue;
    ++of_side[is_front];
    found.push_back({query, is_front});
  }
  return scenes;
}

// Queries of the family `general`, clear of touching. What the kernel does not promise is left out.
template <class Real>
FlatScenes<Real> flat_by_trait(Subject<Real>& subject, std::size_t of_each) {
  FlatScenes<Real> scenes = {.queries = {}, .apart = "is apart", .contact = "is in contact"};
  std::vector<FlatQuery<Real>>& found = scenes.queries;
  const Kernel& kernel = subject.kernel();
  const Family* family = family_named_general(kernel);
  const Oracles& oracles = oracles_of(kernel);
  if (!family || !oracles.has_depth() || !vertex_columns(kernel)) return scenes;
  for (const Flat flat : {Flat::point, Flat::two_equal, Flat::collinear}) {
    std::array<std::vector<Numbers<Real>>, 2> by_contact;
    const auto is_full = [&](const auto& queries) { return queries.size() >= of_each / 2; };
    for (std::uint64_t i = 0; i < flat_positions && !std::ranges::all_of(by_contact, is_full); ++i) {
      const Numbers<Real> query = flattened(kernel, family->make<Real>(subject.seed(), i), flat, i);
      const Truth truth = oracles.truth(query);
      if (truth.verdict == Verdict::invalid || !is_promised(kernel, query)) continue;
      auto& into = by_contact[truth.verdict == Verdict::contact];
      if (!is_full(into) && oracles.depth(query) > clear_depth) into.push_back(query);
    }
    // As many of the one as of the other: else skipping and hitting all would not be told apart.
    const std::size_t pairs = std::min(by_contact[0].size(), by_contact[1].size());
    for (const bool is_contact : {false, true}) {
      for (std::size_t i = 0; i < pairs; ++i) found.push_back({by_contact[is_contact][i], flat, is_contact});
    }
  }
  return scenes;
}

// Queries of the family `general` whose answer turns at a radius between 1/8 and 4, or half extent, and does not near
// it.
template <class Real>
TurningScenes<Real> turning_by_trait(Subject<Real>& subject, std::size_t count) {
  const Kernel& kernel = subject.kernel();
  const CriticalLength distance = *oracles_of(kernel).critical_length();
  const Oracles& oracles = oracles_of(kernel);
  const SceneWords& words = diagnosis_scenes(subject.predicate()).words;
  TurningScenes<Real> scenes{{}, distance.column, {}, {}, words.first, words.second, why_not_sound(subject)};
  if (scenes.why_none) return scenes;
  const auto vertices = vertex_columns(kernel);
  const std::vector<PredicateColumn>& columns = kernel.predicate->entries[kernel.entry].columns;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const bool is_of_first = vertices ? k < 9 : columns[k].name.starts_with("a.");
    const bool is_place = columns[k].role == Role::coordinate || (vertices && columns[k].role == Role::direction);
    scenes.is_of_first.push_back(is_place && is_of_first);
    scenes.is_of_second.push_back(is_place && !is_of_first);
  }
  const Family* family = family_named_general(kernel);
  for (std::uint64_t i = 0; family && i < turning_positions && scenes.queries.size() < count; ++i) {
    Numbers<Real> query = family->make<Real>(subject.seed(), i);
    if (!is_plump(kernel, query)) continue;
    const std::optional<Rational> squared = distance.squared(in_doubles(query));
    const auto critical = squared ? sqrt_rounded_up<Real>(*squared) : std::nullopt;
    if (!critical || *critical < Real(0.125) || *critical > Real(4)) continue;
    const auto at = [&](double factor) {
      Numbers<Real> other = query;
      other[distance.column] = *critical * static_cast<Real>(factor);
      return other;
    };
    const Numbers<Real> low = at(1 - turning_range), high = at(1 + turning_range);
    if (oracles.truth(low).verdict != Verdict::separated || oracles.truth(high).verdict != Verdict::contact) continue;
    if (is_promised(kernel, low) && is_promised(kernel, high)) scenes.queries.push_back(at(1));
  }
  return scenes;
}

#define AXISCERT_INSTANCES(Real)                                                 \
  template Numbers<Real> without_motion(const Kernel&, Numbers<Real>);           \
  template bool is_plump(const Kernel&, const Numbers<Real>&);                   \
  template Numbers<Real> with_lengths_times(const Kernel&, Numbers<Real>, Real); \
  template TouchingScenes<Real> touching_by_trait(Subject<Real>&, std::size_t);  \
  template SidedScenes<Real> sided_by_trait(Subject<Real>&, std::size_t);        \
  template FlatScenes<Real> flat_by_trait(Subject<Real>&, std::size_t);          \
  template TurningScenes<Real> turning_by_trait(Subject<Real>&, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis

// What fuzz/ has for a predicate beside its families: each member serves one command or measurement, and is null where
// the predicate has no such thing. Code asks for the capability that it needs, and never which predicate it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// Classes of the input of a predicate, by definitions of its own: why a kernel may be wrong on a query.

class InputClasses {
 public:
  // The names of the definitions that a valid query meets, in their order and at least one: the first is its class.
  virtual std::vector<std::string_view> of(const Numbers<float>& query) const = 0;
  virtual std::vector<std::string_view> of(const Numbers<double>& query) const = 0;

 protected:
  ~InputClasses() = default;
};

// The parts of a shape that are nearest to the other, in a predicate that names them.

struct NearestFeatures {
  // The names of all parts that have a point at the least distance of a valid query: at least one, exactly. A part is
  // without its rim: where a vertex is nearest, its edges are not.
  std::vector<std::string_view> (*of_doubles)(const Numbers<double>& query);
  template <class Real>
  std::vector<std::string_view> of(const Numbers<Real>& query) const {
    return of_doubles(in_doubles(query));
  }
};

// What the exact answer says of a query, by definitions of its predicate's own: with a class of them a cause is named
// (fuzz/confirm).

// One of them. The phrase follows the noun of its queries: "spheres", and "nearest to vertex a". Where a property of a
// diagnosis asks about it, that property is named. A narrow trait has one axis of many, of which a wider trait has all.
// One that stands alone cuts across the others: it is a class without them, and where half of its queries are wrong.
struct Trait {
  std::string_view name, phrase, property = {};
  bool is_narrow = false, stands_alone = false;
};
using TraitSet = std::uint64_t;  // bit k: all()[k]
inline constexpr std::size_t most_traits = 62;

struct Traits {
  std::string_view noun;  // of several queries: "spheres"
  // At most most_traits, in the order in which a sentence has them: what is nearest first, then the shape, then sizes.
  std::span<const Trait> all;
  // Those of a valid query in that entry of the predicate, exactly: a threshold that a phrase states is a definition,
  // and is compared without rounding.
  TraitSet (*of_numbers)(const std::vector<double>& numbers, std::size_t entry);
  template <class Real>
  TraitSet of(const Numbers<Real>& query, std::size_t entry) const {
    return of_numbers({query.begin(), query.end()}, entry);
  }
};

// Numbers that kernels give in place of those of a contact: a diagnosis says where they are these.

struct ContactLikeness {
  MeasureKind kind;
  std::string_view value;     // of the property of a diagnosis
  std::string_view sentence;  // "It is the distance to the triangle's plane, less the radius"
  // One number, or the three of a vector, in doubles; empty where there is none. `entry` is that of the query.
  std::vector<double> (*numbers)(const Numbers<double>& query, std::size_t entry);
};

class AimValues;
class ImageMaps;
class InputClasses;
class ProvedBounds;
class Screens;
class SearchMethod;
class WitnessSides;
struct CriticalRadiusDefaults;
struct ExactFact;
struct ImageGroup;
struct MeshQueries;
struct Quantities;
struct Situations;
struct SlackScenes;
struct StoredQuery;
namespace diagnosis {
struct DiagnosisScenes;
}

struct Capabilities {
  std::span<const ImageGroup* const> image_groups = {};         // fuzz/queries/image_groups.h: families of images
  const MeshQueries* mesh = nullptr;                            // fuzz/files/mesh.h: queries for a mesh
  std::string (*canonical_form)(const StoredQuery&) = nullptr;  // fuzz/files/corpus.h: of all images of a query

  const Screens* screens = nullptr;                   // fuzz/campaign/unit.h: of a predicate with filters
  const InputClasses* input_classes = nullptr;        // above
  const NearestFeatures* nearest_features = nullptr;  // above
  bool has_engine_queries = false;                    // which the screen counts (fuzz/record/wrong_verdicts.h)
  const Quantities* quantities = nullptr;             // fuzz/confirm/absolute_size.h
  const WitnessSides* witness_sides = nullptr;        // fuzz/confirm/witness.h

  // The section of the documents that says what the predicate's built-in kernels answer.
  std::string_view section_of_forms = {};
  const Situations* situations = nullptr;  // fuzz/queries/family.h

  std::span<const std::string_view> correct_forms = {};  // kernels that are right over the reals: fuzz/instruments
  const diagnosis::DiagnosisScenes* diagnosis_scenes = nullptr;      // fuzz/diagnosis/scenes.h
  const CriticalRadiusDefaults* critical_radius_defaults = nullptr;  // fuzz/instruments/critical_radius.h
  const ProvedBounds* proved_bounds = nullptr;                       // fuzz/search/confirm.h
  const SearchMethod* search_method = nullptr;                       // fuzz/search/method.h
  const AimValues* aim_values = nullptr;                             // fuzz/search/confirm.h
  const ImageMaps* image_maps = nullptr;                             // fuzz/shrink/pair.h
  const SlackScenes* slack_scenes = nullptr;                         // fuzz/confirm/slack_scenes.h
  const Traits* traits = nullptr;                                    // above
  std::span<const ContactLikeness* const> contact_likenesses = {};   // above
  // exact/judge/exact_facts.h: what there is to tell of a valid query in an entry; a float widens exactly.
  std::vector<ExactFact> (*exact_facts)(const Numbers<double>& query, std::size_t entry) = nullptr;
};

// Those of a predicate on the list of kernel/predicate_list.h: NAME_capabilities() of its room in fuzz/.
const Capabilities& capabilities_of(const Predicate& predicate);

}  // namespace axiscert

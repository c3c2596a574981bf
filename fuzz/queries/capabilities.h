// What fuzz/ has for a predicate beside its families: each member serves one command or measurement, and is null where
// the predicate has no such thing. Code asks for the capability that it needs, and never which predicate it is.
#pragma once

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

class NearestFeatures {
 public:
  // The names of all parts that have a point at the least distance of a valid query: at least one, exactly. A part is
  // without its rim: where a vertex is nearest, its edges are not.
  virtual std::vector<std::string_view> of(const Numbers<float>& query) const = 0;
  virtual std::vector<std::string_view> of(const Numbers<double>& query) const = 0;

 protected:
  ~NearestFeatures() = default;
};

class AimValues;
class ImageMaps;
class InputClasses;
class NearestFeatures;
class ProvedBounds;
class Quantities;
class Screens;
class SearchMethod;
class WitnessSides;
struct CriticalRadiusDefaults;
struct ImageGroup;
struct MeshQueries;
struct Situations;
struct SlackScenes;
struct StoredQuery;
namespace diagnosis {
struct DiagnosisScenes;
}

struct Capabilities {
  std::span<const ImageGroup* const> image_groups = {};         // fuzz/queries/image_groups.h: families of images
  const MeshQueries* mesh = nullptr;                            // fuzz/meshes/mesh.h: queries for a mesh
  std::string (*canonical_form)(const StoredQuery&) = nullptr;  // fuzz/files/corpus.h: of all images of a query

  const Screens* screens = nullptr;                   // fuzz/campaign/stages.h: of a predicate with filters
  const InputClasses* input_classes = nullptr;        // above
  const NearestFeatures* nearest_features = nullptr;  // above
  bool has_engine_queries = false;                    // which the screen counts (fuzz/record/wrong_verdicts.h)
  const Quantities* quantities = nullptr;             // fuzz/confirm/absolute_size.h
  const WitnessSides* witness_sides = nullptr;        // fuzz/confirm/witness.h

  // Of the documents: what the predicate's built-in kernels answer.
  std::string_view section_of_forms = {};
  const Situations* situations = nullptr;  // fuzz/queries/family.h

  std::span<const std::string_view> correct_forms = {};          // kernels that are right over the reals: fuzz/mutation
  const diagnosis::DiagnosisScenes* diagnosis_scenes = nullptr;  // fuzz/diagnosis/scenes.h
  const CriticalRadiusDefaults* critical_radius_defaults = nullptr;  // fuzz/instruments/critical_radius.h
  const ProvedBounds* proved_bounds = nullptr;                       // fuzz/search/confirm.h
  const SearchMethod* search_method = nullptr;                       // fuzz/search/method.h
  const AimValues* aim_values = nullptr;                             // fuzz/search/confirm.h
  const ImageMaps* image_maps = nullptr;                             // fuzz/shrink/pair.h
  const SlackScenes* slack_scenes = nullptr;                         // fuzz/slack/scenes.h
};

// Those of a predicate on the list of kernel/predicate_list.h: NAME_capabilities() of its room in fuzz/.
const Capabilities& capabilities_of(const Predicate& predicate);

}  // namespace axiscert

#include "fuzz/diagnosis/diagnosis.h"

#include "fuzz/diagnosis/probes.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace diagnosis {
namespace {

template <Enumeration Value>
std::vector<std::string_view> all_of_them(const EnumArray<Value, std::string_view>& names) {
  return {names.begin(), names.end()};
}

// A property with its probe.
struct Probe {
  PropertyKind kind;
  ProbeFinding (*binary32)(Subject<float>&);
  ProbeFinding (*binary64)(Subject<double>&);

  template <class Real>
  auto in() const {
    if constexpr (sizeof(Real) == 4) return binary32;
    else return binary64;
  }
};

const std::vector<Probe>& probes() {
  static const std::vector<Probe> all = {
#define AXISCERT_PROBE(name, asks, values, probe) {{name, asks, values}, probe<float>, probe<double>}
      AXISCERT_PROBE("touching", "the answer at a distance of exactly r", all_of_them(at_touching_names), at_touching),
      AXISCERT_PROBE("sides", "the sides of a triangle from which it is hit", all_of_them(sides_names), sides_hit),
      AXISCERT_PROBE("overlap_at_start", "whether an overlap before the motion is a contact", all_of_them(starts_names),
                     overlap_at_start),
      AXISCERT_PROBE("degenerate_triangles", "what becomes of triangles without area", all_of_them(degenerate_names),
                     degenerate_triangles),
      AXISCERT_PROBE("absolute_threshold", "whether something is compared with a number that has a length in it",
                     all_of_them(threshold_names), absolute_thresholds),
      AXISCERT_PROBE("slack", "whether it answers as if shapes or motions were larger or smaller",
                     all_of_them(slack_names), slack),
      AXISCERT_PROBE("range_window", "the powers of two times which it answers as at scale 1",
                     all_of_them(window_names), range_window),
      AXISCERT_PROBE("subnormal_numbers", "whether subnormal numbers are numbers or zero",
                     all_of_them(subnormals_names), subnormal_numbers),
      AXISCERT_PROBE("operation_order", "the order of the sums in dot products, and whether operations are fused",
                     all_of_them(order_names), operation_order),
      AXISCERT_PROBE("inner_precision", "the precision in which it computes, against that of the query",
                     all_of_them(inner_names), inner_precision),
      AXISCERT_PROBE("repeated", "whether the same batch is answered the same again", all_of_them(repeated_names),
                     diagnosis::repeated),
      AXISCERT_PROBE("position_in_batch", "whether an answer depends on the position in the batch",
                     all_of_them(place_names), position_in_batch),
      AXISCERT_PROBE("batch_length", "whether an answer depends on the length of the batch", all_of_them(place_names),
                     batch_length),
      AXISCERT_PROBE("neighbours", "whether an answer depends on the other queries of the batch",
                     all_of_them(place_names), neighbours),
      AXISCERT_PROBE("regions", "clear queries by the part that is nearest, or the axis that decides",
                     all_of_them(by_trait_names), on_regions),
      AXISCERT_PROBE("on_triangle", "clear queries with a centre or a vertex on the other body",
                     all_of_them(by_trait_names), on_triangle),
      AXISCERT_PROBE("obtuse", "clear queries of triangles with an obtuse corner", all_of_them(by_trait_names),
                     on_obtuse),
      AXISCERT_PROBE("parallel", "clear queries of parallel edges, or of motions parallel to a part",
                     all_of_them(by_trait_names), on_parallel),
      AXISCERT_PROBE("flat", "clear queries of triangles without area and boxes without volume",
                     all_of_them(by_trait_names), on_flat),
      AXISCERT_PROBE("aligned", "clear queries along the axes of the coordinates", all_of_them(by_trait_names),
                     on_aligned),
      AXISCERT_PROBE("separation", "the distance or the penetration that is given", all_of_them(separations_names),
                     separations),
      AXISCERT_PROBE("normal", "the normal that is given", all_of_them(normals_names), normals),
      AXISCERT_PROBE("feature", "the nearest part that is given", all_of_them(features_names), features),
      AXISCERT_PROBE("contact_point", "the point of contact that is given", all_of_them(points_names), contact_points),
      AXISCERT_PROBE("evaluation", "what a compiler made of a built-in form's operations", all_of_them(evaluated_names),
                     evaluation),
      AXISCERT_PROBE("nearest_form", "the built-in kernel that it agrees with most", {}, nearest_form),
#undef AXISCERT_PROBE
  };
  return all;
}

void require_value(const PropertyKind& kind, const std::string& value) {
  if (value == not_known || value == not_asked) return;
  const bool is_known = kind.values.empty()
                            ? std::ranges::any_of(kernels(), [&](const Kernel& k) { return k.id == value; })
                            : std::ranges::find(kind.values, value) != kind.values.end();
  if (!is_known) throw HarnessFault(fmt::format("diagnosis: {} has no value '{}'", kind.name, value));
}

// The values that answers without a verdict show, or for which one answer is enough.
bool rests_on_few(std::string_view property, std::string_view value) {
  return property == "degenerate_triangles" || value == name(RepeatedBatch::differs) || value == name(Place::depends) ||
         value == name(Threshold::present) || value == name(Threshold::quaternions) || value == name(ByTrait::wrong);
}

// A property that rests on too little is not known, whatever its probe made of it.
void require_enough(std::string_view property, const LookedAt& looked_at, ProbeFinding& found) {
  if (found.value == not_known || found.value == not_asked || looked_at.asked() == 0) return;
  const auto too_few = [&](std::string why) { found = undecided(std::move(why), std::move(found.measured)); };
  if (2 * looked_at.outside_limits > looked_at.asked()) {
    too_few(
        fmt::format("Of the {} queries that were asked {} are outside the limits that it declares: too few are "
                    "within to say.",
                    looked_at.asked(), looked_at.outside_limits));
  } else if (2 * looked_at.decided < looked_at.promised() && !rests_on_few(property, found.value)) {
    too_few(fmt::format("It decides {} of the {} queries that were asked within its limits: too few to say.",
                        looked_at.decided, looked_at.promised()));
  }
}

template <class Real>
Diagnosis diagnosed(const Kernel& kernel, const DiagnosisOptions& options) {
  Diagnosis diagnosis{kernel.id, kernel.predicate, options.precision, options.seed, kernel.may_decline};
  Subject<Real> subject(kernel, options);
  ProgressCount progress(options.report, probes().size());
  for (const Probe& probe : probes()) {
    ProbeFinding found;
    try {
      found = probe.in<Real>()(subject);
    } catch (const Interruption&) {
      diagnosis.complete = false;
      return diagnosis;
    }
    require_value(probe.kind, found.value);
    const std::uint64_t queries = subject.take_count();
    LookedAt looked_at = subject.take_looked_at();
    require_enough(probe.kind.name, looked_at, found);
    if (const std::uint64_t without = subject.take_left_out(); without != 0 && found.value != not_asked)
      found.sentence += fmt::format(" {} other answers have none to compare.", without);
    diagnosis.properties.push_back({std::string(probe.kind.name), std::move(found.value), std::move(found.sentence),
                                    queries, std::move(found.witnesses), std::move(found.measured),
                                    std::move(looked_at)});
    progress.finish_unit(queries);
  }
  return diagnosis;
}

}  // namespace
}  // namespace diagnosis

std::span<const PropertyKind> property_kinds() {
  static const std::vector<PropertyKind> all = [] {
    std::vector<PropertyKind> kinds;
    for (const auto& probe : diagnosis::probes()) kinds.push_back(probe.kind);
    return kinds;
  }();
  return all;
}

std::optional<std::size_t> importance_of(std::string_view property, std::string_view value) {
  if (value == not_known || value == not_asked) return std::nullopt;
  struct Known {
    std::string_view property;
    std::vector<std::string_view> expected;
  };
  static const std::vector<std::vector<Known>> all = {
      {{"repeated", {"same"}},
       {"neighbours", {"independent"}},
       {"position_in_batch", {"independent"}},
       {"batch_length", {"independent"}}},
      {{"regions", {"right"}},
       {"on_triangle", {"right"}},
       {"obtuse", {"right"}},
       {"parallel", {"right"}},
       {"flat", {"right"}},
       {"aligned", {"right"}},
       {"separation", {"right"}},
       {"normal", {"right"}},
       {"feature", {"right"}},
       {"contact_point", {"right"}}},
      {{"absolute_threshold", {"none_found"}}},
      {{"range_window", {"whole"}}},
      {{"overlap_at_start", {"reported"}},
       {"sides", {"both"}},
       {"degenerate_triangles", {"handled"}},
       {"touching", {"closed"}}},
      {{"subnormal_numbers", {"kept"}},
       {"inner_precision", {"own", "wider"}},
       {"operation_order", {"left_to_right", "other_order"}},
       {"evaluation", {"as_written"}}},
  };
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    for (const Known& known : all[rank]) {
      if (known.property != property) continue;
      return std::ranges::find(known.expected, value) == known.expected.end() ? std::optional(rank) : std::nullopt;
    }
  }
  return std::nullopt;  // nearest_form, which no value of is expected
}

std::vector<const Property*> Diagnosis::most_important_first() const {
  std::vector<const Property*> all;
  for (const Property& property : properties) all.push_back(&property);
  std::ranges::stable_sort(all, {}, [](const Property* property) {
    return importance_of(property->name, property->value).value_or(property_kinds().size());
  });
  return all;
}

const Property* Diagnosis::find(std::string_view name) const {
  const auto found = std::ranges::find(properties, name, &Property::name);
  return found == properties.end() ? nullptr : &*found;
}

LookedAt Diagnosis::looked_at() const {
  LookedAt all;
  for (const Property& property : properties) merge_fields(all, property.looked_at);
  return all;
}

Diagnosis diagnose(const Kernel& kernel, const DiagnosisOptions& options) {
  if (!kernel.has(options.precision)) {
    throw Error(fmt::format("kernel {} does not exist in {}", kernel.id, name(options.precision)));
  }
  return options.precision == Precision::binary32 ? diagnosis::diagnosed<float>(kernel, options)
                                                  : diagnosis::diagnosed<double>(kernel, options);
}

}  // namespace axiscert

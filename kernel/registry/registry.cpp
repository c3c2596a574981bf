// The registry: the kernels that exist, one line each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <mutex>

#include "kernel/registry/called.h"
#include "kernel/sphere_triangle/certified/kernels.h"
#include "kernel/sphere_triangle/forms/eigen.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/certified_filter/kernels.h"
#include "kernel/sphere_triangle/mutants/mutant.h"
#include "kernel/sphere_triangle/forms/packed.h"
#include "kernel/plugin/load.h"
#include "kernel/sphere_triangle/reference/scalar_kernel.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {
namespace {

constexpr auto strict = Strictness::strict, nonstrict = Strictness::nonstrict, not_less = Strictness::not_less;

// A kernel with the scalar form only.
template <Formulae formulae, Strictness strictness = strict>
Kernel scalar(std::string id, std::string summary) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .formulae = formulae,
          .strictness = strictness,
          .exposes = has_comparisons(formulae) ? Exposure::sides : Exposure::verdict,
          .binary32 = [](std::string_view) { return scalar_implementation<formulae, strictness, float>(); },
          .binary64 = [](std::string_view) { return scalar_implementation<formulae, strictness, double>(); },
          .takes_arithmetic = kind_of(formulae) == FormulaeKind::rung};
}

// A kernel with the scalar form, and with one query in each lane on every other target.
template <Formulae formulae, Strictness strictness, const SimdForms& (*simd)()>
Kernel vectorised(std::string id, std::string summary) {
  Kernel kernel = scalar<formulae, strictness>(std::move(id), std::move(summary));
  kernel.has_simd = true;
  kernel.binary32 = [](std::string_view target) {
    return target == scalar_target ? scalar_implementation<formulae, strictness, float>()
                                   : simd().on<float>(target, strictness);
  };
  kernel.binary64 = [](std::string_view target) {
    return target == scalar_target ? scalar_implementation<formulae, strictness, double>()
                                   : simd().on<double>(target, strictness);
  };
  return kernel;
}

template <Strictness strictness>
Kernel packed(std::string id, std::string summary) {
  Kernel kernel = scalar<Formulae::published, strictness>(std::move(id), std::move(summary));
  kernel.takes_arithmetic = false;
  kernel.binary32 = [](std::string_view) { return packed_implementation<strictness, float>(); };
  kernel.binary64 = [](std::string_view) { return packed_implementation<strictness, double>(); };
  return kernel;
}

Kernel eigen(std::string id, std::string summary) {
  Kernel kernel = scalar<Formulae::published>(std::move(id), std::move(summary));
  kernel.is_reference = false;
  kernel.takes_arithmetic = false;
  kernel.binary32 = [](std::string_view) { return eigen_implementation<float>(); };
  kernel.binary64 = [](std::string_view) { return eigen_implementation<double>(); };
  return kernel;
}

// The certified kernels show only a verdict, whatever they compute on the way.
template <certified::Question question>
Kernel certified_kernel(std::string id, std::string summary) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .formulae = Formulae::none,
          .exposes = Exposure::verdict,
          .binary32 = [](std::string_view target) { return certified_implementation<float>(target, question); },
          .binary64 = [](std::string_view target) { return certified_implementation<double>(target, question); },
          .has_simd = true,
          .is_reference = false};
}

// The filter of formulae whose non-strict form is right for every triangle. It shows only a verdict, whatever it
// computes.
template <FilterForm form>
Kernel filter(std::string id, std::string summary) {
  return {.id = std::move(id),
          .summary = std::move(summary),
          .formulae = Formulae::none,
          .exposes = Exposure::verdict,
          .binary32 = [](std::string_view target) { return filter_implementation<float>(form, target); },
          .binary64 = [](std::string_view target) { return filter_implementation<double>(form, target); },
          .has_simd = true,
          .is_reference = false};
}

// clang-format off
const std::vector<Kernel>& registry() {
  using enum Formulae;
  static const std::vector<Kernel> all = {
      vectorised<published, strict, simd_published>("published", "the article's last block: sixteen strict comparisons, seven axes"),
      vectorised<published, nonstrict, simd_published>("nonstrict", "the same with >= in the nine side comparisons: right for degenerate triangles too"),
      vectorised<reduced, strict, simd_reduced>("reduced", "edge axes of degree 4, |A x B|^2 > rr e: the published signs with less rounding"),
      vectorised<reduced, nonstrict, simd_reduced>("reduced-nonstrict", "the same with >= in the nine side comparisons: right for every triangle"),
      scalar<reduced_along>("reduced-along", "reduced, the edge normals along the edges: A x AB for A x B"),
      scalar<reduced_determinant>("reduced-determinant", "reduced, the plane's offset as a determinant: C.(A x B) for A.V"),
      scalar<reduced_shared>("reduced-shared", "reduced, V = A x B + B x C + C x A from the edges' normals: fewest operations"),
      scalar<reduced_shared, nonstrict>("reduced-shared-nonstrict", "the same with >= in the nine side comparisons"),
      scalar<ladder_0>("ladder-0", "nothing rewritten: normals of length 1, roots, divisions"),
      scalar<ladder_1>("ladder-1", "then the plane: squared, one division by |V|"),
      scalar<ladder_2>("ladder-2", "then the plane: no root, (A.V)^2 / (V.V) > rr"),
      scalar<ladder_3>("ladder-3", "then the plane: no division, cross-multiplied"),
      scalar<ladder_4>("ladder-4", "then the vertices: squared, differences distributed, A.B > A.A"),
      scalar<ladder_5>("ladder-5", "then the edges: squared"),
      scalar<ladder_6>("ladder-6", "then the edges: multiplied by e^2"),
      scalar<ladder_7>("ladder-7", "then the edges: no division, Q = A e + d AB"),
      scalar<ladder_8>("ladder-8", "then the edges: centred, d = A.AB"),
      scalar<ladder_9>("ladder-9", "then the edges: d = A.B - A.A; this is published, bit for bit"),
      scalar<minkowski>("minkowski", "the centre against three spheres, three cylinders and a prism; right for every triangle"),
      scalar<closest_point>("closest-point", "closest point by Voronoi regions, then a distance; A = B gives 0/0"),
      scalar<segments>("segments", "edge axes through the closest point of each segment, no vertex axes"),
      packed<strict>("packed", "published, one pair at a time: sixteen comparisons in four 4-lane compares"),
      packed<not_less>("packed-nonstrict", "the same with a >= b as !(b > a) in the sides: a NaN side holds"),
      eigen("eigen", "published, written with Eigen's vectors, whose reductions choose their order"),
      certified_kernel<certified::Question::closed_sphere>("certified", "exact always: filtered in the input's precision, then in doubles, then in integers"),
      certified_kernel<certified::Question::conservative>("conservative", "never a missed contact; phantom depth at most 20 sqrt(u): 0.00489, in binary64 2.11e-7"),
      filter<FilterForm::reduced>("certified-filter", "reduced with proved thresholds: separated, contact or undecided, and proved never wrong"),
      filter<FilterForm::published>("certified-filter-published", "the same with the published formulae, whose thresholds are wider"),
      scalar<first_publication>("first-publication", "the article as first published: QC = C e + Q, wrong in exact arithmetic"),
      scalar<vertex_typo>("vertex-typo", "the vertex section as printed: ac = dot(B, B), wrong in exact arithmetic"),
  };
  return all;
}
// clang-format on

const Kernel* registered(std::string_view id) {
  for (const Kernel& kernel : registry()) {
    if (kernel.id == id) return &kernel;
  }
  return nullptr;
}

// A kernel that is not in the registry: made when it is first asked for, and kept.
template <class Make>
const Kernel& kept(std::string_view id, const Make& make) {
  static std::mutex mutex;
  static std::deque<Kernel> made;
  {
    const std::lock_guard lock(mutex);
    for (const Kernel& kernel : made) {
      if (kernel.id == id) return kernel;
    }
  }
  Kernel kernel = make();  // a plug-in's claim is looked up here, so the lock must not be held
  const std::lock_guard lock(mutex);
  return made.emplace_back(std::move(kernel));
}

// The kernel "RUNG+ARITHMETIC".
Kernel composed(std::string_view id, const Kernel& rung, const ArithmeticInfo& arithmetic) {
  Kernel kernel;
  kernel.id = id;
  kernel.summary = fmt::format("{}; {}", rung.summary, arithmetic.summary);
  kernel.formulae = rung.formulae;
  kernel.strictness = rung.strictness;
  kernel.arithmetic = arithmetic.arithmetic;
  kernel.exposes = arithmetic.exposes;
  const auto implementation = [f = rung.formulae, a = arithmetic.arithmetic, s = rung.strictness]<class Real>() {
    return reference_implementation<Real>(f, a, s);
  };
  if (arithmetic.in_binary32)
    kernel.binary32 = [=](std::string_view) { return implementation.template operator()<float>(); };
  if (arithmetic.in_binary64)
    kernel.binary64 = [=](std::string_view) { return implementation.template operator()<double>(); };
  return kernel;
}

// The kernel "KERNEL@CALL".
const Kernel& found_as_called(std::string_view id, std::string_view call) {
  if (plugin::plugin_path(id)) {
    throw Error(
        fmt::format("kernel '{}@{}': {} runs in a process of its own, which settings made here do not reach; "
                    "only built-in kernels can be called with '@'",
                    id, call, id));
  }
  Kernel kernel = called(find_kernel(id), call);
  return kept(kernel.id, [&] { return std::move(kernel); });
}

std::string with_dashes(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

std::string name(Formulae formulae) {
  constexpr const char* names[] = {
#define AXISCERT_NAME(name, type, kind) #name,
      AXISCERT_FORMULAE(AXISCERT_NAME)
#undef AXISCERT_NAME
          ""};
  return with_dashes(names[static_cast<std::size_t>(formulae)]);
}

std::string name(Arithmetic arithmetic) {
  constexpr const char* names[] = {
#define AXISCERT_NAME(name, type, summary) #name,
      AXISCERT_ARITHMETICS(AXISCERT_NAME)
#undef AXISCERT_NAME
  };
  return with_dashes(names[static_cast<std::size_t>(arithmetic)]);
}

std::span<const Kernel> kernels() { return registry(); }

const std::vector<ArithmeticInfo>& arithmetics() {
  static const std::vector<ArithmeticInfo> all = {
#define AXISCERT_INFO(name, type, summary) \
  {with_dashes(#name),                     \
   summary,                                \
   Arithmetic::name,                       \
   arithmetic::type::in_binary32,          \
   arithmetic::type::in_binary64,          \
   arithmetic::type::exposes_sides ? Exposure::sides : Exposure::comparisons},
      AXISCERT_ARITHMETICS(AXISCERT_INFO)
#undef AXISCERT_INFO
  };
  return all;
}

const Kernel& find_kernel(std::string_view id) {
  if (const Kernel* kernel = registered(id)) return *kernel;
  if (const auto at = call_in(id)) return found_as_called(id.substr(0, *at), id.substr(*at + 1));
  if (const auto path = plugin::plugin_path(id))
    return kept(id, [&] { return plugin::load_plugin(std::string(id), *path); });
  if (id.find('~') != id.npos) return kept(id, [&] { return mutants::kernel_of(mutants::find_mutant(id)); });
  const std::size_t plus = id.find('+');
  if (plus == id.npos) {
    std::vector<std::string_view> known;
    for (const Kernel& kernel : registry()) known.push_back(kernel.id);
    throw Error(
        fmt::format("unknown kernel '{}'; plugin:PATH.so is one of your own; kernels: {}", id, fmt::join(known, ", ")));
  }
  const std::string_view rung_id = id.substr(0, plus), arithmetic_name = id.substr(plus + 1);
  const Kernel* rung = registered(rung_id);
  std::vector<std::string_view> known;
  for (const Kernel& kernel : registry()) {
    if (kernel.takes_arithmetic) known.push_back(kernel.id);
  }
  if (!rung || !rung->takes_arithmetic) {
    throw Error(fmt::format("kernel '{}': '{}' is not a rung that takes another arithmetic; rungs that do: {}", id,
                            rung_id, fmt::join(known, ", ")));
  }
  known.clear();
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    if (arithmetic.name == arithmetic_name) return kept(id, [&] { return composed(id, *rung, arithmetic); });
    known.push_back(arithmetic.name);
  }
  throw Error(fmt::format("kernel '{}': unknown arithmetic '{}'; arithmetics: {}", id, arithmetic_name,
                          fmt::join(known, ", ")));
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::vector<std::string> available_targets() {
  std::vector<std::string> names = simd_targets();
  names.emplace_back(scalar_target);
  return names;
}

std::string resolve_target(std::string_view name) {
  const std::vector<std::string> available = available_targets();
  if (same_letters(name, "auto")) return available.front();
  for (const std::string& target : available) {
    if (same_letters(name, target)) return target;
  }
  throw Error(fmt::format("target '{}' is not on this machine; targets: auto, {}", name, fmt::join(available, ", ")));
}

}  // namespace axiscert

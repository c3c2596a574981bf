// The registry: the kernels of all predicates in the order of the predicates, and those that an id composes.
#include "kernel/kernel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <iterator>
#include <mutex>

#include "kernel/base/error.h"
#include "kernel/formulae_list.h"
#include "kernel/moving_sphere/kernels.h"
#include "kernel/mutants/mutant.h"
#include "kernel/permitted/kernels.h"
#include "kernel/plugin/load.h"
#include "kernel/predicate_list.h"
#include "kernel/registry/called.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {

#define AXISCERT_DECLARE(name) std::vector<Kernel> name##_kernels();
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

namespace {

const std::vector<Kernel>& registry() {
  static const std::vector<Kernel> all = [] {
    std::vector<Kernel> kernels;
    const auto append = [&](std::vector<Kernel> more) {
      kernels.insert(kernels.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
#define AXISCERT_APPEND(name) append(name##_kernels());
    AXISCERT_PREDICATES(AXISCERT_APPEND)
#undef AXISCERT_APPEND
    return kernels;
  }();
  return all;
}

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
  if (!rung.predicate->claims_arithmetic) return moving_sphere::twenty_in(id, rung, arithmetic);
  Kernel kernel;
  kernel.id = id;
  kernel.summary = fmt::format("{}; {}", rung.summary, arithmetic.summary);
  kernel.predicate = rung.predicate;
  kernel.formulae = rung.formulae;
  kernel.strictness = rung.strictness;
  kernel.arithmetic = arithmetic.arithmetic;
  kernel.exposes = arithmetic.exposes;
  const auto implementation = [f = formulae_of(rung), a = arithmetic.arithmetic, s = rung.strictness]<class Real>() {
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

// The message about an id that names no kernel: that a plug-in's file wants "plugin:", or which kernels there are.
std::string unknown_kernel(std::string_view id) {
  std::vector<std::string_view> known;
  for (const Kernel& kernel : registry()) known.push_back(kernel.id);
  const std::string path = plugin::misnamed_path(id);
  if (path.ends_with(".json")) {
    return fmt::format("unknown kernel '{}'; a program is given by its manifest, with 'program:' before the path: {}{}",
                       id, plugin::by_manifest, path);
  }
  if (!path.empty()) {
    return fmt::format("unknown kernel '{}'; a plug-in is given by its file, with 'plugin:' before the path: {}{}", id,
                       plugin::by_path, path);
  }
  std::vector<std::string> shipped;
  for (const plugin::ShippedPlugins& kind : plugin::shipped_plugins()) {
    for (const std::string& name : kind.names) shipped.push_back(fmt::format("{}{}", kind.prefix, name));
  }
  std::vector<std::string_view> guessed = known;
  guessed.insert(guessed.end(), shipped.begin(), shipped.end());
  const bool is_list = id.find(',') != id.npos;
  return fmt::format("unknown kernel '{}'{} plugin:PATH.so or program:MANIFEST.json is one of your own; {}", id,
                     is_list ? "; one kernel is given at a time, without commas;" : did_you_mean(id, guessed),
                     names_alike("kernels", id, known, "axiscert kernels --predicate ID"));
}

std::string with_dashes(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

bool has_comparisons(const Kernel& kernel) {
  const auto& methods = kernel.predicate->methods;
  return !kernel.formulae.empty() && std::find(methods.begin(), methods.end(), kernel.formulae) == methods.end();
}

std::string name(Arithmetic arithmetic) {
  constexpr EnumArray<Arithmetic, const char*> names = {
#define AXISCERT_NAME(name, type, summary) #name,
      AXISCERT_ARITHMETICS(AXISCERT_NAME)
#undef AXISCERT_NAME
  };
  return with_dashes(names[arithmetic]);
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
  if (const Kernel* kernel = given_kernel(id)) return *kernel;
  if (const auto at = call_in(id)) return found_as_called(id.substr(0, *at), id.substr(*at + 1));
  if (const auto path = plugin::plugin_path(id))
    return kept(printable_line(id), [&] {
      return plugin::is_program(id, *path) ? plugin::load_program(std::string(id), *path)
                                           : plugin::load_plugin(std::string(id), *path);
    });
  if (id.find('~') != id.npos) return kept(id, [&] { return mutants::kernel_of(mutants::find_mutant(id)); });
  const std::size_t plus = id.find('+');
  if (plus == id.npos) {
    throw Error(unknown_kernel(id));
  }
  const std::string_view rung_id = id.substr(0, plus), arithmetic_name = id.substr(plus + 1);
  const Kernel* rung = registered(rung_id);
  std::vector<std::string_view> known;
  const std::vector<std::string> permitted = permitted::names();
  if (rung && std::find(permitted.begin(), permitted.end(), arithmetic_name) != permitted.end())
    return kept(id, [&] { return *permitted::kernel(id, *rung, arithmetic_name); });
  for (const Kernel& kernel : registry()) {
    if (kernel.takes_arithmetic) known.push_back(kernel.id);
  }
  if (!rung || !rung->takes_arithmetic) {
    throw Error(fmt::format("kernel '{}': '{}' is not a rung that takes another arithmetic{} rungs that do: {}", id,
                            rung_id, did_you_mean(rung_id, known), fmt::join(most_alike_first(rung_id, known), ", ")));
  }
  known.clear();
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    if (arithmetic.name == arithmetic_name) return kept(id, [&] { return composed(id, *rung, arithmetic); });
    known.push_back(arithmetic.name);
  }
  known.insert(known.end(), permitted.begin(), permitted.end());
  throw Error(fmt::format("kernel '{}': {}", id, unknown_name("arithmetic", "arithmetics", arithmetic_name, known)));
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
  const std::vector<std::string_view> known(available.begin(), available.end());
  throw Error(fmt::format("target '{}' is not on this machine{} targets: auto, {}", name, did_you_mean(name, known),
                          fmt::join(available, ", ")));
}

namespace {

struct GivenKernels {
  std::mutex mutex;
  std::deque<Kernel> all;  // the newest of an id is the last
};
GivenKernels& given_kernels() {
  static GivenKernels given;
  return given;
}

}  // namespace

const Kernel& give_kernel(Kernel kernel) {
  if (std::ranges::any_of(kernels(), [&](const Kernel& own) { return own.id == kernel.id; }))
    throw Error(fmt::format("kernel '{}': that is a built-in kernel; give another name", kernel.id));
  GivenKernels& given = given_kernels();
  const std::lock_guard lock(given.mutex);
  return given.all.emplace_back(std::move(kernel));
}

const Kernel* given_kernel(std::string_view id) {
  GivenKernels& given = given_kernels();
  const std::lock_guard lock(given.mutex);
  const auto found = std::find_if(given.all.rbegin(), given.all.rend(), [&](const Kernel& k) { return k.id == id; });
  return found == given.all.rend() ? nullptr : &*found;
}

}  // namespace axiscert

#include "plans/claimed_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "exact/judge/oracles.h"
#include "kernel/base/error.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

// The built-in kernel that an option names, checked to fit what the replies show.
const Kernel& claimed(const char* option, const std::string& id, const ShownAnswers& shown) {
  if (plugin::plugin_path(id))
    throw Error(fmt::format("{} {}: not a built-in kernel; see `axiscert kernels`", option, id));
  const Kernel& kernel = find_kernel(id);
  if (kernel.predicate != shown.predicate) {
    throw Error(fmt::format("{} {}: of the predicate {}, and the replies are to queries of {}", option, id,
                            kernel.predicate->id, shown.predicate->id));
  }
  for (const Precision precision : shown.precisions) {
    if (!kernel.has(precision)) throw Error(fmt::format("{} {}: does not exist in {}", option, id, name(precision)));
  }
  if (shown.has_bits && !has_comparisons(kernel)) {
    throw Error(fmt::format("{} {}: it has no comparisons, but the replies give comparison bits", option, id));
  }
  return kernel;
}

bool is_id(const std::string& id) {
  return !id.empty() && id.size() <= 100 && std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  });
}

// Declares for the kernel which sides of a triangle it promises, and its margin.
void promise(const KernelClaims& options, Kernel& kernel) {
  const Predicate& predicate = *kernel.predicate;
  if (options.sides == name(SidesPolicy::front)) {
    if (is_of_motions(predicate)) kernel.motion.sides = SidesPolicy::front;
    else if (predicate.has_front) kernel.limits.sides = SidesPolicy::front;
    else throw Error(fmt::format("--sides front: the predicate {} has no triangle with a front", predicate.id));
  }
  kernel.limits.margin = options.margin;
  if (options.margin != 0 && kernel.touching == TouchingPolicy::separated)
    throw Error(
        fmt::format("--margin {}: contact may be reported within it, so --touching is contact or either, not "
                    "separated",
                    options.margin));
}

}  // namespace

Kernel claimed_kernel(const KernelClaims& options, const ShownAnswers& shown) {
  if (!is_id(options.id))
    throw Error(fmt::format("--as {}: an id is 1 to 100 letters, digits, '-', '_', '.'", options.id));
  for (const Kernel& kernel : kernels()) {
    if (kernel.id == options.id) throw Error(fmt::format("--as {}: that is a built-in kernel", options.id));
  }
  const Predicate& predicate = *shown.predicate;
  std::string formulae;
  if (shown.has_bits) {
    formulae = predicate.usual_formulae.empty() ? std::string(oracles_of(predicate).formulae().front())
                                                : find_kernel(predicate.usual_formulae).formulae;
  }
  Kernel kernel{.id = options.id,
                .summary = {},
                .formulae = std::move(formulae),
                .exposes = shown.has_bits ? Exposure::comparisons : Exposure::verdict,
                .binary32 = {},
                .binary64 = {},
                .is_reference = false};
  kernel.predicate = &predicate;
  kernel.entry = shown.entry;
  kernel.measure_count = shown.measure_count;
  if (const std::string& id = options.claim.conforms_to; !id.empty()) {
    const Kernel& model = claimed("--conforms-to", id, shown);
    if (!model.is_reference) {
      throw Error(
          fmt::format("--conforms-to {}: it chooses its own order of operations, so nothing can be compared with "
                      "it bit for bit; --formulae {} judges by its formulae",
                      id, id));
    }
    kernel.formulae = model.formulae;
    kernel.strictness = model.strictness;
    kernel.arithmetic = model.arithmetic;
    kernel.is_reference = true;
  }
  if (const std::string& id = options.claim.formulae; !id.empty()) {
    const Kernel& model = claimed("--formulae", id, shown);
    kernel.formulae = model.formulae;
    kernel.strictness = model.strictness;
  }
  const auto touching = std::find(touching_names.begin(), touching_names.end(), options.touching);
  kernel.touching = static_cast<TouchingPolicy>(touching - touching_names.begin());
  kernel.may_decline = options.may_decline;
  promise(options, kernel);
  return kernel;
}

}  // namespace axiscert

#include "plans/predicate_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <fmt/ranges.h>

#include "exact/judge/oracles.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// "family 'tangent'", "mesh/spider.obj".
std::string shown_source(const Source& source) {
  return source.file() ? source.name() : fmt::format("family '{}'", source.name());
}

std::string_view entry_name(const Predicate& predicate, std::size_t entry) { return predicate.entries[entry].name; }

}  // namespace

const Predicate& default_predicate() { return predicate_named(""); }

const Predicate& predicate_given(const std::string& predicate) {
  return predicate.empty() ? default_predicate() : find_predicate(predicate);
}

const Predicate& predicate_of_kernels(const std::string& predicate, const std::vector<const Kernel*>& kernels) {
  if (!predicate.empty()) {
    const Predicate& given = find_predicate(predicate);
    for (const Kernel* kernel : kernels) {
      if (kernel->predicate == &given) continue;
      throw Error(fmt::format(
          "kernel '{}' is of the predicate {}, and --predicate is {}; a run judges kernels of one predicate",
          kernel->id, kernel->predicate->id, given.id));
    }
    return given;
  }
  for (const Kernel* kernel : kernels) {
    if (kernel->predicate == kernels.front()->predicate) continue;
    throw Error(
        fmt::format("kernel '{}' is of the predicate {}, and kernel '{}' of {}; a run judges kernels of one predicate",
                    kernels.front()->id, kernels.front()->predicate->id, kernel->id, kernel->predicate->id));
  }
  return kernels.empty() ? default_predicate() : *kernels.front()->predicate;
}

const Kernel& default_kernel(const Predicate& predicate, std::size_t entry) {
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate == &predicate && kernel.entry == entry) return kernel;
  }
  throw Error(fmt::format("the predicate {} has no built-in kernel; give one with --kernel", predicate.id));
}

std::size_t entry_of_families(const Predicate& predicate, const std::vector<std::string>& families) {
  for (const std::string& name : families) {
    if (name == "all") continue;
    if (const Family& family = find_family(name); &family.predicate() == &predicate) return family.entry;
  }
  return 0;
}

std::vector<const Family*> families_named(const std::vector<std::string>& names, const Predicate& predicate,
                                          std::size_t entry) {
  std::vector<const Family*> named;
  for (const std::string& name : names) {
    if (name != "all") named.push_back(&find_family(name));
    else std::ranges::copy(families_of(predicate, entry), std::back_inserter(named));
  }
  return named;
}

void require_one_predicate(const std::vector<const Kernel*>& kernels, const std::vector<SourcePtr>& sources) {
  for (const SourcePtr& source : sources) {
    for (const Kernel* kernel : kernels) {
      if (kernel->predicate != &source->predicate()) {
        throw Error(fmt::format(
            "kernel '{}' is of the predicate {}, and {} of {}; a run judges kernels of one predicate (--predicate)",
            kernel->id, kernel->predicate->id, shown_source(*source), source->predicate().id));
      }
      if (kernel->entry != source->entry()) {
        throw Error(
            fmt::format("kernel '{}' takes the entry {} of the predicate {}, and {} has {}; a kernel is judged on "
                        "queries of its own "
                        "entry",
                        kernel->id, entry_name(*kernel->predicate, kernel->entry), kernel->predicate->id,
                        shown_source(*source), entry_name(source->predicate(), source->entry())));
      }
    }
  }
}

const Predicate& predicate_of_sources(const std::string& predicate, const std::vector<SourcePtr>& sources) {
  const Predicate& given =
      predicate.empty() && !sources.empty() ? sources.front()->predicate() : predicate_given(predicate);
  for (const SourcePtr& source : sources) {
    if (&source->predicate() == &given) continue;
    const std::string other = predicate.empty() ? fmt::format("{} of {}", shown_source(*sources.front()), given.id)
                                                : fmt::format("--predicate is {}", given.id);
    throw Error(fmt::format("{} is of the predicate {}, and {}; queries of one predicate go together{}",
                            shown_source(*source), source->predicate().id, other,
                            predicate.empty() ? " (--predicate)" : ""));
  }
  return given;
}

bool has_critical_length(const Predicate& predicate, std::size_t entry) {
  return oracles_of(predicate, entry).critical_length().has_value();
}

bool has_filters(const Predicate& predicate, std::size_t entry) { return oracles_of(predicate, entry).has_filters(); }

bool has_moves(const Predicate& predicate, std::size_t entry) { return predicate.entries[entry].has_free_numbers; }

bool has_error_aims(const Predicate& predicate, std::size_t) {
  return capabilities_of(predicate).aim_values != nullptr;
}

bool has_image_maps(const Predicate& predicate, std::size_t) {
  return capabilities_of(predicate).image_maps != nullptr;
}

bool has_formulae(const Predicate& predicate, std::size_t entry) {
  return predicate.claims_arithmetic && std::ranges::any_of(kernels(), [&](const Kernel& kernel) {
           return kernel.predicate == &predicate && kernel.entry == entry && !kernel.formulae.empty();
         });
}

std::string ids_of(const std::vector<const Predicate*>& predicates) {
  std::vector<std::string_view> ids;
  for (const Predicate* predicate : predicates) ids.push_back(predicate->id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

std::vector<const Predicate*> predicates_with(Capability& capability) {
  std::vector<const Predicate*> able;
  for (const Predicate* predicate : predicates()) {
    std::size_t entry = 0;
    while (entry < predicate->entries.size() && !capability(*predicate, entry)) ++entry;
    if (entry < predicate->entries.size()) able.push_back(predicate);
  }
  return able;
}

void require_capability(Capability& capability, std::string_view command, const Predicate& predicate,
                        std::size_t entry) {
  require_served(command, predicate, predicates_with(capability));
  if (capability(predicate, entry)) return;
  std::vector<std::string_view> able;
  for (std::size_t other = 0; other < predicate.entries.size(); ++other) {
    if (capability(predicate, other)) able.push_back(entry_name(predicate, other));
  }
  throw Error(fmt::format("{} does not serve the entry {} of the predicate {} yet; it serves {}", command,
                          entry_name(predicate, entry), predicate.id, fmt::join(able, ", ")));
}

void require_moves(std::string_view command, const Predicate& predicate, std::size_t entry) {
  require_capability(has_moves, command, predicate, entry);
}

void require_served(std::string_view command, const Predicate& predicate, const std::vector<const Predicate*>& served) {
  if (std::ranges::find(served, &predicate) != served.end()) return;
  throw Error(
      fmt::format("{} does not serve the predicate {} yet; it serves {}", command, predicate.id, ids_of(served)));
}

}  // namespace axiscert

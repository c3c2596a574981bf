#include "plans/query_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/files/query_file.h"
#include "kernel/base/error.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"

namespace axiscert {
std::string QueryPart::folder() const {
  return entry == 0 ? std::string(predicate->id) : fmt::format("{}-{}", predicate->id, predicate->entries[entry].name);
}

std::vector<QueryPart> query_parts(const std::vector<std::string>& files, Precision csv_precision,
                                   const std::string& predicate, const std::vector<std::string>& kernels) {
  std::vector<QueryPart> parts;
  std::vector<std::string> texts;
  for (const std::string& file : files) {
    const std::vector<SourcePtr> sources = query_file_sources(file, csv_precision);
    texts.push_back(fmt::format("{}: {}", file == "-" ? "stdin" : file, parts_text(counts_of(sources))));
    for (const SourcePtr& source : sources) {
      if (!predicate.empty() && source->predicate().id != predicate) continue;
      const bool is_there = std::ranges::any_of(parts, [&](const QueryPart& part) {
        return part.predicate == &source->predicate() && part.entry == source->entry();
      });
      if (!is_there) parts.push_back({&source->predicate(), source->entry(), {}});
    }
  }
  if (parts.size() < 2) return parts;
  const std::string there = fmt::format("{}", fmt::join(texts, "; "));
  for (const std::string& id : kernels) {
    const Kernel& kernel = find_kernel(id);
    const auto part = std::ranges::find_if(parts, [&](const QueryPart& other) {
      return other.predicate == kernel.predicate && other.entry == kernel.entry;
    });
    if (part == parts.end()) {
      throw Error(fmt::format("--kernel {}: it is of {}; {}", id, part_text(*kernel.predicate, kernel.entry), there));
    }
    part->kernels.push_back(id);
  }
  for (const QueryPart& part : parts) {
    if (kernels.empty() || !part.kernels.empty()) continue;
    throw Error(
        fmt::format("no kernel is given for the queries of {}; {}; add one with --kernel, or give none: then "
                    "each part is judged by the first of its predicate",
                    part_text(*part.predicate, part.entry), there));
  }
  notice("{}", there);
  return parts;
}

void require_one_of_each(std::span<const Kernel* const> given) {
  for (const Kernel* kernel : given) {
    for (const Kernel* other : given) {
      if (other == kernel) break;
      if (other->predicate != kernel->predicate || other->entry != kernel->entry) continue;
      throw Error(fmt::format("--kernel {} and {}: the queries of a file are judged by one kernel of their predicate",
                              other->id, kernel->id));
    }
  }
}

const Kernel& kernel_for_query(std::span<const Kernel* const> given, const Predicate& predicate, std::size_t entry,
                               std::string_view what) {
  const auto found = std::ranges::find_if(
      given, [&](const Kernel* kernel) { return kernel->predicate == &predicate && kernel->entry == entry; });
  if (found != given.end()) return **found;
  if (given.empty()) return default_kernel(predicate, entry);
  std::vector<std::string> texts;
  for (const Kernel* kernel : given)
    texts.push_back(fmt::format("{} of {}", kernel->id, part_text(*kernel->predicate, kernel->entry)));
  throw Error(fmt::format("{} is of {}, and no kernel of it is given: {}", what, part_text(predicate, entry),
                          fmt::join(texts, ", ")));
}

}  // namespace axiscert

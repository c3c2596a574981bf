#include "kernel/plugin/pipe_format.h"

#include <fmt/format.h>

#include <cstring>

#include "kernel/base/sha256.h"

namespace axiscert {

std::string pipe::stream_header(std::string plan, std::size_t columns, Precision precision, std::uint64_t count) {
  const std::size_t whole = sizeof(Head) + plan.size();
  plan.append((header_multiple - whole % header_multiple) % header_multiple, ' ');
  const Head head{magic,
                  version,
                  code_of(precision),
                  count,
                  static_cast<std::uint32_t>(sizeof(Head) + plan.size()),
                  record_size_of(precision, columns),
                  sha256(std::as_bytes(std::span(plan)))};
  std::string bytes(sizeof head, '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes + plan;
}

std::string plugin::program_header(const Predicate& predicate, std::size_t entry, Precision precision,
                                   std::size_t measures) {
  const PredicateEntry& given = predicate.entries[entry];
  const std::string more = measures == 0 ? "" : fmt::format(R"(,"measures":{})", measures);
  std::string plan = fmt::format(R"({{"precision":"{}","predicate":"{}","entry":"{}","columns":{}{}}})"
                                 "\n",
                                 name(precision), predicate.id, given.name, given.columns.size(), more);
  return pipe::stream_header(std::move(plan), given.columns.size(), precision, 0);
}

}  // namespace axiscert

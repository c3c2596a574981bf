#include "kernel/plugin/host/offered.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>

namespace axiscert::plugin {
namespace {

// The least sizes in bytes: a kernel down to `run`, limits with their first member.
constexpr std::size_t least_kernel = offsetof(axiscert_kernel, predicate);
constexpr std::size_t least_limits = offsetof(axiscert_limits, greatest_coordinate);

template <class T>
T first_of(const void* from) {
  T first;
  std::memcpy(&first, from, sizeof first);
  return first;
}

// The members of T that `size` bytes cover; the others are zero.
template <class T>
T as_far_as(std::size_t size, const void* from) {
  T read = {};
  std::memcpy(&read, from, std::min(size, sizeof read));
  return read;
}

void read_kernel(const void* from, OfferedKernel& out) {
  const auto* const bytes = static_cast<const std::byte*>(from);
  const auto size = first_of<std::size_t>(bytes + offsetof(axiscert_kernel, size));
  out.says.size = size;
  if (size < least_kernel) return;
  out.says = as_far_as<axiscert_kernel>(size, from);
  if (out.says.limits == nullptr) return;
  out.limits = as_far_as<axiscert_limits>(first_of<std::size_t>(out.says.limits), out.says.limits);
}

template <std::size_t size>
bool copy_text(char (&to)[size], const char* from) {
  std::snprintf(to, size, "%s", from ? from : "");
  return from == nullptr || std::strlen(from) < size;
}

// The end of a long path says more than its beginning.
template <std::size_t size>
void copy_end(char (&to)[size], const char* from) {
  const std::size_t length = from ? std::strlen(from) : 0;
  copy_text(to, length < size ? from : from + length - (size - 1));
}

}  // namespace

OfferedKernel offered(const void* kernel) {
  OfferedKernel out;
  out.abi = first_of<std::uint32_t>(kernel);
  if (out.abi == AXISCERT_PLUGIN_ABI) read_kernel(kernel, out);
  return out;
}

void describe(const OfferedKernel& kernel, Description& out) {
  const axiscert_kernel& says = kernel.says;
  const axiscert_limits& l = kernel.limits;
  out.abi = kernel.abi;
  out.size = says.size;
  out.least_size = least_kernel;
  out.has_limits = says.limits != nullptr;
  out.limits_size = l.size;
  out.least_limits_size = least_limits;
  out.precision = says.precision;
  out.exposes = says.exposes;
  out.touching = says.touching;
  out.start = says.start;
  out.still = says.still;
  out.sides = says.sides;
  out.may_decline = says.may_decline;
  out.column_count = says.column_count;
  out.measure_count = says.measure_count;
  const double limits[] = {l.least_coordinate, l.greatest_coordinate, l.least_area,
                           l.least_radius,     l.greatest_radius,     l.margin};
  static_assert(sizeof limits == sizeof out.limits);
  std::memcpy(out.limits, limits, sizeof limits);
  out.has_run = says.run != nullptr;
  out.has_conforms_to = says.conforms_to != nullptr;
  out.has_formulae = says.formulae != nullptr;
  const bool fits[] = {copy_text(out.name, says.name),
                       copy_text(out.summary, says.summary),
                       copy_text(out.predicate, says.predicate),
                       copy_text(out.entry, says.entry),
                       copy_text(out.conforms_to, says.conforms_to),
                       copy_text(out.formulae, says.formulae)};
  for (const bool fit : fits) out.is_truncated |= !fit;
  copy_end(out.source, says.source);
}

Call::Call(const OfferedKernel& kernel, const Request& request, const Arrays& arrays) : kernel_(kernel) {
  const Shape& shape = arrays.shape;
  batch_ = {sizeof batch_, request.size, shape.columns, column_};
  for (std::size_t k = 0; k < shape.columns; ++k) column_[k] = arrays.first(k);
  answers_.size = sizeof answers_;
  answers_.verdict = reinterpret_cast<std::uint8_t*>(arrays.first(shape.verdict()));
  if (request.exposes >= AXISCERT_COMPARISONS) {
    answers_.comparisons = reinterpret_cast<std::uint64_t*>(arrays.first(shape.bits()));
  }
  answers_.comparison_count = shape.comparisons;
  if (request.exposes >= AXISCERT_SIDES) {
    for (std::size_t k = 0; k < shape.comparisons; ++k) {
      lhs_[k] = arrays.first(shape.lhs() + k);
      rhs_[k] = arrays.first(shape.rhs() + k);
    }
    answers_.lhs = lhs_;
    answers_.rhs = rhs_;
  }
  answers_.measure_count = request.measures;
  for (std::size_t k = 0; k < request.measures; ++k) measure_[k] = arrays.first(shape.measure() + k);
  if (request.measures > 0) answers_.measure = measure_;
}

}  // namespace axiscert::plugin

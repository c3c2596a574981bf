#include "kernel/plugin/caller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace axiscert::plugin {
namespace {

// Bytes looked at to each side of an output; what a stray write farther off hits is a guard page at other placements.
constexpr std::size_t watched = 256;

template <class T>
void copy_out(std::span<const std::byte> from, std::vector<T>& to) {
  to.resize(from.size() / sizeof(T));
  std::memcpy(to.data(), from.data(), from.size());
}

// What lies around an array in its area, as far as it is looked at.
struct Surroundings {
  std::span<std::byte> before, after;
};
Surroundings around(std::byte* area, std::size_t area_bytes, std::span<std::byte> array) {
  std::byte *const end = array.data() + array.size(), *const area_end = area + area_bytes;
  const std::size_t before = std::min(watched, static_cast<std::size_t>(array.data() - area));
  return {{array.data() - before, before}, {end, std::min(watched, static_cast<std::size_t>(area_end - end))}};
}

}  // namespace

template <class Real>
std::span<std::byte> Caller<Real>::array(std::size_t which, std::size_t size, Placement placement) const {
  const std::size_t element = element_size(which, sizeof(Real));
  return {process_.area(which) + array_offset(placement, size, element, process_.area_bytes()), size * element};
}

template <class Real>
template <class Visit>
void Caller<Real>::for_each_output(Exposure asked, const Visit& visit) const {
  const std::size_t end = asked == Exposure::sides         ? array_count
                          : asked == Exposure::comparisons ? comparisons_array + 1
                                                           : verdict_array + 1;
  for (std::size_t which = verdict_array; which < end; ++which) visit(which);
}

template <class Real>
auto Caller<Real>::call(const QueryColumns<Real>& batch, std::size_t first, std::size_t size,
                        const Arrangement& arrangement, double seconds, Outputs<Real>& out) -> Result {
  const auto place = [&](std::size_t which) { return array(which, size, arrangement.placement); };
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    std::memcpy(place(k).data(), batch.column[k] + first, size * sizeof(Real));
  }
  const auto filling = std::byte{arrangement.filling};
  for_each_output(arrangement.asked, [&](std::size_t which) {
    const auto [before, after] = around(process_.area(which), process_.area_bytes(), place(which));
    std::fill(before.data(), after.data() + after.size(), filling);
  });

  out.verdicts.clear();
  out.answers.resize(0);
  Result result;
  const Request request{kernel_, static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(arrangement.asked),
                        arrangement.placement};
  result.stop = process_.call(request, seconds, result.reply);
  if (result.stop) return result;

  for_each_output(arrangement.asked, [&](std::size_t which) {
    const auto [before, after] = around(process_.area(which), process_.area_bytes(), place(which));
    const auto is_written = [&](std::byte b) { return b != filling; };
    const bool wrote_before = std::any_of(before.begin(), before.end(), is_written);
    if (result.stray || (!wrote_before && std::none_of(after.begin(), after.end(), is_written))) return;
    result.stray =
        Stop{FindingKind::out_of_bounds,
             fmt::format("wrote {} {}, which has {} {}", wrote_before ? "before the begin of" : "past the end of",
                         array_name(which), size, size == 1 ? "entry" : "entries"),
             wrote_before ? 0 : size - 1};
  });
  copy_out(place(verdict_array), out.verdicts);
  if (arrangement.asked >= Exposure::comparisons) copy_out(place(comparisons_array), out.answers.bits);
  for (std::size_t k = 0; k < comparison_count && arrangement.asked >= Exposure::sides; ++k) {
    copy_out(place(lhs_array + k), out.answers.lhs[k]);
    copy_out(place(rhs_array + k), out.answers.rhs[k]);
  }
  return result;
}

template class Caller<float>;
template class Caller<double>;

}  // namespace axiscert::plugin

#include "kernel/plugin/caller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace axiscert::plugin {
namespace {

// Whether any byte is not the filling.
bool is_written(std::span<const std::byte> bytes, std::byte filling) {
  if (bytes.empty()) return false;
  return bytes.front() != filling || std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) != 0;
}

template <class T>
void copy_out(std::span<const std::byte> from, std::vector<T>& to) {
  to.resize(from.size() / sizeof(T));
  std::memcpy(to.data(), from.data(), from.size());
}

}  // namespace

template <class Real>
std::span<std::byte> Caller<Real>::array(std::size_t which, std::size_t size, Placement placement) const {
  const std::size_t element = element_size(which, sizeof(Real));
  return {process_->area(which) + array_offset(placement, size, element, process_->area_bytes()), size * element};
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
  if (!process_) process_.emplace(path_);
  if (!process_->is_running()) seconds = std::max(seconds, first_seconds_);  // it may have tables to make
  const auto place = [&](std::size_t which) { return array(which, size, arrangement.placement); };
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    std::memcpy(place(k).data(), batch.column[k] + first, size * sizeof(Real));
  }
  const auto filling = std::byte{arrangement.filling};
  for_each_output(arrangement.asked,
                  [&](std::size_t which) { std::fill_n(process_->area(which), process_->area_bytes(), filling); });

  out.verdicts.clear();
  out.answers.resize(0);
  Result result;
  const Request request{kernel_, static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(arrangement.asked),
                        arrangement.placement};
  result.stop = process_->call(request, seconds, result.reply);
  if (result.stop) return result;

  for_each_output(arrangement.asked, [&](std::size_t which) {
    const std::span<std::byte> area{process_->area(which), process_->area_bytes()}, written = place(which);
    const auto begin = static_cast<std::size_t>(written.data() - area.data());
    const bool wrote_before = is_written(area.first(begin), filling);
    if (result.stray || (!wrote_before && !is_written(area.subspan(begin + written.size()), filling))) return;
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

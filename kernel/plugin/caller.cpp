#include "kernel/plugin/caller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "kernel/base/error.h"

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
  const std::size_t element = entry_bytes(process_->shape(), which, sizeof(Real));
  return {process_->area(which) + array_offset(placement, size, element, process_->area_bytes()), size * element};
}

template <class Real>
template <class Visit>
void Caller<Real>::for_each_output(const Arrangement& arrangement, const Visit& visit) const {
  const Shape& shape = process_->shape();
  const Exposure asked = arrangement.asked;
  const std::size_t end = asked == Exposure::sides         ? shape.measure()
                          : asked == Exposure::comparisons ? shape.bits() + 1
                                                           : shape.verdict() + 1;
  for (std::size_t which = shape.verdict(); which < end; ++which) visit(which);
  for (std::size_t k = 0; k < arrangement.measures; ++k) visit(shape.measure() + k);
}

template <class Real>
auto Caller<Real>::call(const QueryColumns<Real>& batch, std::size_t first, std::size_t size,
                        const Arrangement& arrangement, double seconds, Outputs<Real>& out) -> Result {
  const Shape shape = callee_.subject.shape();
  if (batch.count != shape.columns) {
    throw HarnessFault(fmt::format("plug-in {}: its predicate takes {} columns; the batch has {}", callee_.hosted.path,
                                   shape.columns, batch.count));
  }
  if (!process_) process_.emplace(callee_.hosted, callee_.subject);
  // It may have tables to make.
  if (!process_->is_running() && !callee_.hosted.is_program()) seconds = std::max(seconds, first_seconds_);
  const auto place = [&](std::size_t which) { return array(which, size, arrangement.placement); };
  for (std::size_t k = 0; k < shape.columns; ++k) {
    std::memcpy(place(k).data(), batch.column[k] + first, size * sizeof(Real));
  }
  const auto filling = std::byte{arrangement.filling};
  for_each_output(arrangement,
                  [&](std::size_t which) { std::fill_n(process_->area(which), process_->area_bytes(), filling); });

  out.verdicts.clear();
  out.bits.clear();
  out.lhs.assign(shape.comparisons, {});
  out.rhs.assign(shape.comparisons, {});
  out.measures.assign(arrangement.measures, {});
  Result result;
  const Request request{.kernel = callee_.index,
                        .size = static_cast<std::uint32_t>(size),
                        .exposes = static_cast<std::uint32_t>(arrangement.asked),
                        .measures = static_cast<std::uint32_t>(arrangement.measures),
                        .placement = arrangement.placement,
                        .seconds = seconds,
                        .start_seconds = program_start * first_seconds_};
  result.stop = process_->call(request, seconds, result.reply);
  if (result.stop) return result;

  for_each_output(arrangement, [&](std::size_t which) {
    const std::span<std::byte> area{process_->area(which), process_->area_bytes()}, written = place(which);
    const auto begin = static_cast<std::size_t>(written.data() - area.data());
    const bool wrote_before = is_written(area.first(begin), filling);
    if (result.stray || (!wrote_before && !is_written(area.subspan(begin + written.size()), filling))) return;
    result.stray =
        Stop{FindingKind::out_of_bounds,
             fmt::format("wrote {} {}, which has {} {}", wrote_before ? "before the begin of" : "past the end of",
                         callee_.subject.array_name(which), size, size == 1 ? "entry" : "entries"),
             wrote_before ? 0 : size - 1};
  });
  copy_out(place(shape.verdict()), out.verdicts);
  if (arrangement.asked >= Exposure::comparisons) copy_out(place(shape.bits()), out.bits);
  for (std::size_t k = 0; k < shape.comparisons && arrangement.asked >= Exposure::sides; ++k) {
    copy_out(place(shape.lhs() + k), out.lhs[k]);
    copy_out(place(shape.rhs() + k), out.rhs[k]);
  }
  for (std::size_t k = 0; k < arrangement.measures; ++k) copy_out(place(shape.measure() + k), out.measures[k]);
  return result;
}

template class Caller<float>;
template class Caller<double>;

namespace {

template <class Real>
bool same(Real a, Real b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

// The name of the comparison, or the number of a bit beyond the last one.
std::string comparison_text(const Predicate& predicate, std::size_t which) {
  return which < predicate.comparisons.size() ? std::string(predicate.comparisons[which].name) : std::to_string(which);
}

}  // namespace

template <class Real>
std::optional<std::string> difference_at(const Predicate& predicate, const Outputs<Real>& a, std::size_t i,
                                         const Outputs<Real>& b, std::size_t j) {
  if (a.verdicts[i] != b.verdicts[j]) {
    return fmt::format("verdict {}, then {}", verdict_text(a.verdicts[i]), verdict_text(b.verdicts[j]));
  }
  for (std::size_t k = 0; k < b.measures.size(); ++k) {
    const Real before = a.measures[k][i], after = b.measures[k][j];
    if (!same(before, after)) return fmt::format("{} {:a}, then {:a}", predicate.measures[k].name, before, after);
  }
  if (b.bits.empty()) return std::nullopt;
  if (const std::uint64_t flipped = a.bits[i] ^ b.bits[j]) {
    const std::size_t which = first_bit(flipped);
    const int before = has_bit(a.bits[i], which);
    return fmt::format("comparison {} {}, then {}", comparison_text(predicate, which), before, 1 - before);
  }
  for (std::size_t k = 0; k < b.lhs.size() && !b.lhs[k].empty(); ++k) {
    for (const auto& [side, before, after] :
         {std::tuple{"lhs", a.lhs[k][i], b.lhs[k][j]}, std::tuple{"rhs", a.rhs[k][i], b.rhs[k][j]}}) {
      if (!same(before, after)) {
        return fmt::format("{} of {} {:a}, then {:a}", side, predicate.comparisons[k].name, before, after);
      }
    }
  }
  return std::nullopt;
}

template std::optional<std::string> difference_at(const Predicate&, const Outputs<float>&, std::size_t,
                                                  const Outputs<float>&, std::size_t);
template std::optional<std::string> difference_at(const Predicate&, const Outputs<double>&, std::size_t,
                                                  const Outputs<double>&, std::size_t);

std::string verdict_text(std::uint8_t verdict) {
  if (is_verdict(verdict)) return std::string(name(static_cast<Verdict>(verdict)));
  return fmt::format("{}, which is no verdict", verdict);
}

template <class Real>
std::optional<Difference> first_difference(const Predicate& predicate, const Outputs<Real>& a, std::size_t first,
                                           const Outputs<Real>& b) {
  for (std::size_t i = 0; i < b.verdicts.size(); ++i) {
    if (auto detail = difference_at(predicate, a, first + i, b, i)) return Difference{i, std::move(*detail)};
  }
  return std::nullopt;
}
template std::optional<Difference> first_difference(const Predicate&, const Outputs<float>&, std::size_t,
                                                    const Outputs<float>&);
template std::optional<Difference> first_difference(const Predicate&, const Outputs<double>&, std::size_t,
                                                    const Outputs<double>&);

}  // namespace axiscert::plugin

#include "fuzz/moving_sphere/time_mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/moving_sphere/first_contact.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert::moving_sphere {
namespace {

// The least root of any feature that is nearest at some time, at whatever time in [0, 1] the root is; `reversed`: but
// not inside the times at which its feature is nearest.
template <class Real>
std::optional<Real> least_ungated(const MovingQuery<double>& q, const MotionPieces& motion, bool reversed) {
  std::optional<Real> least;
  for (const Piece& piece : motion.pieces) {
    MotionPieces alone = motion;
    alone.pieces = {piece};
    alone.pieces.front().first = 0;
    alone.pieces.front().last = 1;
    const std::optional<FirstContact> contact = first_contact(q, alone);
    if (!contact) continue;
    const bool is_inside = compare(contact->time, piece.first) > 0 && compare(contact->time, piece.last) < 0;
    if (reversed && is_inside) continue;
    const Real time = rounded_down<Real>(contact->time);
    least = std::min(least.value_or(time), time);
  }
  return least;
}

template <class Real>
Real rounded_to_nearest(const RootTime& t, Real best) {
  const Real next = std::nextafter(best, Real(2));
  const Rational middle = (exact(best) + exact(next)) / 2;
  return next <= 1 && compare(t, middle) > 0 ? next : best;
}

// The time beside a contact; empty where the kernel says that there is none.
template <class Real>
std::optional<Real> faulty_time(TimeFault fault, const MovingQuery<double>& q) {
  const MotionPieces motion(q);
  if (fault == TimeFault::gate_off || fault == TimeFault::gate_reversed)
    return least_ungated<Real>(q, motion, fault == TimeFault::gate_reversed);
  const std::optional<FirstContact> contact = first_contact(q, motion);
  if (!contact) return std::nullopt;
  const RootTime& t = contact->time;
  const Real best = rounded_down<Real>(t);
  switch (fault) {
    case TimeFault::right:
      return best;
    case TimeFault::late:
      return std::nextafter(best, Real(2));
    case TimeFault::early:
      return std::nextafter(best, Real(0));
    case TimeFault::nearest:
      return rounded_to_nearest(t, best);
    case TimeFault::other_root: {
      const auto leaves = nearest<Real>(Rational(2 * t.rest - approximate(t)));
      return leaves <= 1 ? std::optional(leaves) : std::nullopt;
    }
    case TimeFault::from_the_end:
      return 1 - best;
    case TimeFault::length:
      return best * static_cast<Real>(std::sqrt(portable::dot(q.d, q.d)));
    case TimeFault::none:
      return std::numeric_limits<Real>::quiet_NaN();
    case TimeFault::negative:
      return Real(-1);
    case TimeFault::infinite:
      return std::numeric_limits<Real>::infinity();
    case TimeFault::gate_off:
    case TimeFault::gate_reversed:
      break;
  }
  return std::nullopt;
}

template <class Real>
Implementation<Real> implementation_of(TimeFault fault) {
  const auto time_at = [fault](const QueryColumns<Real>& batch, std::size_t i) -> std::optional<Real> {
    const auto q =
        MovingSphere::problem<double>([&](std::size_t k) { return static_cast<double>(batch.column[k][i]); });
    const Numbers<double> numbers = q;
    const bool is_query =
        q.r >= 0 && std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
    return is_query ? faulty_time<Real>(fault, q) : std::nullopt;
  };
  Implementation<Real> made;
  made.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    for (std::size_t i = 0; i < batch.size; ++i) out[i] = time_at(batch, i) ? Verdict::contact : Verdict::separated;
  };
  made.measure = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    for (std::size_t i = 0; i < batch.size; ++i)
      out.measures[time_measure][i] = time_at(batch, i).value_or(std::numeric_limits<Real>::quiet_NaN());
  };
  return made;
}

}  // namespace
}  // namespace axiscert::moving_sphere

namespace axiscert {

Kernel time_mutant(TimeFault fault) {
  Kernel kernel =
      bare_kernel<MovingSphere, void>(fmt::format("moving-sphere/exact-time~{}", time_fault_texts[fault].name),
                                      std::string(time_fault_texts[fault].what));
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  kernel.measure_count = moving_sphere::time_measure + 1;
  kernel.binary32 = [fault](std::string_view) { return moving_sphere::implementation_of<float>(fault); };
  kernel.binary64 = [fault](std::string_view) { return moving_sphere::implementation_of<double>(fault); };
  return kernel;
}

}  // namespace axiscert

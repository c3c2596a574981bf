// Shared parts of the peers that are asked about a sphere that moves: the query with names, what a library says of the
// first contact, and a loop over a batch. The policy on what is no query and on NaN is that of ../peer.h.
//
// A peer is a type with a number type `Real`, a constant `measure_count`, and
// `int operator()(const Sweep<Real>&, FirstContact<Real>&)`, which returns an axiscert_verdict. It lives for one batch,
// and keeps nothing from query to query. Where its library says that it promises nothing of two that overlap at the
// start, it has a constant `start` too, an axiscert_start; where the library says nothing of it, an answer is expected.
// `may_decline` is that of ../peer.h.
#pragma once

#include <array>
#include <limits>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

inline constexpr std::size_t sweep_columns = 16, sweep_measures = 8;

// A triangle abc, and a sphere of radius r whose centre goes from p to p + d.
template <class Real>
struct Sweep {
  Vec3<Real> a, b, c, p, d;
  Real r;
};

// What a library says of the first contact; what it does not say is NaN. The members stand in the order of the
// predicate's measures, of which a peer gives the first `measure_count`.
template <class Real>
struct FirstContact {
  static constexpr Real unsaid = std::numeric_limits<Real>::quiet_NaN();
  Real time = unsaid;                            // as a fraction of d
  Real feature = unsaid;                         // no library here names one
  Vec3<Real> normal = {unsaid, unsaid, unsaid};  // from the triangle to the centre, of length 1
  Vec3<Real> point = {unsaid, unsaid, unsaid};   // of the triangle

  std::array<Real, sweep_measures> in_order() const {
    return {time, feature, normal.x, normal.y, normal.z, point.x, point.y, point.z};
  }
};

// Where the centre ends, rounded: most libraries take this and not the displacement.
template <class Real>
Vec3<Real> end_of(const Sweep<Real>& q) {
  return q.p + q.d;
}
template <class Real>
bool is_finite(const Vec3<Real>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The verdict of a library that says whether it hits and when. A hit without a time is no answer.
template <class Real>
int verdict_of_hit(bool is_hit, Real time) {
  return is_hit && std::isnan(time) ? AXISCERT_INVALID : verdict_of(is_hit);
}

// Answers a batch of queries in `Input`, whose numbers are exact in the peer's own number type. Measures are rounded to
// `Input`.
template <class Peer, std::floating_point Input>
void run_sweeps(const axiscert_batch* batch, const axiscert_answers* answers) {
  using Real = typename Peer::Real;
  Peer peer;
  for (std::size_t i = 0; i < batch->count; ++i) {
    std::array<Real, sweep_columns> v;
    bool is_query = true;
    for (std::size_t k = 0; k < sweep_columns; ++k) {
      v[k] = static_cast<const Input*>(batch->column[k])[i];
      is_query = is_query && std::isfinite(v[k]);
    }
    const auto vector = [&](std::size_t k) { return Vec3<Real>{v[k], v[k + 1], v[k + 2]}; };
    const Sweep<Real> q = {vector(0), vector(3), vector(6), vector(9), vector(12), v[15]};
    FirstContact<Real> first;
    const int verdict = is_query && q.r >= 0 ? peer(q, first) : int{AXISCERT_INVALID};
    if (verdict != AXISCERT_CONTACT) first = {};
    answers->verdict[i] = static_cast<std::uint8_t>(verdict);
    const auto measures = first.in_order();
    for (std::size_t k = 0; k < answers->measure_count; ++k) {
      static_cast<Input*>(answers->measure[k])[i] = static_cast<Input>(measures[k]);
    }
  }
}

template <class Peer>
constexpr std::uint32_t start_promise() {
  if constexpr (requires { Peer::start; }) return Peer::start;
  else return AXISCERT_START_IS_REPORTED;
}

template <class Peer>
const axiscert_kernel* sweep_kernel(std::uint32_t index, const Description& says) {
  return kernel_by_index<typename Peer::Real>(index, [&]<class Input>(Input) {
    axiscert_kernel made = verdict_kernel<Input>(says, sweep_columns, run_sweeps<Peer, Input>);
    made.predicate = "moving-sphere";
    made.measure_count = Peer::measure_count;
    made.start = start_promise<Peer>();
    made.still = AXISCERT_STILL_IS_REPORTED;
    made.sides = AXISCERT_BOTH_SIDES;
    made.may_decline = may_decline<Peer>();
    return made;
  });
}

}  // namespace axiscert::peer

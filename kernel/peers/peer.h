// Shared parts of the plug-ins around production libraries: a loop over a batch for a function of one query, and the
// check for invalid queries, which no library is given.
//
// One policy on NaN applies to all: an invalid query (a coordinate that is not finite, or a negative radius) is
// `invalid`, decided before the library is called, since several libraries loop or abort on NaN; a distance or depth
// that comes back as NaN is `invalid` too. If a NaN occurs inside a library that returns only yes or no, its return
// value is its answer.
//
// A peer is a type with a number type `Real` and `int operator()(const Query<Real>&)`, which returns an
// axiscert_verdict. It lives for one batch, and keeps nothing from query to query. Where that can be
// AXISCERT_UNDECIDED, it has a constant `may_decline` too, which is true. One that says more than its verdict has a
// constant `measure_count` and takes a Contact<Real>& too.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include "kernel/include/axiscert/plugin.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::peer {

struct Description {
  const char* name;  // the name of the file without .so
  const char* summary;
  axiscert_touching touching;
  const char* source;
};

constexpr int verdict_of(bool contact) { return contact ? AXISCERT_CONTACT : AXISCERT_SEPARATED; }

// The verdict of a library that gives a distance: contact where it is at most `reach`.
template <std::floating_point Real>
int verdict_within(Real distance, Real reach) {
  return std::isnan(distance) ? AXISCERT_INVALID : verdict_of(distance <= reach);
}

// What a library says of a sphere and a triangle, turned to one convention; what it does not say is NaN. The members
// stand in the order of the predicate's measures, of which a peer gives the first `measure_count`. No library names the
// part that is nearest.
template <class Real>
struct Contact {
  static constexpr Real unsaid = std::numeric_limits<Real>::quiet_NaN();
  Real separation = unsaid;                      // minus the depth
  Vec3<Real> normal = {unsaid, unsaid, unsaid};  // in which the sphere is pushed
  Vec3<Real> point = {unsaid, unsaid, unsaid};   // of the triangle

  // Whether this contact is deeper than what there is, or the first.
  bool is_new_deepest(Real at) const { return !(separation <= at); }
  std::array<Real, 8> in_order() const {
    return {separation, unsaid, normal.x, normal.y, normal.z, point.x, point.y, point.z};
  }
};
inline constexpr std::size_t separation_alone = 1, up_to_normal = 5, whole_answer = 8;

template <class Peer>
constexpr std::size_t measures_of() {
  if constexpr (requires { Peer::measure_count; }) return Peer::measure_count;
  else return 0;
}

// Writes what is said beside a verdict to place i of the batch.
template <std::floating_point Input, std::size_t size, class Real>
void put_measures(const axiscert_answers* answers, std::size_t i, const std::array<Real, size>& measures) {
  for (std::size_t k = 0; k < answers->measure_count; ++k)
    static_cast<Input*>(answers->measure[k])[i] = static_cast<Input>(measures[k]);
}

// Answers a batch of queries in `Input`, whose numbers are exact in the peer's own number type.
template <class Peer, std::floating_point Input>
void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  Peer peer;
  for (std::size_t i = 0; i < batch->count; ++i) {
    std::array<Input, coordinate_count> v;
    for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = static_cast<const Input*>(batch->column[k])[i];
    const Query<Input> q = from_coordinates(v);
    int verdict = AXISCERT_INVALID;
    Contact<typename Peer::Real> contact;
    if (is_valid(q)) {
      const auto asked = [&](const auto& query) {
        if constexpr (measures_of<Peer>() == 0) return peer(query);
        else return peer(query, contact);
      };
      if constexpr (std::same_as<typename Peer::Real, Input>) verdict = asked(q);
      else verdict = asked(widened(q));
    }
    answers->verdict[i] = static_cast<std::uint8_t>(verdict);
    put_measures<Input>(answers, i, contact.in_order());
  }
}

// AXISCERT_UNDECIDED is an answer of the peer's.
template <class Peer>
constexpr std::uint32_t may_decline() {
  if constexpr (requires { Peer::may_decline; }) return Peer::may_decline ? 1 : 0;
  else return 0;
}

// A kernel that shows a verdict alone, and claims nothing else.
template <std::floating_point Input>
constexpr axiscert_kernel verdict_kernel(const Description& says, std::size_t columns,
                                         decltype(axiscert_kernel::run) run) {
  return {.abi = AXISCERT_PLUGIN_ABI,
          .precision = 8 * sizeof(Input),
          .size = sizeof(axiscert_kernel),
          .name = says.name,
          .column_count = columns,
          .run = run,
          .predicate = nullptr,
          .entry = nullptr,
          .summary = says.summary,
          .source = says.source,
          .exposes = AXISCERT_VERDICT_ONLY,
          .touching = says.touching,
          .measure_count = 0,
          .conforms_to = nullptr,
          .formulae = nullptr,
          .limits = nullptr,
          .start = 0,
          .still = 0,
          .sides = 0,
          .may_decline = 0};
}

// The kernels for axiscert_plugin: binary32, and binary64 too if the library computes in double. make(Input()) makes
// each, once.
template <std::floating_point Real, class Make>
const axiscert_kernel* kernel_by_index(std::uint32_t index, const Make& make) {
  static const axiscert_kernel binary32 = make(float());
  if (index == 0) return &binary32;
  if constexpr (std::same_as<Real, double>) {
    static const axiscert_kernel binary64 = make(double());
    if (index == 1) return &binary64;
  }
  return nullptr;
}

template <class Peer>
const axiscert_kernel* kernel(std::uint32_t index, const Description& says) {
  return kernel_by_index<typename Peer::Real>(index, [&]<class Input>(Input) {
    axiscert_kernel made = verdict_kernel<Input>(says, coordinate_count, run<Peer, Input>);
    made.may_decline = may_decline<Peer>();
    made.measure_count = measures_of<Peer>();
    return made;
  });
}

}  // namespace axiscert::peer

// Shared parts of the peers that are asked about two boxes: the query with names, and a loop over a batch. The policy
// on numbers that are not a query and on NaN is that of ../peer.h.
//
// A library takes a rotation, and the columns of a query need not be one. Columns that are within 2^-10 of orthonormal
// are given as they stand, the third with its sign changed where they are left-handed, which is the same box; of others
// the peer is `undecided`, which every one of these declares.
//
// A peer is a type with a number type `Real` and `int operator()(const Boxes<Real>&)`, which returns an
// axiscert_verdict. It lives for one batch, and keeps nothing from query to query. One that says more than its verdict
// has a constant `measure_count` and takes a BoxContact<Real>& too.
#pragma once

#include "kernel/peers/peer.h"

namespace axiscert::peer {

inline constexpr std::size_t box_columns = 15, boxes_columns = 2 * box_columns;

template <class Real>
struct Box {
  Vec3<Real> centre, half;
  std::array<Vec3<Real>, 3> axis;
};
template <class Real>
struct Boxes {
  Box<Real> a, b;
};

template <class Real>
Box<Real> box_of(const Real* v) {
  const auto vector = [&](std::size_t k) { return Vec3<Real>{v[k], v[k + 1], v[k + 2]}; };
  return {vector(0), vector(3), {vector(6), vector(9), vector(12)}};
}

template <class Real>
bool is_nearly_orthonormal(const Box<Real>& box) {
  constexpr Real most = Real(0x1p-10);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const Real product = portable::dot(box.axis[i], box.axis[k]);
      if (!(std::abs(product - Real(i == k ? 1 : 0)) <= most)) return false;
    }
  }
  return true;
}

template <class Real>
void make_right_handed(Box<Real>& box) {
  const Real volume = portable::dot(portable::cross(box.axis[0], box.axis[1]), box.axis[2]);
  if (volume < 0) box.axis[2] = Vec3<Real>{-box.axis[2].x, -box.axis[2].y, -box.axis[2].z};
}

// Row i of the rotation whose columns are the axes, number k.
template <class Real>
Real row(const Box<Real>& box, std::size_t i, std::size_t k) {
  const Vec3<Real>& column = box.axis[k];
  return i == 0 ? column.x : i == 1 ? column.y : column.z;
}

// What a library says of a contact, turned to one convention; what it does not say is NaN. Of several contacts it is
// the deepest, the first of those. The members stand in the order of the predicate's measures, of which a peer gives
// the first `measure_count`.
template <class Real>
struct BoxContact {
  static constexpr Real unsaid = std::numeric_limits<Real>::quiet_NaN();
  Real separation = unsaid;                       // minus the depth
  Vec3<Real> normal = {unsaid, unsaid, unsaid};   // in which B is pushed
  Vec3<Real> point_a = {unsaid, unsaid, unsaid};  // of A
  Vec3<Real> point_b = {unsaid, unsaid, unsaid};

  // Whether this contact is deeper than what there is, or the first.
  bool is_new_deepest(Real at) const { return !(separation <= at); }
  std::array<Real, 10> in_order() const {
    return {separation, normal.x, normal.y, normal.z, point_a.x, point_a.y, point_a.z, point_b.x, point_b.y, point_b.z};
  }
};
// Where a library says a separation and a normal, and one point that it does not give to either body.
inline constexpr std::size_t contact_without_points = 4, whole_contact = 10;

// Answers a batch of queries in `Input`, whose numbers are exact in the peer's own number type.
template <class Peer, std::floating_point Input>
void run_boxes(const axiscert_batch* batch, const axiscert_answers* answers) {
  using Real = typename Peer::Real;
  Peer peer;
  for (std::size_t i = 0; i < batch->count; ++i) {
    std::array<Real, boxes_columns> v;
    bool is_query = true;
    for (std::size_t k = 0; k < boxes_columns; ++k) {
      v[k] = static_cast<const Input*>(batch->column[k])[i];
      is_query = is_query && std::isfinite(v[k]);
    }
    Boxes<Real> q = {box_of(v.data()), box_of(v.data() + box_columns)};
    for (const Box<Real>* box : {&q.a, &q.b}) {
      is_query = is_query && box->half.x >= 0 && box->half.y >= 0 && box->half.z >= 0;
    }
    int verdict = AXISCERT_INVALID;
    BoxContact<Real> contact;
    if (is_query) {
      verdict = AXISCERT_UNDECIDED;
      if (is_nearly_orthonormal(q.a) && is_nearly_orthonormal(q.b)) {
        make_right_handed(q.a);
        make_right_handed(q.b);
        if constexpr (measures_of<Peer>() == 0) verdict = peer(q);
        else verdict = peer(q, contact);
      }
    }
    answers->verdict[i] = static_cast<std::uint8_t>(verdict);
    if (verdict != AXISCERT_CONTACT) contact = {};
    put_measures<Input>(answers, i, contact.in_order());
  }
}

template <class Peer>
const axiscert_kernel* boxes_kernel(std::uint32_t index, const Description& says) {
  return kernel_by_index<typename Peer::Real>(index, [&]<class Input>(Input) {
    axiscert_kernel made = verdict_kernel<Input>(says, boxes_columns, run_boxes<Peer, Input>);
    made.predicate = "box-box";
    made.entry = "matrix";
    made.measure_count = measures_of<Peer>();
    made.may_decline = 1;
    return made;
  });
}

}  // namespace axiscert::peer

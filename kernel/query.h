// One query, and a batch of them as columns.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/base/geometry.h"
#include "kernel/names.h"

namespace axiscert {

using portable::Vec3;

// A sphere (centre p, radius r) and a triangle abc. Units are the caller's; r >= 0, and -0 is valid.
template <class Real>
struct Query {
  Vec3<Real> a, b, c, p;
  Real r;
};

inline constexpr std::size_t coordinate_count = 13;

// The thirteen numbers in the order of every column, file and digest: ax ay az bx by bz cx cy cz px py pz r.
template <class Real>
constexpr std::array<Real, coordinate_count> coordinates(const Query<Real>& q) {
  return {q.a.x, q.a.y, q.a.z, q.b.x, q.b.y, q.b.z, q.c.x, q.c.y, q.c.z, q.p.x, q.p.y, q.p.z, q.r};
}
template <class Real>
constexpr Query<Real> from_coordinates(const std::array<Real, coordinate_count>& v) {
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, {v[9], v[10], v[11]}, v[12]};
}
inline constexpr std::array<const char*, coordinate_count> coordinate_names = {"ax", "ay", "az", "bx", "by", "bz", "cx",
                                                                               "cy", "cz", "px", "py", "pz", "r"};

// The same query in binary64; the conversion is exact.
inline Query<double> widened(const Query<float>& q) {
  const auto vec = [](const Vec3<float>& v) { return Vec3<double>{v.x, v.y, v.z}; };
  return {vec(q.a), vec(q.b), vec(q.c), vec(q.p), q.r};
}
inline const Query<double>& widened(const Query<double>& q) { return q; }

// Finite coordinates and a radius that is finite and not negative. Anything else has the truth `invalid`.
template <class Real>
bool is_valid(const Query<Real>& q) {
  for (const Real v : coordinates(q)) {
    if (!std::isfinite(v)) return false;
  }
  return q.r >= 0;
}

// A batch as structure of arrays: thirteen pointers to `size` numbers each. It owns nothing and needs no alignment.
template <class Real>
struct QueryColumns {
  std::array<const Real*, coordinate_count> column;
  std::size_t size;
};

// The same as QueryColumns, to be written to: generators fill these.
template <class Real>
struct MutableColumns {
  std::array<Real*, coordinate_count> column;
  std::size_t size;

  // The columns of `count` queries from query `begin` on.
  MutableColumns part(std::size_t begin, std::size_t count) const {
    MutableColumns rest{{}, count};
    for (std::size_t k = 0; k < coordinate_count; ++k) rest.column[k] = column[k] + begin;
    return rest;
  }
  Query<Real> operator[](std::size_t i) const {
    std::array<Real, coordinate_count> v;
    for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = column[k][i];
    return from_coordinates(v);
  }
  void set(std::size_t i, const Query<Real>& q) const {
    const auto v = coordinates(q);
    for (std::size_t k = 0; k < coordinate_count; ++k) column[k][i] = v[k];
  }
};

// The query that fill(columns) writes into columns of length one.
template <class Real, class Fill>
Query<Real> filled_query(Fill&& fill) {
  std::array<Real, coordinate_count> v;
  MutableColumns<Real> one{{}, 1};
  for (std::size_t k = 0; k < coordinate_count; ++k) one.column[k] = &v[k];
  fill(one);
  return from_coordinates(v);
}

// Owns the columns of a batch of fixed capacity.
template <class Real>
class QueryBatch {
 public:
  explicit QueryBatch(std::size_t capacity) : capacity_(capacity), storage_(stride() * coordinate_count) {}
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  void clear() { size_ = 0; }
  // Makes the size `size`, at most the capacity; the queries have arbitrary values until written through
  // mutable_columns().
  void resize(std::size_t size) { size_ = size; }
  void push_back(const Query<Real>& q) {
    const auto v = coordinates(q);
    for (std::size_t k = 0; k < coordinate_count; ++k) storage_[k * stride() + size_] = v[k];
    ++size_;
  }
  Query<Real> operator[](std::size_t i) const {
    std::array<Real, coordinate_count> v;
    for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = storage_[k * stride() + i];
    return from_coordinates(v);
  }
  QueryColumns<Real> columns() const {
    QueryColumns<Real> view{{}, size_};
    for (std::size_t k = 0; k < coordinate_count; ++k) view.column[k] = storage_.data() + k * stride();
    return view;
  }
  MutableColumns<Real> mutable_columns() {
    MutableColumns<Real> view{{}, size_};
    for (std::size_t k = 0; k < coordinate_count; ++k) view.column[k] = storage_.data() + k * stride();
    return view;
  }

 private:
  // Distance between columns, in numbers: an odd number of cache lines of 64 bytes. At a multiple of 4096 bytes all
  // columns would compete for the same eight lines of a first-level cache.
  std::size_t stride() const {
    constexpr std::size_t line = 64 / sizeof(Real);
    return ((capacity_ / line + 1) | 1) * line;
  }

  std::size_t capacity_, size_ = 0;
  std::vector<Real> storage_;
};

}  // namespace axiscert

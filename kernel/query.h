// The numbers of a query, and a batch of queries as columns: for every predicate, by the number of its columns alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "kernel/names.h"

namespace axiscert {

// The most numbers that a query of any predicate has.
inline constexpr std::size_t most_columns = 64;

// The numbers of one query, in the order of the columns of its predicate's entry. A predicate's own type of query, with
// members that have names, converts to and from these.
template <class Real>
class Numbers {
 public:
  Numbers() = default;
  // Arbitrary values until written; `size` is at most most_columns.
  explicit Numbers(std::size_t size) : size_(size) {}
  Numbers(std::initializer_list<Real> values) : size_(values.size()) { std::copy_n(values.begin(), size_, data()); }
  // A copy takes the numbers alone, not the room for more.
  Numbers(const Numbers& other) : size_(other.size_) { std::copy_n(other.data(), size_, data()); }
  Numbers& operator=(const Numbers& other) {
    size_ = other.size_;
    std::copy_n(other.data(), size_, data());
    return *this;
  }

  std::size_t size() const { return size_; }
  Real& operator[](std::size_t k) { return values_[k]; }
  const Real& operator[](std::size_t k) const { return values_[k]; }
  Real* data() { return values_.data(); }
  const Real* data() const { return values_.data(); }
  Real* begin() { return data(); }
  Real* end() { return data() + size_; }
  const Real* begin() const { return data(); }
  const Real* end() const { return data() + size_; }

  // To a predicate's own type of query. Precondition: these are as many numbers as it has.
  template <class Query>
    requires requires(const Numbers& numbers) { Query::from(numbers); }
  operator Query() const {
    return Query::from(*this);
  }

 private:
  std::array<Real, most_columns> values_;
  std::size_t size_ = 0;
};

// A batch as structure of arrays: `count` pointers to `size` numbers each. It owns nothing and needs no alignment.
template <class Real>
struct QueryColumns {
  std::array<const Real*, most_columns> column;  // those from `count` on have no meaning
  std::size_t size;                              // queries
  std::size_t count;                             // columns
};

// The same as QueryColumns, to be written to: generators fill these.
template <class Real>
struct MutableColumns {
  std::array<Real*, most_columns> column;
  std::size_t size, count;

  // The columns of `queries` queries from query `begin` on.
  MutableColumns part(std::size_t begin, std::size_t queries) const {
    MutableColumns rest;
    rest.size = queries;
    rest.count = count;
    for (std::size_t k = 0; k < count; ++k) rest.column[k] = column[k] + begin;
    return rest;
  }
  Numbers<Real> operator[](std::size_t i) const {
    Numbers<Real> v(count);
    for (std::size_t k = 0; k < count; ++k) v[k] = column[k][i];
    return v;
  }
  // Precondition: `v` has `count` numbers.
  void set(std::size_t i, const Numbers<Real>& v) const {
    for (std::size_t k = 0; k < count; ++k) column[k][i] = v[k];
  }
};

// The query of `count` numbers that fill(columns) writes into columns of length one.
template <class Real, class Fill>
Numbers<Real> filled_numbers(std::size_t count, Fill&& fill) {
  Numbers<Real> v(count);
  MutableColumns<Real> one;
  one.size = 1;
  one.count = count;
  for (std::size_t k = 0; k < count; ++k) one.column[k] = &v[k];
  fill(one);
  return v;
}

// A float widens exactly.
template <class Real>
Numbers<double> in_doubles(const Numbers<Real>& query) {
  Numbers<double> wide(query.size());
  std::copy(query.begin(), query.end(), wide.begin());
  return wide;
}

// Owns the columns of a batch of fixed capacity.
template <class Real>
class QueryBatch {
 public:
  // `columns` is at most most_columns.
  QueryBatch(std::size_t capacity, std::size_t columns)
      : capacity_(capacity), columns_(columns), storage_(stride() * columns) {}
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  std::size_t column_count() const { return columns_; }
  void clear() { size_ = 0; }
  // Makes the size `size`, at most the capacity; the queries have arbitrary values until written through
  // mutable_columns().
  void resize(std::size_t size) { size_ = size; }
  // Precondition: `v` has a number for each column.
  void push_back(const Numbers<Real>& v) {
    for (std::size_t k = 0; k < columns_; ++k) storage_[k * stride() + size_] = v[k];
    ++size_;
  }
  Numbers<Real> operator[](std::size_t i) const {
    Numbers<Real> v(columns_);
    for (std::size_t k = 0; k < columns_; ++k) v[k] = storage_[k * stride() + i];
    return v;
  }
  QueryColumns<Real> columns() const { return view<QueryColumns<Real>>(storage_.data()); }
  MutableColumns<Real> mutable_columns() { return view<MutableColumns<Real>>(storage_.data()); }

 private:
  // Distance between columns, in numbers: an odd number of cache lines of 64 bytes. At a multiple of 4096 bytes all
  // columns would compete for the same eight lines of a first-level cache.
  std::size_t stride() const {
    constexpr std::size_t line = 64 / sizeof(Real);
    return ((capacity_ / line + 1) | 1) * line;
  }
  template <class View, class Pointer>
  View view(Pointer storage) const {
    View view;
    view.size = size_;
    view.count = columns_;
    for (std::size_t k = 0; k < columns_; ++k) view.column[k] = storage + k * stride();
    return view;
  }

  std::size_t capacity_, columns_, size_ = 0;
  std::vector<Real> storage_;
};

}  // namespace axiscert

// What the bindings share: names looked up, arrays as columns of queries, and exact numbers as Python has them.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/numbers/rational.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert::python {
namespace py = pybind11;

// Whether the interpreter is about to end, all work having ended (end_all_work).
inline std::atomic<bool> is_ended = false;

// The interpreter's lock given back, for a scope. A daemon thread that comes for it when the interpreter ends waits for
// the end of the process: Python 3.11 would unwind it through C++, which ends the process at once.
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) {}
  ~Unlocked() {
    while (is_ended && gettid() != getpid()) pause();
    PyEval_RestoreThread(state_);
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* state_;
};

// The entry of a predicate, by the names of both; "" is the first. Throws Error that lists them.
struct EntryOf {
  const Predicate* predicate;
  std::size_t entry;
  const PredicateEntry& columns() const { return predicate->entries[entry]; }
};
EntryOf entry_named(const std::string& predicate, const std::string& entry);

// Queries in an array of shape (columns, queries), float32 or float64, each row contiguous, which is not copied and has
// to outlive this.
class GivenColumns {
 public:
  // Throws Error, which says the shape or type that it has and the one that it should have.
  GivenColumns(const EntryOf& of, const py::array& numbers);
  Precision precision() const { return precision_; }
  std::size_t size() const { return size_; }

  // Calls work.operator()<Real>(columns).
  template <class Work>
  decltype(auto) visit(Work&& work) const {
    if (precision_ == Precision::binary32) return work.template operator()<float>(columns<float>());
    return work.template operator()<double>(columns<double>());
  }
  template <class Real>
  QueryColumns<Real> columns() const {
    QueryColumns<Real> view{};
    view.size = size_;
    view.count = count_;
    for (std::size_t k = 0; k < count_; ++k) view.column[k] = reinterpret_cast<const Real*>(data_ + k * stride_);
    return view;
  }

 private:
  const char* data_;
  std::size_t stride_, size_, count_;
  Precision precision_;
};

template <class Real>
Numbers<Real> query_at(const QueryColumns<Real>& columns, std::size_t i) {
  Numbers<Real> numbers(columns.count);
  for (std::size_t k = 0; k < columns.count; ++k) numbers[k] = columns.column[k][i];
  return numbers;
}

// An integer of any size; and a fraction as the pair (numerator, denominator).
py::object integer(const mpz_class& value);
py::tuple fraction(const Rational& value);

// Those of the other files.
void bind_errors(py::module_& m);
void bind_descriptions(py::module_& m);
void bind_queries(py::module_& m);
void bind_truth(py::module_& m);
void bind_callables(py::module_& m);
void bind_judge(py::module_& m);
void bind_instruments(py::module_& m);
void bind_formulae(py::module_& m);
void bind_certified(py::module_& m);

}  // namespace axiscert::python

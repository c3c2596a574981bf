// Functions of Python as kernels: asked in batches of arrays, in this process.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/plugin/caller.h"
#include "python/binding/common.h"
#include "plans/claimed_kernel.h"

namespace axiscert::python {

// How a function takes queries.
enum class Layout {
  groups,  // an argument for each group of columns: an array (n, size), or (n) where the group has one column
  columns  // one argument, an array (columns, n)
};

// Ends a computation whose function raised, or answered what is no answer; what it raised is kept in the callable.
struct CallableFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The same, of an answer that is none: no query alone is to blame.
struct AnswerRefused : CallableFailed {
  using CallableFailed::CallableFailed;
};

// A function that a Kernel of Python holds, which the library does not keep alive, and what came of asking it.
class Callable {
 public:
  Callable(Layout layout, bool records_errors, const ShownAnswers& shown, std::string id);
  Callable(const Callable&) = delete;

  // Answers of a batch, as the function gave them: the arrays that it is given are its own, to keep or, where they are
  // converted, to write. Throws CallableFailed.
  template <class Real>
  plugin::Outputs<Real> ask(const QueryColumns<Real>& batch);
  bool records_errors() const { return records_errors_; }
  const ShownAnswers& shown() const { return shown_; }

  // Python's own.
  double seconds() const { return seconds_; }  // in the function, of all threads together
  std::uint64_t calls() const { return calls_; }
  // The Kernel, by a weak reference: its _function, its _tensors, which converts arrays, and _raised, where what was
  // raised is put as (what, the numbers of the batch, a text).
  void hold(py::object kernel) { kernel_ = std::move(kernel); }
  // The Kernel is gone; a later question fails.
  void release() { kernel_ = py::none(); }

  std::atomic<bool>& is_abandoned() { return is_abandoned_; }  // by a second interrupt: the next question fails

 private:
  template <class Real>
  py::object result_of(const py::object& kernel, const QueryColumns<Real>& batch, py::array_t<Real>& numbers);
  template <class Real>
  plugin::Outputs<Real> read(const py::object& result, std::size_t size) const;
  void read_verdicts(const py::handle& given, std::size_t size, std::vector<std::uint8_t>& verdicts,
                     std::vector<std::uint64_t>& bits) const;
  py::array array_of(const py::handle& given, const std::string& what, std::size_t size, std::size_t width) const;
  [[noreturn]] void refuse(const std::string& what) const;

  py::object kernel_ = py::none();  // under the interpreter's lock
  const Layout layout_;
  const bool records_errors_;
  const ShownAnswers shown_;
  const std::string id_;
  std::atomic<double> seconds_ = 0;
  std::atomic<std::uint64_t> calls_ = 0;
  std::atomic<bool> is_abandoned_ = false;
};

// The kernel of a function, under its id.
Kernel kernel_of(const std::shared_ptr<Callable>& callable, const KernelClaims& claims);

}  // namespace axiscert::python

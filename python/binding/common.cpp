#include "python/binding/common.h"

#include <fmt/format.h>

#include "kernel/base/error.h"

namespace axiscert::python {

EntryOf entry_named(const std::string& predicate, const std::string& entry) {
  const Predicate& named = predicate_named(predicate);
  return {&named, find_entry(named, entry)};
}

GivenColumns::GivenColumns(const EntryOf& of, const py::array& numbers) {
  const auto& columns = of.columns().columns;
  const bool is_single = py::isinstance<py::array_t<float>>(numbers);
  if (!is_single && !py::isinstance<py::array_t<double>>(numbers)) {
    throw Error(fmt::format("the numbers of queries are {}; give float32, which is binary32, or float64",
                            std::string(py::str(numbers.dtype()))));
  }
  if (numbers.ndim() != 2 || static_cast<std::size_t>(numbers.shape(0)) != columns.size()) {
    throw Error(
        fmt::format("the numbers of queries have shape {}; those of {}, entry {}, have shape ({}, n): a row "
                    "for each column",
                    std::string(py::str(numbers.attr("shape"))), of.predicate->id, of.columns().name, columns.size()));
  }
  precision_ = is_single ? Precision::binary32 : Precision::binary64;
  const py::ssize_t item = numbers.itemsize();
  if ((numbers.shape(1) > 1 && numbers.strides(1) != item) || numbers.strides(0) % item != 0)
    throw Error("the rows of the numbers are not contiguous; numpy.ascontiguousarray makes them so");
  data_ = static_cast<const char*>(numbers.data());
  stride_ = static_cast<std::size_t>(numbers.strides(0));
  size_ = static_cast<std::size_t>(numbers.shape(1));
  count_ = columns.size();
}

py::object integer(const mpz_class& value) {
  PyObject* const made = PyLong_FromString(value.get_str(16).c_str(), nullptr, 16);
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

py::tuple fraction(const Rational& value) { return py::make_tuple(integer(value.get_num()), integer(value.get_den())); }

}  // namespace axiscert::python

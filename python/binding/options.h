// Options by their names, from a dictionary: a value of another type, and a name that nothing takes, are refused.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/base/error.h"
#include "python/binding/common.h"

namespace axiscert::python {

class Options {
 public:
  explicit Options(const py::dict& given) : left_(given.attr("copy")()) {}

  // Leaves the value as it is where the name is not given, or is None.
  template <class Value>
  void take(const char* name, Value& value) {
    if (!left_.contains(name)) return;
    const py::object given = left_.attr("pop")(name);
    if (given.is_none()) return;
    try {
      value = given.cast<Value>();
    } catch (const py::cast_error&) {
      throw Error(fmt::format("{}={}: not of the type that this option takes", name, std::string(py::repr(given))));
    }
  }
  void require_all_taken() const {
    for (const auto& [name, ignored] : left_)
      throw Error(fmt::format("there is no option '{}'", std::string(py::str(name))));
  }

 private:
  py::dict left_;
};

// The enumerator of this name. Throws Error that lists them.
template <class Enum>
Enum enumerator_named(const char* option, const std::string& text) {
  std::vector<std::string_view> known;
  for (const Enum each : enumerators<Enum>) {
    if (name(each) == text) return each;
    known.push_back(name(each));
  }
  throw Error(fmt::format("{}='{}': there are: {}", option, text, fmt::join(known, ", ")));
}

}  // namespace axiscert::python

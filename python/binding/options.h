// Options by their names, from a dictionary: a value of another type, and a name that nothing takes, are refused.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>

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
      constexpr const char* right = std::is_same_v<Value, bool>   ? "give True or False"
                                    : std::is_arithmetic_v<Value> ? "give a number"
                                    : std::is_convertible_v<Value, std::string>
                                        ? "give a text"
                                        : "not of the type that this option takes";
      throw Error(fmt::format("{}={}: {}", name, std::string(py::repr(given)), right));
    }
  }
  void require_all_taken() const {
    for (const auto& [name, ignored] : left_)
      throw Error(fmt::format("there is no option '{}'", std::string(py::str(name))));
  }

 private:
  py::dict left_;
};

}  // namespace axiscert::python

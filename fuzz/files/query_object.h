// A line of a query file where JSON has the query as an object.
#pragma once

#include <string>
#include <utility>

#include "fuzz/fields/json_form.h"

namespace axiscert {

struct QueryLine : std::string {
  using std::string::string;
  QueryLine(std::string text) : std::string(std::move(text)) {}
};
template <>
struct JsonForm<QueryLine> {
  static Json write(const QueryLine& line) { return Json::parse(static_cast<const std::string&>(line)); }
  static void read(const JsonPlace& place, QueryLine& into) {
    place.require_type(place.value().is_object(), "object");
    into = place.value().dump();
  }
  static Json schema() { return {{"description", "A line of a query file."}, {"type", "object"}}; }
};

}  // namespace axiscert

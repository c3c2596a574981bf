#include "fuzz/fields/json_form.h"

namespace axiscert {

// The length is counted in bytes, which is at least as strict as in characters. A text over its limit never reaches the
// regular expression, whose depth of recursion grows with the text.
void check_text(const JsonPlace& place, std::size_t longest, bool may_be_empty, const std::regex* pattern,
                std::string_view pattern_text) {
  place.require_type(place.value().is_string(), "string");
  const auto& text = place.value().get_ref<const std::string&>();
  if (text.empty() && !may_be_empty) place.refuse("is empty");
  if (text.size() > longest) place.refuse("is too long");
  if (pattern && !std::regex_search(text, *pattern)) place.refuse(fmt::format("does not match {}", pattern_text));
}

Json text_schema(std::size_t longest, bool may_be_empty, std::string_view pattern) {
  Json schema = {{"type", "string"}, {"minLength", may_be_empty ? 0 : 1}, {"maxLength", longest}};
  if (!pattern.empty()) schema["pattern"] = pattern;
  return schema;
}

namespace {

constexpr std::string_view beyond_binary64 = "^[1-9]([.][0-9]{1,5})?e[+][0-9]{3,}$";

}  // namespace

void JsonForm<ErrorNumber>::read(const JsonPlace& place, ErrorNumber& into) {
  static const std::regex pattern{std::string(beyond_binary64)};
  into = {};
  if (place.value().is_number()) return read_json(place, into.value);
  if (!place.value().is_string()) place.refuse("is not one of [\"number\",\"string\"]");
  check_text(place, 20, false, &pattern, beyond_binary64);
  into.text = place.value();
}
Json JsonForm<ErrorNumber>::schema() {
  return {{"type", {"number", "string"}}, {"minimum", 0}, {"maxLength", 20}, {"pattern", beyond_binary64}};
}

void JsonForm<Decimal6>::read(const JsonPlace& place, Decimal6& into) {
  ErrorNumber error;
  read_json(place, error);
  into = round_up(parse_decimal(error.text.empty() ? fmt::format("{}", error.value) : error.text));
  if (write(into) != place.value()) place.refuse("has more than 6 significant digits");
}

}  // namespace axiscert

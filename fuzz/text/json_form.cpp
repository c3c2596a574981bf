#include "fuzz/text/json_form.h"

namespace axiscert {

JsonPlace JsonPlace::at(std::string_view member) const {
  const auto found = value_.find(std::string(member));
  if (found == value_.end()) refuse(fmt::format("without {}", Json(member).dump()));
  return {found.value(), path_ + "/" + shown(member)};
}

JsonPlace JsonPlace::at(std::size_t i) const { return {value_[i], fmt::format("{}/{}", path_, i)}; }

void JsonPlace::refuse(const std::string& problem) const {
  const std::string what = value_.is_object() ? "an object" : value_.is_array() ? "an array" : shown(value_.dump());
  throw JsonFault(fmt::format("{}: {} {}", path_.empty() ? "/" : path_, what, problem));
}

void JsonPlace::require_type(bool is_it, std::string_view type) const {
  if (!is_it) refuse(fmt::format("is not of type {}", type));
}

void put_member(Json& object, std::string_view name, Json value) { object[std::string(name)] = std::move(value); }

void refuse_name(const JsonPlace& place, std::string_view member) {
  place.at(member).refuse("under a name that is not in the schema");
}

void refuse_other_names(const JsonPlace& place, bool (*is_known)(std::string_view)) {
  for (const auto& [member, value] : place.value().items()) {
    if (!is_known(member)) refuse_name(place, member);
  }
}

void require_said(const JsonPlace& place, std::string_view member, const Json& expected) {
  const JsonPlace at = place.at(member);
  if (at.value() != expected) at.refuse(fmt::format("is not {}, as the members beside it say", expected.dump()));
}

Json type_schema(std::string_view type) { return {{"type", type}}; }

Json nullable(Json schema) { return {{"anyOf", Json::array({type_schema("null"), std::move(schema)})}}; }

Json array_schema(Json items, std::optional<std::size_t> size) {
  Json schema = type_schema("array");
  if (size) schema.update({{"minItems", *size}, {"maxItems", *size}});
  schema["items"] = std::move(items);
  return schema;
}

Json map_schema(Json values, Json names) {
  Json schema = type_schema("object");
  if (!names.is_null()) schema["propertyNames"] = std::move(names);
  schema["additionalProperties"] = std::move(values);
  return schema;
}

Json object_schema(bool is_open, std::string_view about) {
  Json schema = {{"type", "object"}, {"additionalProperties", is_open}, {"required", Json::array()}};
  if (!about.empty()) schema["description"] = about;
  schema["properties"] = Json::object();
  return schema;
}

void describe_member(Json& schema, const Field& field, Json (*schema_of_member)()) {
  Json member = schema_of_member();
  std::string about(field.about);
  if (!field.looked_at.empty()) {
    member = nullable(std::move(member));
    about += fmt::format("{}Null where {} is 0.", about.empty() ? "" : " ", field.looked_at);
  }
  if (!about.empty()) member["description"] = about;
  if (!field.unit.empty()) member["unit"] = field.unit;
  put_member(schema["properties"], field.name, std::move(member));
  if (!field.may_be_absent) schema["required"].push_back(field.name);
}

void clear_unseen(Json& object, const Field& field) {
  if (field.looked_at.empty()) return;
  const auto member = object.find(std::string(field.name));
  if (member != object.end() && object.at(std::string(field.looked_at)) == 0) *member = nullptr;
}

bool is_unseen(const JsonPlace& place, const Field& field) {
  if (field.looked_at.empty() || !place.has(field.name)) return false;
  // Read here first: what is wrong with it is no fault of the figure.
  const JsonPlace count = place.at(field.looked_at);
  count.require_type(count.value().is_number_integer() || count.value().is_null(), "integer");
  return count.value() == 0;
}

void require_nothing(const JsonPlace& place, const Field& field, const Json& value, const Json& nothing) {
  if (value != nothing) place.at(field.name).refuse(fmt::format("is not null, though {} is 0", field.looked_at));
}

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

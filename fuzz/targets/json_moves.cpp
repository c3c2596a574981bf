#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "fuzz/targets/json_mutator.h"
#include "fuzz/text/json.h"

namespace axiscert::fuzzing {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* placeholder = "@nested@";

void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  for (Json& part : value) {
    if (value.is_structured()) collect(part, all);
  }
}

Json strange_value(Dice& dice) {
  static const std::vector<Json> values = {nullptr,
                                           true,
                                           false,
                                           0,
                                           -1,
                                           1,
                                           0.5,
                                           -0.0,
                                           1e308,
                                           5e-324,
                                           4294967296,
                                           9007199254740993,
                                           INT64_MIN,
                                           INT64_MAX,
                                           UINT64_MAX,
                                           "",
                                           "0",
                                           "nan",
                                           "-inf",
                                           "0x1p-149",
                                           "0x1.fffffffffffffp+1023",
                                           "1e999999999999999999",
                                           "a/b",
                                           "..",
                                           "\x01\x1b[31m",
                                           "\xc3\xa9",
                                           Json::array(),
                                           Json::object(),
                                           Json::array({nullptr}),
                                           Json{{"", ""}},
                                           std::string(300, 'x')};
  return values[dice.below(values.size())];
}

std::string any_key(const std::vector<Json*>& all, Dice& dice) {
  const Json& holder = *all[dice.below(all.size())];
  if (!holder.is_object() || holder.empty()) return dice.coin() ? "schema" : "";
  return std::next(holder.begin(), static_cast<std::ptrdiff_t>(dice.below(holder.size()))).key();
}

void nudge(Json& value, Dice& dice) {
  if (value.is_number_unsigned()) {
    value = value.get<std::uint64_t>() + static_cast<std::uint64_t>(dice.integer(-2, 2));
  } else if (value.is_number_integer()) {
    value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value.get<std::int64_t>()) +
                                      static_cast<std::uint64_t>(dice.integer(-2, 2)));
  } else if (value.is_number_float()) {
    value = value.get<double>() * static_cast<double>(dice.integer(-2, 3)) / 2;
  } else if (value.is_string()) {
    std::string text = value;
    static constexpr std::string_view characters = "0123456789abcdefpx.+-/:,|<& \"\\\n\x7f";
    const std::size_t at = dice.below(text.size() + 1);
    const char c = characters[dice.below(characters.size())];
    if (at == text.size() || dice.coin()) text.insert(at, 1, c);
    else if (dice.coin()) text.erase(at, 1);
    else text[at] = c;
    value = text;
  } else if (value.is_boolean()) {
    value = !value.get<bool>();
  }
}

void remove_part(Json& holder, Dice& dice) {
  if (holder.empty() || !holder.is_structured()) return;
  holder.erase(std::next(holder.begin(), static_cast<std::ptrdiff_t>(dice.below(holder.size()))));
}

void duplicate_part(Json& holder, const std::string& key, Dice& dice) {
  if (holder.empty() || !holder.is_structured()) return;
  const auto at = std::next(holder.begin(), static_cast<std::ptrdiff_t>(dice.below(holder.size())));
  const Json part = *at;
  if (holder.is_array()) holder.insert(at, part);
  else holder[key] = part;
}

void rename_member(Json& holder, const std::string& key, Dice& dice) {
  if (!holder.is_object() || holder.empty()) return;
  Json renamed = Json::object();
  const std::size_t which = dice.below(holder.size());
  std::size_t i = 0;
  for (const auto& [old_key, part] : holder.items()) renamed[i++ == which ? key : old_key] = part;
  holder = renamed;
}

}  // namespace

bool is_deep(std::string_view text) {
  constexpr std::size_t harmless = 1000;
  std::size_t depth = 0, deepest = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    else if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return deepest > harmless;
}

std::string moved_json(std::string_view text, JsonMove move, Dice& dice) {
  if (is_deep(text)) return std::string(text);
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return std::string(text);
  std::vector<Json*> all;
  collect(document, all);
  Json& chosen = *all[dice.below(all.size())];
  const std::string key = any_key(all, dice);
  std::size_t levels = 0;
  switch (move) {
    case JsonMove::replace:
      chosen = strange_value(dice);
      break;
    case JsonMove::copy: {
      const Json other = *all[dice.below(all.size())];
      chosen = other;
      break;
    }
    case JsonMove::remove:
      remove_part(chosen, dice);
      break;
    case JsonMove::duplicate:
      duplicate_part(chosen, key, dice);
      break;
    case JsonMove::rename:
      rename_member(chosen, key, dice);
      break;
    case JsonMove::nudge:
      nudge(chosen, dice);
      break;
    case JsonMove::nest:
      levels = dice.below(8) == 0 ? 400000 : 1 + dice.below(4);
      chosen = placeholder;
      break;
  }
  std::string changed = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  // The nesting is made as text: writing so deep a value would take as deep a recursion.
  if (const std::size_t at = changed.find('"' + std::string(placeholder) + '"'); levels > 0 && at != changed.npos) {
    changed.replace(at, std::string_view(placeholder).size() + 2, std::string(levels, '[') + std::string(levels, ']'));
  }
  return changed;
}

}  // namespace axiscert::fuzzing

#include "reports/instrument/data.h"

#include <algorithm>
#include <string_view>

#include "fuzz/text/json.h"

namespace axiscert {
namespace {

// The member of that name, or the one at the end of the path that it is; null where there is none.
const Json* csv_member(const Json& row, std::string_view name) {
  if (!row.is_object()) return nullptr;
  if (const auto found = row.find(std::string(name)); found != row.end()) return &*found;
  for (std::size_t dot = name.find('.'); dot != name.npos; dot = name.find('.', dot + 1)) {
    const auto found = row.find(std::string(name.substr(0, dot)));
    if (found == row.end()) continue;
    if (const Json* inner = csv_member(*found, name.substr(dot + 1))) return inner;
  }
  return nullptr;
}

std::string csv_cell(const Json* value) {
  if (value == nullptr || value->is_null()) return "";
  if (value->is_string()) return value->get<std::string>();
  if (!value->is_array()) return value->dump();
  std::string text;
  for (const Json& element : *value) text += (text.empty() ? "" : " ") + csv_cell(&element);
  return text;
}

std::string csv_quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == cell.npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

}  // namespace

void add_columns(DataColumns& columns, const Json& schema, const std::string& path) {
  if (schema.contains("anyOf")) return add_columns(columns, schema["anyOf"][1], path);
  if (schema.contains("properties")) {
    for (const auto& [name, member] : schema["properties"].items())
      add_columns(columns, member, path.empty() ? name : path + "." + name);
    return;
  }
  const Json& innermost = schema.contains("items") ? schema["items"] : schema;
  if (innermost.value("type", Json()) == "object") return;
  if (std::find(columns.begin(), columns.end(), path) == columns.end()) columns.push_back(path);
}

std::string csv_head(const DataColumns& columns) {
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + csv_quoted(column);
  return text + '\n';
}

std::string csv_line(const DataColumns& columns, const Json& row) {
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c)
    text += (c == 0 ? "" : ",") + csv_quoted(csv_cell(csv_member(row, columns[c])));
  return text + '\n';
}

}  // namespace axiscert

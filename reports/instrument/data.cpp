#include "reports/instrument/data.h"

#include "kernel/base/version.h"

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

Json headed(std::string_view schema, const Json& members) {
  Json data = {{"schema", schema}, {"axiscert", axiscert_version}, {"revision", axiscert_revision}};
  data.update(members);
  return data;
}

std::string csv_text(const DataTable& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c) text += (c == 0 ? "" : ",") + csv_quoted(table.columns[c]);
  text += '\n';
  for (const Json& row : table.rows) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      text += (c == 0 ? "" : ",") + csv_quoted(csv_cell(csv_member(row, table.columns[c])));
    }
    text += '\n';
  }
  return text;
}

std::string csv_of(const Json& data) { return csv_text(table_of(data)); }

}  // namespace axiscert

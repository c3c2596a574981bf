// The head of the JSON that instruments and lists print for other programs. docs/data.md describes it.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/fields/json_form.h"
#include "kernel/base/version.h"

namespace axiscert {

// {"schema": SCHEMA, "axiscert": the version, "revision": its commit, MEMBERS...}, where SCHEMA is
// axiscert-NAME/VERSION.
inline Json headed(std::string_view schema, const Json& members) {
  Json data = {{"schema", schema}, {"axiscert", axiscert_version}, {"revision", axiscert_revision}};
  data.update(members);
  return data;
}

// The same head of a struct: `File` says its `format`, and has this as its first base.
template <class File>
struct DataHead {
  FormatName<File> schema;
  Name axiscert = std::string(axiscert_version), revision = std::string(axiscert_revision);

  static constexpr auto fields(auto&& visit) {
    using Of = DataHead;
    return visit(field(&Of::schema, {"schema", "The format of this file."}),
                 field(&Of::axiscert, {"axiscert", "The version that wrote it."}),
                 field(&Of::revision, {"revision",
                                       "The commit that it was built from, with -dirty where the tree differed; "
                                       "unknown without a repository."}));
  }
};
template <class File>
struct CommandData : DataHead<File> {
  Name command;

  static constexpr auto fields(auto&& visit) {
    return visit(base<CommandData, DataHead<File>>(),
                 field(&CommandData::command, {"command", "The command that makes the same file again."}));
  }
};

}  // namespace axiscert

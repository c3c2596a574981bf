#include "reports/run_folder/record_version.h"

#include <fmt/format.h>

#include "fuzz/confirm/record.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

constexpr const char* first_schema = "axiscert-record/1";

}  // namespace

Json present_plan(const Json& plan) {
  if (!plan.is_object() || plan.contains("test")) return plan;
  Json present = Json::object();
  for (const auto& [member, value] : plan.items()) {
    present[member] = value;
    if (member == "axiscert") present["test"] = sphere_triangle_test().id;
  }
  present.emplace("test", sphere_triangle_test().id);
  return present;
}

Json present_record(Json record, const std::string& name) {
  if (!record.is_object() || !record.contains("schema")) return record;
  const Json schema = record["schema"];
  if (schema == record_schema) return record;
  if (schema != first_schema) {
    throw Error(
        fmt::format("{}: its schema is {}, but this axiscert reads \"{}\" and \"{}\"; use the axiscert that wrote it",
                    name, shown(schema.dump()), first_schema, record_schema));
  }
  record["schema"] = record_schema;
  if (!record.contains("plan")) return record;
  if (record["plan"].is_object() && record["plan"].contains("test")) {
    throw Error(
        fmt::format("{}: does not conform to {}: /plan/test: a member of \"{}\"; restore the file as it was "
                    "written",
                    name, first_schema, record_schema));
  }
  record["plan"] = present_plan(record["plan"]);
  return record;
}

}  // namespace axiscert

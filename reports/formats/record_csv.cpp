// record.csv: the figures of the record, a line for each kernel, precision, family and place: the verdict, an axis, a
// comparison, a kind of image, a class of input.
#include "fuzz/record/record.h"
#include "reports/formats/format.h"
#include "reports/formats/render.h"
#include "reports/instrument/csv.h"

namespace axiscert {
namespace {

// Gives each count under a name that is known, as a decade is, a column of its own.
void name_counts(Json& schema) {
  if (!schema.is_structured()) return;
  const bool has_names = schema.is_object() && schema.contains("propertyNames") &&
                         schema["propertyNames"].contains("enum") &&
                         schema["additionalProperties"].value("type", Json()) == "integer";
  if (has_names) {
    Json members = Json::object();
    for (const Json& one : schema["propertyNames"]["enum"])
      members[one.get<std::string>()] = schema["additionalProperties"];
    schema["properties"] = std::move(members);
    return;
  }
  for (Json& part : schema) name_counts(part);
}

// A column is the path of a figure in what the line is about.
DataColumns record_columns() {
  DataColumns columns = {"kernel", "precision", "family", "level", "name"};
  for (Json schema : {json_schema_of<FamilyRecord>(), json_schema_of<AxisTally>(), json_schema_of<ComparisonTally>(),
                      json_schema_of<ImageChangesRecord>(), json_schema_of<ClassRecord>()}) {
    name_counts(schema);
    add_columns(columns, schema, "");
  }
  return columns;
}

std::string render_csv(const Run& run) {
  const DataColumns columns = record_columns();
  std::string text = csv_head(columns);
  for (const KernelRecord& kernel : run.record.kernels) {
    for (const auto& [family, result] : kernel.families) {
      const auto add = [&, of = std::string_view(family)](const char* level, std::string_view place,
                                                          const auto& figures) {
        Json row = {{"kernel", json_of(kernel.id)},
                    {"precision", name(kernel.precision)},
                    {"family", of},
                    {"level", level},
                    {"name", place}};
        row.update(json_of(figures));
        text += csv_line(columns, row);
      };
      add("verdict", "verdict", result);
      if (result.axes)
        for (const auto& [axis, figures] : *result.axes) add("axis", axis, figures);
      if (result.comparisons)
        for (const auto& [comparison, figures] : *result.comparisons) add("comparison", comparison, figures);
      if (result.invariance)
        for (const auto& [kind, figures] : *result.invariance) add("image", name(kind), figures);
      if (result.classes)
        for (const auto& [which, figures] : *result.classes) add("class", name(which), figures);
    }
  }
  return text;
}

}  // namespace

extern const Format csv_format = {
    record_csv_file, "the counts of record.json as a table: a line for each verdict, axis, comparison", render_csv};

}  // namespace axiscert

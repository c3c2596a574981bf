// Formats of lines for other programs: record.csv, witnesses.jsonl, ratchet.txt.
#include "fuzz/files/nested_members.h"
#include "fuzz/record/record.h"
#include "fuzz/text/json_form.h"
#include "reports/formats/format.h"
#include "reports/gates/ratchet.h"
#include "reports/instrument/data.h"
#include "reports/run_folder/record_checks.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
// record.csv: the figures of the record, a line for each kernel, precision, family and place: the verdict, an axis, a
// comparison, a kind of image, a class of input.
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

// witnesses.jsonl: every witness as a line of a query file, with its address: half of a pair is found by it.

namespace {

std::string render_witnesses(const Run& run) {
  const Predicate& predicate = predicate_of(run.record.plan);
  std::string text;
  for (const WitnessRecord& witness : run.record.witnesses) {
    Json query = {{"id", json_of(witness.id)}, {"precision", name(witness.precision)}};
    const PredicateEntry& entry = *entry_of(predicate, witness);
    if (const std::string_view written = written_name(predicate); !written.empty()) query["predicate"] = written;
    if (&entry != &predicate.entries.front()) query["entry"] = entry.name;
    for (const ColumnGroup& group : groups_of(entry))
      member_at(query, group.name) = json_of(witness.numbers.at(group.name));
    query["address"] = json_of(witness.address);
    text += query.dump() + "\n";
  }
  return text;
}

}  // namespace

extern const Format witnesses_format = {"witnesses.jsonl", "every witness as a query file", render_witnesses};

// ratchet.txt: the ratchet that would accept the run.

extern const Format ratchet_format = {
    "ratchet.txt", "the ratchet that would accept this run",
    [](const Run& run) { return run.ratchet ? std::string(run.ratchet->accepted) : ratchet_text(run.record); }};

}  // namespace axiscert

#include "reports/formats/schemas.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fuzz/files/corpus.h"
#include "fuzz/record/record.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/names.h"
#include "reports/certificate/certificate_data.h"
#include "reports/comparison/comparison_report.h"
#include "reports/gates/requirement.h"
#include "reports/instrument/condition_report.h"
#include "reports/instrument/critical_radius_report.h"
#include "reports/instrument/data.h"
#include "reports/instrument/diagnosis_report.h"
#include "reports/instrument/ladder_report.h"
#include "reports/instrument/league_report.h"
#include "reports/instrument/lists.h"
#include "reports/instrument/map.h"
#include "reports/instrument/mutation_report.h"
#include "reports/instrument/precision_report.h"
#include "reports/instrument/proofs_data.h"
#include "reports/instrument/query_data.h"
#include "reports/instrument/search_report.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

template <class File>
Json file_schema(const Json& schema) {
  Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", File::title}};
  whole.update(schema);
  return whole;
}
template <class File>
Json schema_of() {
  return file_schema<File>(json_schema_of<File>());
}

}  // namespace

std::span<const SchemaEntry> schemas() {
  static constexpr std::array all = {
      SchemaEntry{"certificate", schema_of<CertificateStatement>},
      SchemaEntry{"check", schema_of<CheckLine>},
      SchemaEntry{"comparison", schema_of<ComparisonData>},
      SchemaEntry{"condition", schema_of<ConditionData>},
      SchemaEntry{"corpus", schema_of<CorpusLine>},
      SchemaEntry{"critical-radius", schema_of<CriticalRadiusData>},
      SchemaEntry{"diagnosis", [] { return file_schema<DiagnosisData>(diagnosis_data_schema()); }},
      SchemaEntry{"families", schema_of<FamiliesData>},
      SchemaEntry{"kernels", schema_of<KernelsData>},
      SchemaEntry{"ladder", schema_of<LadderData>},
      SchemaEntry{"league", schema_of<LeagueData>},
      SchemaEntry{"maps", schema_of<MapsData>},
      SchemaEntry{"mutation", schema_of<MutationData>},
      SchemaEntry{"mutation-by-verdict", schema_of<MutationByVerdictData>},
      SchemaEntry{"mutation-of-certified", schema_of<MutationOfCertifiedData>},
      SchemaEntry{"precision", schema_of<PrecisionData>},
      SchemaEntry{"predicates", schema_of<PredicatesData>},
      SchemaEntry{"proofs", schema_of<ProofsData>},
      SchemaEntry{"ratchet", schema_of<RatchetOutcome>},
      SchemaEntry{"record", schema_of<Record>},
      SchemaEntry{"row", schema_of<QueryRow>},
      SchemaEntry{"run", schema_of<RunFile>},
      SchemaEntry{"search", schema_of<SearchData>},
      SchemaEntry{"shrink", schema_of<ShrinkLine>},
  };
  return all;
}

Json schema_named(std::string_view name) {
  std::vector<std::string_view> names;
  for (const SchemaEntry& entry : schemas()) {
    if (entry.name == name) return entry.schema();
    names.push_back(entry.name);
  }
  throw Error(fmt::format("--schema {}: unknown{} schemas: {}", name, did_you_mean(name, names),
                          fmt::join(most_alike_first(name, names), ", ")));
}

// The rows of each command's JSON as a table of one observation a line. Columns follow from the fields where a row of
// JSON is a line. Every column is described in docs/data.md, which cli.Data compares with what is printed.

namespace {

struct DataTable {
  DataColumns columns;
  std::vector<Json> rows;
};

std::string csv_text(const DataTable& table) {
  std::string text = csv_head(table.columns);
  for (const Json& row : table.rows) text += csv_line(table.columns, row);
  return text;
}

// The words of a text.
DataColumns columns_in(std::string_view text) {
  std::istringstream words{std::string(text)};
  return {std::istream_iterator<std::string>(words), {}};
}

// The elements of an array as they are.
DataTable listed_rows(const Json& rows, DataColumns columns) {
  return {std::move(columns), std::vector<Json>(rows.begin(), rows.end())};
}

// A row with `first` before what it has, which is nothing where it is null.
Json extended(Json first, const Json& row) {
  if (!row.is_null()) first.update(row);
  return first;
}

DataTable ladder_rows(const Json& data) {
  DataTable table{
      columns_in(
          "kernel family swept level name queries false_separation missed_separation false_contact touching_flips "
          "by_range median_u p99_u worst_u errors range_events error_without_scale window.low window.high "
          "critical_radius.median_ulps critical_radius.largest_ulps critical_radius.unbounded scalar_ns factor "
          "from pairs trials clusters failures rate low high failures_from failures_to only_from only_to "
          "difference design_effect p p_is_bound mcnemar_p holm_p least"),
      {}};
  for (const Json& kernel : data["kernels"]) {
    for (const auto& [members, level] : {std::pair("axes", "axis"), {"kinds", "kind"}}) {
      for (const auto& [name, window] : kernel["windows"][members].items()) {
        Json row = {{"kernel", kernel["id"]}, {"level", level}, {"name", name}};
        if (window.is_array()) row["window"] = {{"low", window[0]}, {"high", window[1]}};
        table.rows.push_back(std::move(row));
      }
    }
    if (data.contains("speed")) {
      const Json& speed = data["speed"]["kernels"][kernel["id"].get<std::string>()];
      table.rows.push_back(
          {{"kernel", kernel["id"]}, {"level", "verdict"}, {"name", "verdict"}, {"scalar_ns", speed["scalar"]}});
    }
    for (const auto& [family, result] : kernel["families"].items()) {
      const Json head = {{"kernel", kernel["id"]}, {"family", family}, {"swept", result.value("swept", Json())}};
      const auto add_place = [&](const char* level, const std::string& name, const Json& figures) {
        table.rows.push_back(
            extended(extended(head, {{"level", level}, {"name", name}, {"queries", result["queries"]}}), figures));
      };
      add_place("verdict", "verdict", extended(result["verdict"], {{"critical_radius", result["critical_radius"]}}));
      for (const auto& [name, figures] : result["axes"].items()) add_place("axis", name, figures);
      for (const auto& [name, figures] : result["kinds"].items()) {
        add_place("kind", name, figures);
        for (const char* side : {"radius", "side"}) {
          if (figures.contains(side)) add_place("kind", name + "." + side, figures[side]);
        }
      }
      for (const auto& [name, figures] : result["comparisons"].items()) add_place("comparison", name, figures);
      for (const auto& [name, rate] : result["rates"].items()) add_place("rate", name, rate);
    }
  }
  for (Json row : data["differences"]) {
    row["kernel"] = row["to"];
    row["level"] = row["kind"];
    row["name"] = row["figure"];
    table.rows.push_back(std::move(row));
  }
  return table;
}

DataTable precision_rows(const Json& data) {
  DataTable table{
      columns_in("kernel family swept number bits rounding_seed exponents queries false_separation false_contact "
                 "rate low high rounding range"),
      {}};
  for (const ComparisonInfo& comparison : comparisons) table.columns.emplace_back(comparison.name);
  const auto add = [&](const Json& family, const Json& result) {
    for (const auto& [kernel, figures] : result["kernels"].items()) {
      const Json head = {{"kernel", kernel}, {"family", family}, {"swept", result.value("swept", Json())}};
      table.rows.push_back(extended(extended(head, {{"queries", result["queries"]}}), figures["exact"]));
      for (const Json& step : figures["precisions"]) {
        for (const char* exponents : {"unlimited", "limited"}) {
          Json row = extended(extended(head, {{"exponents", exponents}}), step[exponents]["verdict"]);
          row.update(step[exponents]["comparisons"]);
          if (const Json& rate = step[exponents + std::string("_rate")]; rate.is_object()) row.update(rate);
          for (const char* member : {"number", "bits", "rounding_seed", "queries", "rounding", "range"})
            row[member] = step[member];
          table.rows.push_back(std::move(row));
        }
      }
    }
  };
  add(nullptr, data["all"]);
  for (const auto& [family, result] : data["families"].items()) add(family, result);
  return table;
}

DataTable condition_rows(const Json& data) {
  DataTable table{with_columns_of<WrongVerdictsData>(
                      with_columns_of<ConditionCountsData>(columns_in("kernel family swept comparison"))),
                  {}};
  for (const Json& row : data["rows"]) {
    const Json head = {{"kernel", row["kernel"]}, {"family", row["family"]}, {"swept", row.value("swept", Json())}};
    table.rows.push_back(extended(extended(head, row["total"]), row["wrong_verdicts"]));
    for (const auto& [name, counts] : row["comparisons"].items())
      table.rows.push_back(extended(extended(head, {{"comparison", name}}), counts));
  }
  return table;
}

DataTable critical_radius_rows(const Json& data) {
  DataTable table = listed_rows(data["totals"], with_columns_of<CriticalRadiusRow>({}));
  table.rows.insert(table.rows.end(), data["rows"].begin(), data["rows"].end());
  return table;
}

DataTable league_rows(const Json& data) {
  DataTable table{with_columns_of<LeagueFamilyData>(
                      columns_in("kernel precision family touching has_planted_fault ns may_decline")),
                  {}};
  // What is said beside verdicts is in JSON alone: of most kernels all of it is empty.
  std::erase_if(table.columns, [](const std::string& column) { return column.starts_with("contacts."); });
  for (const Json& kernel : data["kernels"]) {
    for (const auto& [family, figures] : kernel["families"].items()) {
      Json row = {{"kernel", kernel["id"]}, {"family", family}};
      for (const char* member : {"precision", "touching", "has_planted_fault", "ns", "may_decline"})
        row[member] = kernel[member];
      table.rows.push_back(extended(std::move(row), figures));
    }
  }
  return table;
}

DataTable search_rows(const Json& data) {
  DataTable table{
      columns_in("kernel precision level name attained_u proved_u relative_u overflow.exponent underflow.exponent "
                 "depth ulps links asked decided undecided invalid unanswered outside_limits"),
      {}};
  const Json head = {{"kernel", data["kernel"]}, {"precision", data["precision"]}};
  for (const Json& comparison : data["comparisons"]) {
    const Json& of_errors = data["looked_at_by_goal"]["error " + comparison["name"].get<std::string>()];
    table.rows.push_back(extended(extended(extended(head, {{"level", "comparison"}}), of_errors), comparison));
  }
  for (const auto& [name, found] : data["verdict"].items()) {
    const Json row = extended(extended(head, {{"level", "verdict"}, {"name", name}}), data["looked_at_by_goal"][name]);
    table.rows.push_back(found.is_null() ? row : extended(row, found));
  }
  return table;
}

// A property a line, with the first of the queries that show it.
DataTable diagnosis_rows(const Json& data) {
  DataTable table{columns_in("kernel predicate precision seed name value sentence queries witnesses witness.answered "
                             "witness.truth witness.shows looked_at.asked looked_at.decided looked_at.undecided "
                             "looked_at.invalid looked_at.unanswered looked_at.outside_limits"),
                  {}};
  for (const Json& property : data["properties"]) {
    Json row = property;
    for (const char* member : {"kernel", "predicate", "precision", "seed"}) row[member] = data[member];
    const Json& witnesses = property["witnesses"];
    row["witnesses"] = witnesses.size();
    if (!witnesses.empty()) row["witness"] = witnesses[0];
    table.rows.push_back(std::move(row));
  }
  return table;
}

DataTable maps_rows(const Json& data) {
  DataTable table{columns_in("map kernel precision kind along.numbers across.numbers level name file decided"), {}};
  for (const Json& entry : data["legend"]) table.columns.push_back(entry["class"]);
  for (const Json& map : data["maps"]) {
    for (const Json& picture : map["pictures"]) {
      Json row = {{"map", map["name"]}};
      for (const char* member : {"kernel", "precision", "kind", "along", "across"}) row[member] = map[member];
      for (const char* member : {"level", "name", "file", "decided"}) row[member] = picture[member];
      table.rows.push_back(extended(std::move(row), picture["counts"]));
    }
  }
  return table;
}

struct NamedTable {
  std::string_view name;  // axiscert-NAME/1 is the schema
  DataTable (*table)(const Json&);
};
constexpr NamedTable named_tables[] = {
    {"ladder", ladder_rows},
    {"precision", precision_rows},
    {"condition", condition_rows},
    {"critical-radius", critical_radius_rows},
    {"league", league_rows},
    {"search", search_rows},
    {"diagnosis", diagnosis_rows},
    {"maps", maps_rows},
    {"mutation-by-verdict",
     [](const Json& data) { return listed_rows(data["mutants"], with_columns_of<JudgedMutantData>({})); }},
    {"families", [](const Json& data) { return listed_rows(data["families"], with_columns_of<ListedFamily>({})); }},
    {"predicates",
     [](const Json& data) { return listed_rows(data["predicates"], with_columns_of<ListedPredicate>({})); }},
    {"proofs", [](const Json& data) { return listed_rows(data["bounds"], with_columns_of<ProvedBoundData>({})); }},
    {"mutation",
     [](const Json& data) {
       return listed_rows(
           data["mutants"],
           columns_in(
               "id precision fault where what caught.family caught.queries caught.address caught.kind caught.depth "
               "caught_by_formulae_alone.family caught_by_formulae_alone.queries equivalent"));
     }},
    {"mutation-of-certified",
     [](const Json& data) {
       return listed_rows(data["steps"], columns_in("step precision mutants shown equivalent by_the_recording_alone"));
     }},
    {"kernels",
     [](const Json& data) {
       return listed_rows(data["kernels"],
                          columns_in("id summary predicate entry formulae precisions targets exposes source"));
     }},
};

}  // namespace

std::string csv_of(const Json& data) {
  const std::string schema = data.at("schema");
  for (const NamedTable& named : named_tables) {
    if (schema.starts_with(fmt::format("axiscert-{}/", named.name))) return csv_text(named.table(data));
  }
  throw std::logic_error(schema + " has no table");
}

}  // namespace axiscert

// `axiscert explain`: a word of reports and documents, a figure of a record, and the schema of a file.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/glossary.h"
#include "cli/usage.h"
#include "fuzz/record/record.h"
#include "kernel/base/error.h"
#include "reports/formats/schemas.h"

namespace axiscert {
namespace {

// A sentence of a schema about a member, with the places where it stands.
struct Figure {
  std::string about, unit;
  std::vector<std::string> places;
};

// Adds the members of that name, or of a path that ends so, in a schema and in those inside it. Of those that a path
// names and that have no sentence, as the links of `verdict.links.rounding`, that of the object around them is added.
void add_figures(const Json& schema, const std::string& place, const std::string& name, std::vector<Figure>& found) {
  const bool is_path = name.find('.') != name.npos;
  const auto at = [&](const std::string& member) { return place.empty() ? member : place + "." + member; };
  const auto add = [&](const std::string& member, const Json& rule) {
    const std::string here = at(member);
    if (!("." + here).ends_with("." + name)) return;
    const Json& said = rule.contains("description") || !is_path ? rule : schema;
    if (!said.contains("description")) return;
    const Figure figure{said["description"], said.value("unit", ""), {here}};
    const auto same = std::find_if(found.begin(), found.end(), [&](const Figure& other) {
      return other.about == figure.about && other.unit == figure.unit;
    });
    if (same == found.end()) found.push_back(figure);
    else same->places.push_back(here);
  };
  for (const auto& [keyword, part] : schema.items()) {
    const bool is_schema = keyword == "items" || keyword == "additionalProperties";
    if (is_schema && part.is_object()) add_figures(part, place, name, found);
    if (keyword != "anyOf") continue;
    for (const Json& one : part) add_figures(one, place, name, found);
  }
  if (is_path && schema.contains("propertyNames"))
    for (const Json& member : schema["propertyNames"].value("enum", Json::array())) add(member, Json::object());
  if (!schema.contains("properties")) return;
  for (const auto& [member, rule] : schema["properties"].items()) {
    add(member, rule);
    add_figures(rule, at(member), name, found);
  }
}

// "kernels.families.trials: Number of queries: ...", a line for each sentence; empty where no member has that name, or
// that path.
std::string figure_text(std::string name) {
  // A column of record.csv is a path; its words are written as they are.
  const bool is_word = name.find('.') == name.npos;
  std::replace_if(
      name.begin(), name.end(), [=](char c) { return is_word && (c == ' ' || c == '-'); }, '_');
  std::vector<Figure> found;
  add_figures(json_schema_of<Record>(), "", name, found);
  std::string text;
  for (const Figure& figure : found)
    text += fmt::format("{}{}: {}\n", fmt::join(figure.places, ", "),
                        figure.unit.empty() ? "" : fmt::format(" ({})", figure.unit), figure.about);
  return text;
}

void print_explanation(const std::string& word) {
  const std::vector<GlossaryEntry> entries = glossary_entries(glossary_text());
  if (const GlossaryEntry* entry = find_entry(entries, word)) {
    fmt::print("{}: {}\n", fmt::join(entry->words, ", "), entry->text);
    return;
  }
  const std::string text = figure_text(word);
  if (text.empty()) throw Error(unknown_word(entries, word));
  fmt::print("{}", text);
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "explain",
      "Say what a word of reports and documents, or a figure of record.json, means; without one, list the words");
  auto given = std::make_shared<std::vector<std::string>>();
  auto schema = std::make_shared<std::string>();
  auto* words = command->add_option("WORD", *given, "for example depth, or missed contact, or max_error_u");
  command
      ->add_option("--schema", *schema, "instead, the JSON Schema of what a command writes, such as record or ladder")
      ->excludes(words);
  add_examples(*command, {{"A word of a report", "axiscert explain missed contact"},
                          {"A figure of record.json", "axiscert explain max_error_u"},
                          {"The schema of a file", "axiscert explain --schema record"}});
  command->callback([&action, given, schema] {
    action = [given, schema] {
      if (!schema->empty()) {
        fmt::print("{}\n", schema_named(*schema).dump(2));
      } else if (!given->empty()) {
        print_explanation(fmt::format("{}", fmt::join(*given, " ")));
      } else {
        for (const GlossaryEntry& entry : glossary_entries(glossary_text()))
          fmt::print("{}\n", fmt::join(entry.words, ", "));
      }
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert

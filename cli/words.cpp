#include "cli/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json.h"
#include "kernel/kernel.h"
#include "kernel/predicate.h"
#include "kernel/registry/called.h"
#include "reports/formats/schemas.h"
#include "reports/gates/level.h"
#include "reports/wording/causes.h"

namespace axiscert {
namespace {

// Lower case, and a space for each '-' and '_'.
std::string comparable_word(std::string_view word) {
  std::string out(word);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return c == '-' || c == '_' ? ' ' : static_cast<char>(std::tolower(c)); });
  return out;
}

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.emplace_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

}  // namespace

std::vector<GlossaryEntry> glossary_entries(std::string_view text) {
  std::vector<GlossaryEntry> entries;
  std::vector<std::string> sections = split(text, "\n## ");
  sections.erase(sections.begin());  // what is said before the first heading
  for (const std::string& section : sections) {
    const std::size_t end = section.find('\n');
    std::string body = section.substr(std::min(end, section.size()));
    const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
    body.erase(body.begin(), std::find_if_not(body.begin(), body.end(), is_space));
    body.erase(std::find_if_not(body.rbegin(), body.rend(), is_space).base(), body.end());
    entries.push_back({split(std::string_view(section).substr(0, end), ", "), body});
  }
  return entries;
}

bool is_same_word(std::string_view known, std::string_view word) {
  const std::string given = comparable_word(word), name = comparable_word(known);
  return name == given || given == name + "s" || given == name + "es";
}

const GlossaryEntry* find_entry(const std::vector<GlossaryEntry>& entries, std::string_view word) {
  for (const GlossaryEntry& entry : entries) {
    for (const std::string& known : entry.words) {
      if (is_same_word(known, word)) return &entry;
    }
  }
  return nullptr;
}

namespace {

class NamedWords {
 public:
  std::vector<NamedWord> all() {
    for (const Predicate* predicate : predicates()) add_predicate_words(*predicate);
    for (const Family* family : families())
      add("family", family->name, fmt::format("of {}: {}", family->predicate().id, family->purpose));
    for (const Kernel& kernel : kernels())
      add("kernel", kernel.id, fmt::format("of {}: {}", kernel.predicate->id, kernel.summary));
    for (const ArithmeticInfo& arithmetic : arithmetics()) add("arithmetic", arithmetic.name, arithmetic.summary);
    for (const CallMode& mode : call_modes()) add("way to call a kernel", mode.name, mode.summary);
    for (const GateLevel* level : gate_levels())
      add("level", level->name(), fmt::format("{}: {}", level->usage, level->meaning));
    for (const PropertyKind& kind : property_kinds()) add_property_words(kind);
    for (const InputClass which : enumerators<InputClass>)
      add("class of the input", name(which), class_words[which].meaning);
    return std::move(words_);
  }

 private:
  void add(std::string_view kind, std::string_view name, std::string_view text) {
    words_.push_back({kind, std::string(name), std::string(text)});
  }

  void add_predicate_words(const Predicate& predicate) {
    add("predicate", predicate.id, fmt::format("{}; {}", predicate.asks, predicate.rule.text));
    for (const PredicateEntry& entry : predicate.entries)
      add("entry", entry.name,
          fmt::format("of {}: {} numbers; {}", predicate.id, entry.columns.size(), entry.validity));
    for (const PredicateClause& clause : predicate.clauses)
      add("axis", clause.name, fmt::format("of {}: it separates where all of its comparisons hold", predicate.id));
    for (const PredicateComparison& comparison : predicate.comparisons)
      add("comparison", comparison.name,
          fmt::format("of {}, of the axis {}", predicate.id, predicate.clauses[comparison.clause].name));
    for (const PredicateMeasure& measure : predicate.measures)
      add("measure", measure.name, fmt::format("of {}: {}; {}", predicate.id, measure.unit, measure.error));
    for (const WrongAnswer& wrong : predicate.wrong_answers)
      add("wrong answer", wrong.name,
          fmt::format("of {}: {} said, {} right", predicate.id, name(wrong.said), name(wrong.right)));
    const Capabilities& has = capabilities_of(predicate);
    if (has.situations != nullptr) {
      for (const Situation* situation : has.situations->of_families)
        add("situation", situation->name, fmt::format("{}. {}", situation->meaning, situation->advice));
    }
    if (has.traits != nullptr) {
      for (const Trait& trait : has.traits->all)
        add("trait", trait.name, fmt::format("of {}: {}", has.traits->noun, trait.phrase));
    }
  }

  void add_property_words(const PropertyKind& kind) {
    add("property", kind.name, kind.asks);
    for (const std::string_view value : kind.values)
      add("value", value, fmt::format("of the property {}: {}", kind.name, kind.asks));
  }

  std::vector<NamedWord> words_;
};

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
    for (Json one : part) {  // what may be null too
      if (schema.contains("description") && !one.contains("description")) one["description"] = schema["description"];
      add_figures(one, place, name, found);
    }
  }
  if (is_path && schema.contains("propertyNames"))
    for (const Json& member : schema["propertyNames"].value("enum", Json::array())) add(member, Json::object());
  if (!schema.contains("properties")) return;
  for (const auto& [member, rule] : schema["properties"].items()) {
    add(member, rule);
    add_figures(rule, at(member), name, found);
  }
}

std::vector<std::string> texts_in(const Json& values) {
  std::vector<std::string> texts;
  for (const Json& value : values) {
    if (value.is_string()) texts.push_back(value);
  }
  return texts;
}

// Adds the members whose values are listed, where one of them is the word.
void add_listed_values(const Json& schema, const std::string& place, const std::string& word,
                       std::vector<Figure>& found) {
  if (schema.is_array()) {
    for (const Json& part : schema) add_listed_values(part, place, word, found);
  }
  if (!schema.is_object()) return;
  const Json values = schema.value("enum", Json::array());
  if (std::ranges::find(values, Json(word)) != values.end()) {
    const std::string about = schema.value("description", "");
    found.push_back({fmt::format("{}{}One of: {}.", about, about.empty() ? "" : " ", fmt::join(texts_in(values), ", ")),
                     "",
                     {place}});
  }
  for (const auto& [key, part] : schema.items()) {
    if (key == "properties") {
      for (const auto& [member, rule] : part.items())
        add_listed_values(rule, place.empty() ? member : place + "." + member, word, found);
    } else if (key != "enum") {
      add_listed_values(part, place, word, found);
    }
  }
}

std::string text_of_figures(const std::vector<Figure>& figures, std::string_view schema) {
  std::string text;
  for (const Figure& figure : figures)
    text += fmt::format("{}{}{}: {}\n", schema, fmt::join(figure.places, ", "),
                        figure.unit.empty() ? "" : fmt::format(" ({})", figure.unit), figure.about);
  return text;
}

}  // namespace

std::vector<NamedWord> named_words() { return NamedWords().all(); }

std::string comparable_heading(std::string_view heading) {
  std::string name(heading.substr(0, std::min(heading.find(", "), heading.size())));
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

std::string listed_value_text(const std::string& word) {
  for (const SchemaEntry& entry : schemas()) {
    std::vector<Figure> found;
    add_listed_values(entry.schema(), "", word, found);
    if (!found.empty()) return text_of_figures({found.front()}, fmt::format("{}: ", entry.name));
  }
  return "";
}

std::string figure_text(std::string name) {
  // A column of record.csv is a path; its words are written as they are.
  if (name.find('.') == name.npos) name = comparable_heading(name);
  std::vector<Figure> found;
  add_figures(schema_named("record"), "", name, found);
  if (!found.empty()) return text_of_figures(found, "");
  for (const SchemaEntry& entry : schemas()) {
    add_figures(entry.schema(), "", name, found);
    if (!found.empty()) return text_of_figures(found, fmt::format("{}: ", entry.name));
  }
  return "";
}

}  // namespace axiscert

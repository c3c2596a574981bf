#include "kernel/plugin/manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "kernel/base/error.h"
#include "kernel/plugin/pipe_format.h"

namespace axiscert::plugin {
namespace {

// The line with text(place) for each of its places.
std::string with_places(std::string_view line, const std::function<std::string(std::string_view)>& text) {
  std::string filled;
  while (!line.empty()) {
    const std::size_t open = line.find('{');
    filled += line.substr(0, open);
    if (open == line.npos) break;
    line.remove_prefix(open + 1);
    const std::size_t end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    if (end == 0 || end == line.npos || line[end] != '}') {
      filled += '{';
      continue;
    }
    filled += text(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  return filled;
}

}  // namespace

std::vector<std::string> places_of(const PredicateEntry& entry) {
  std::vector<std::string> places;
  for (const PredicateColumn& column : entry.columns) places.emplace_back(column.name);
  for (const ColumnGroup& group : groups_of(entry)) {
    if (group.size > 1) places.emplace_back(group.name);
  }
  return places;
}

std::string unknown_place(std::string_view line, const std::vector<std::string>& known) {
  std::string unknown;
  with_places(line, [&](std::string_view place) {
    if (unknown.empty() && std::find(known.begin(), known.end(), place) == known.end()) unknown = place;
    return std::string();
  });
  return unknown;
}

std::string filled_code(const std::vector<std::string>& lines, const PredicateEntry& entry,
                        const std::vector<std::string>& numbers) {
  const auto text = [&](std::string_view place) {
    for (std::size_t k = 0; k < entry.columns.size(); ++k) {
      if (entry.columns[k].name == place) return numbers[k];
    }
    for (const auto& [name, first, size] : groups_of(entry)) {
      if (name == place) return fmt::format("{}", fmt::join(std::span(numbers).subspan(first, size), ", "));
    }
    return fmt::format("{{{}}}", place);
  };
  std::string code;
  for (const std::string& line : lines) code += with_places(line, text) + "\n";
  return code;
}

namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string_view> members = {
    "format",   "name",     "command", "predicate", "entry",       "precisions",  "exposes",
    "measures", "touching", "limits",  "motion",    "may_decline", "conforms_to", "formulae",
    "summary",  "source",   "package", "version",   "code",        "files",       "sides"};
const std::vector<std::string_view> motion_members = {"start", "still", "sides"};
const std::vector<std::string_view> limit_members = {"least_coordinate", "greatest_coordinate", "least_area",
                                                     "least_radius",     "greatest_radius",     "margin"};

// A JSON value as a message may quote it.
std::string shown_value(const Json& value) {
  if (value.is_structured()) return fmt::format("an {}", value.type_name());
  constexpr std::size_t longest = 60;
  const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return printable_line(text.size() <= longest ? text : text.substr(0, longest) + "...");
}

class ManifestReader {
 public:
  explicit ManifestReader(const std::string& name) : name_(name) {}

  Manifest read(std::string_view text) {
    json_ = Json::parse(text, nullptr, false);
    if (json_.is_discarded()) fail("not a manifest: it is not JSON");
    if (!json_.is_object() || !json_.contains("format")) {
      fail(fmt::format("not a manifest: a JSON object with \"format\": \"{}\" is (docs/plugins.md)", manifest_format));
    }
    if (const std::string format = text_of("format"); format != manifest_format) {
      fail(fmt::format(
          "format '{}', but this axiscert reads {}: write the manifest again as docs/plugins.md has it, and "
          "its program for streams of version {}",
          printable_line(format), manifest_format, pipe::version));
    }
    require_known(json_, members, "member");
    Manifest manifest;
    manifest.name = text_of("name");
    if (manifest.name.empty()) fail("it has no \"name\", under which reports show it");
    manifest.command = words("command");
    if (manifest.command.empty() || manifest.command.front().empty())
      fail("it has no \"command\", a list of the program and its arguments, as in [\"node\", \"my_kernel.mjs\"]");
    for (const std::string& word : words("precisions")) {
      manifest.precisions.push_back(one_of<Precision>("precisions", word, precision_names));
    }
    std::sort(manifest.precisions.begin(), manifest.precisions.end());
    if (manifest.precisions.empty()) fail("it has no \"precisions\": a list of binary32, binary64, or both");
    if (std::adjacent_find(manifest.precisions.begin(), manifest.precisions.end()) != manifest.precisions.end())
      fail("\"precisions\" names one twice");
    if (json_.contains("exposes")) manifest.exposes = one_of<Exposure>("exposes", text_of("exposes"), exposure_names);
    if (manifest.exposes == Exposure::sides)
      fail("\"exposes\": a program's replies have no sides; known: verdict, comparisons");
    manifest.measures = measures();
    if (json_.contains("touching"))
      manifest.touching = one_of<TouchingPolicy>("touching", text_of("touching"), touching_names);
    manifest.limits = limits();
    if (json_.contains("sides"))
      manifest.limits.sides = one_of<SidesPolicy>("sides", text_of("sides"), sides_policy_names);
    manifest.motion = motion();
    manifest.may_decline = yes_or_no("may_decline");
    manifest.predicate = text_of("predicate");
    manifest.entry = text_of("entry");
    manifest.conforms_to = text_of("conforms_to");
    manifest.formulae = text_of("formulae");
    manifest.summary = text_of("summary");
    manifest.source = text_of("source");
    manifest.package = text_of("package");
    manifest.version = text_of("version");
    manifest.code = code(manifest);
    manifest.files = words("files");
    return manifest;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: {}", name_, what)); }

  void require_known(const Json& object, const std::vector<std::string_view>& known, std::string_view what) const {
    for (const auto& [member, value] : object.items()) {
      if (std::find(known.begin(), known.end(), member) == known.end())
        fail(printable_line(unknown_name(what, fmt::format("{}s", what), member, known)));
    }
  }

  void check_text(const char* member, const Json& value) const {
    if (!value.is_string()) fail(fmt::format("\"{}\" is {}, which is no text", member, shown_value(value)));
    if (value.get_ref<const std::string&>().find('\0') != std::string::npos)
      fail(fmt::format("\"{}\" has a character 0", member));
  }

  // Empty where there is none.
  std::string text_of(const char* member) const {
    const auto found = json_.find(member);
    if (found == json_.end() || found->is_null()) return "";
    check_text(member, *found);
    return printable_line(found->get<std::string>());
  }

  std::vector<std::string> words(const char* member) const {
    const auto found = json_.find(member);
    if (found == json_.end()) return {};
    if (!found->is_array()) fail(fmt::format("\"{}\" is {}, which is no list", member, shown_value(*found)));
    std::vector<std::string> all;
    for (const Json& word : *found) {
      check_text(member, word);
      all.push_back(word.get<std::string>());
    }
    return all;
  }

  // The entry whose queries the program takes; null where there is none of that name, which is refused when it is
  // loaded.
  static const PredicateEntry* entry_of(const Manifest& manifest) {
    for (const Predicate* predicate : predicates()) {
      if (written_name(*predicate) != manifest.predicate && predicate->id != manifest.predicate) continue;
      for (const PredicateEntry& entry : predicate->entries) {
        if (manifest.entry.empty() || entry.name == manifest.entry) return &entry;
      }
    }
    return nullptr;
  }

  std::vector<std::string> code(const Manifest& manifest) const {
    const std::vector<std::string> lines = words("code");
    const PredicateEntry* const entry = entry_of(manifest);
    const std::vector<std::string> known = entry ? places_of(*entry) : std::vector<std::string>{};
    for (const std::string& line : lines) {
      if (line != printable_line(line)) fail(fmt::format("\"code\": '{}' is more than a line", printable_line(line)));
      const std::string unknown = entry ? unknown_place(line, known) : "";
      if (!unknown.empty()) {
        fail(
            fmt::format("\"code\": unknown place {{{}}}; known: {{{}}}. Braces of the language itself have a space "
                        "after them",
                        unknown, fmt::join(known, "}, {")));
      }
    }
    return lines;
  }

  template <class Enum>
  Enum one_of(const char* member, const std::string& word, const EnumArray<Enum, std::string_view>& names) const {
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end()) return static_cast<Enum>(found - names.begin());
    fail(fmt::format("\"{}\": '{}'; known: {}", member, printable_line(word),
                     fmt::join(std::vector<std::string_view>(names.begin(), names.end()), ", ")));
  }

  // False where it is not there.
  bool yes_or_no(const char* member) const {
    const auto found = json_.find(member);
    if (found == json_.end() || found->is_null()) return false;
    if (!found->is_boolean()) fail(fmt::format("\"{}\" is {}; known: true, false", member, shown_value(*found)));
    return found->get<bool>();
  }

  std::size_t measures() const {
    const auto found = json_.find("measures");
    if (found == json_.end() || found->is_null()) return 0;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > most_measures)
      fail(fmt::format("\"measures\" is {}; known: 0 to {}, the number that follows each reply", shown_value(*found),
                       most_measures));
    return found->get<std::size_t>();
  }

  MotionPolicy motion() const {
    MotionPolicy motion;
    const auto found = json_.find("motion");
    if (found == json_.end() || found->is_null()) return motion;
    if (!found->is_object()) fail(fmt::format("\"motion\" is {}, which is no object", shown_value(*found)));
    require_known(*found, motion_members, "member");
    const auto read = [&](const char* member, auto& policy, const auto& names) {
      const auto word = found->find(member);
      if (word == found->end()) return;
      check_text(member, *word);
      policy = one_of<std::remove_reference_t<decltype(policy)>>(member, word->template get<std::string>(), names);
    };
    read("start", motion.start, start_policy_names);
    read("still", motion.still, still_policy_names);
    read("sides", motion.sides, sides_policy_names);
    return motion;
  }

  Limits limits() const {
    Limits limits;
    const auto found = json_.find("limits");
    if (found == json_.end() || found->is_null()) return limits;
    if (!found->is_object()) fail(fmt::format("\"limits\" is {}, which is no object", shown_value(*found)));
    require_known(*found, limit_members, "limit");
    double* const places[] = {&limits.least_coordinate, &limits.greatest_coordinate, &limits.least_area,
                              &limits.least_radius,     &limits.greatest_radius,     &limits.margin};
    for (std::size_t i = 0; i < limit_members.size(); ++i) {
      const auto limit = found->find(std::string(limit_members[i]));
      if (limit == found->end()) continue;
      if (!limit->is_number() || !(limit->get<double>() >= 0) || !std::isfinite(limit->get<double>()))
        fail(fmt::format("\"{}\" is {}; known: finite numbers, from 0 on", limit_members[i], shown_value(*limit)));
      *places[i] = limit->get<double>();
    }
    return limits;
  }

  std::string name_;
  Json json_;
};

}  // namespace

Manifest read_manifest(std::string_view text, const std::string& name) { return ManifestReader(name).read(text); }

}  // namespace axiscert::plugin

#include "reports/certificate/findings/breaks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "exact/sphere_triangle/measures/input_class.h"
#include "reports/certificate/findings/situations.h"
#include "reports/certificate/statement/statement.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/classes.h"
#include "reports/wording/finding.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

struct Advice {
  std::string_view cause, advice, section;
};
// By the cause's name: a class of input, or a link.
constexpr Advice advices[] = {
    {"tie", "Let r grow by the safe margin, or use a test that is right at the tie, as libaxiscert is.",
     "docs/certified.md#what-is-promised"},
    {"near_tie", "Rounding: let r grow by the safe margin, or use libaxiscert.", "docs/certified.md#what-is-promised"},
    {"scale", "Bring the scene to a unit of length in which its numbers lie within the window of degree 6.",
     "docs/error_model.md#units-of-length"},
    {"repeated", "Drop triangles with two equal vertices when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"collinear", "Drop triangles without area when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"sliver", "Mend slivers when the mesh is read, or take a test with more precision for them.",
     "docs/precision.md#the-ladder"},
    {"far", "Subtract an origin near the scene before the numbers are rounded to the test's precision.",
     "docs/precision.md#flips-caused-by-the-query-and-by-the-formula"},
    {"ordinary",
     "Look for a fault of logic, or an absolute number: `axiscert check` the witness, and `axiscert map` it.",
     "docs/error_model.md#the-class-of-the-input"},
    {"specification",
     "The formulae are wrong over the reals: take others, as those of `nonstrict` or `reduced-nonstrict`.",
     "docs/precision.md#the-reduced-rung"},
    {"rounding", "Let r grow by the safe margin, or take a form that rounds less, or libaxiscert.",
     "docs/precision.md#the-reduced-rung"},
    {"range", "Bring the scene to a unit of length in which nothing over- or underflows.",
     "docs/error_model.md#units-of-length"},
    {"implementation", "The code does not compute its own formulae: compare it, `axiscert check`, with the reference.",
     "docs/error_model.md#the-chain"},
    {"unattributed", "Compare the verdict with the exact one: `axiscert check` the witness.",
     "docs/error_model.md#the-chain"},
    {"finding", "The kernel does not answer as a kernel has to: mend that before anything else.",
     "docs/error_model.md#findings"},
};

// A cause of wrong verdicts of one kind.
struct Cause {
  std::string name, meaning;
  std::uint64_t count;
  double deepest;
};

Json break_json(const std::string& precision, const std::string& what, const Cause& cause) {
  const auto advice =
      std::find_if(std::begin(advices), std::end(advices), [&](const Advice& a) { return a.cause == cause.name; });
  return {{"precision", precision.empty() ? Json(nullptr) : Json(precision)},
          {"what", what},
          {"cause", cause.name},
          {"meaning", cause.meaning},
          {"count", cause.count},
          {"deepest", amount(cause.deepest, 3)},
          {"advice", advice->advice},
          {"section", advice->section}};
}

// The deepest cause of a kind of wrong verdict in a kernel's entry: `missed` or phantom contacts.
std::optional<Cause> deepest_cause(const Json& record, const Json& entry, bool missed) {
  std::optional<Cause> deepest;
  const auto offer = [&](Cause cause) {
    if (cause.count != 0 && (!deepest || cause.deepest > deepest->deepest)) deepest = std::move(cause);
  };
  const std::string kind = missed ? "false_separation" : "false_contact";
  // By the class of its input, where the links do not say why.
  for (const auto& [family, result] : entry["families"].items()) {
    const Json classes = result.value("classes", Json::object());
    for (const InputClass which : enumerators<InputClass>) {
      const auto found = classes.find(std::string(input_class_names[which]));
      if (found == classes.end()) continue;
      offer({std::string(input_class_names[which]), std::string(class_meanings[which]),
             (*found)[kind].get<std::uint64_t>(), (*found)["deepest"].get<double>()});
    }
  }
  if (deepest) return deepest;
  // Else by the links of its witnesses.
  const Json total = all_families(entry);
  if (!total.contains("verdict") || total["verdict"][kind] == 0) return std::nullopt;
  for (const Json& witness : record["witnesses"]) {
    if (witness["kernel"] != entry["id"] || witness["precision"] != entry["precision"] || witness["depth"].is_null())
      continue;
    for (const Json& flip : witness["flips"]) {
      if (flip["level"] != "verdict" || flip["kind"] != kind) continue;
      for (const Link link : enumerators<Link>) {
        const std::string name(link_names[link]);
        if (std::find(flip["links"].begin(), flip["links"].end(), name) == flip["links"].end()) continue;
        offer({name, std::string(link_meanings[link]), total["verdict"][kind].get<std::uint64_t>(),
               witness["depth"].get<double>()});
      }
    }
  }
  if (deepest) return deepest;
  const Link unknown = Link::unattributed;
  return Cause{std::string(link_names[unknown]), std::string(link_meanings[unknown]),
               total["verdict"][kind].get<std::uint64_t>(), total["verdict"]["deepest_" + kind].get<double>()};
}

// The query alone, by the groups of its test's columns in whichever entry it is.
Json query_of(const Json& witness, const TestDescription& test) {
  Json query = Json::object();
  if (const std::string_view name = written_name(test); !name.empty()) query["test"] = name;
  for (const TestEntry& entry : test.entries) {
    for (const ColumnGroup& group : groups_of(entry)) {
      if (const auto numbers = witness.find(std::string(group.name)); numbers != witness.end())
        query[std::string(group.name)] = *numbers;
    }
  }
  return query;
}

// "missed contacts in families x, y, up to 0.4 of the scene deep"
std::string failures_text(const Json& situation, bool missed) {
  constexpr std::size_t most = 3;
  std::vector<std::string> families = situation["families"];
  const std::size_t more = families.size() - std::min(most, families.size());
  families.resize(families.size() - more);
  return fmt::format("{} in {} {}{}, up to {} of the scene deep", missed ? "missed contacts" : "phantom contacts",
                     families.size() + more == 1 ? "the family" : "the families", fmt::join(families, ", "),
                     more == 0 ? "" : fmt::format(" and {} more", more),
                     amount(situation[missed ? "deepest_missed" : "deepest_phantom"], 3));
}

Json break_of_situation(const Json& situation, bool missed) {
  return {{"precision", situation["precision"]},
          {"what", missed ? "missed contact" : "phantom contact"},
          {"cause", situation["situation"]},
          {"meaning", fmt::format("{}: {}", situation["meaning"].get<std::string>(), failures_text(situation, missed))},
          {"count", situation[missed ? "missed" : "phantom"]},
          {"deepest", amount(situation[missed ? "deepest_missed" : "deepest_phantom"], 3)},
          {"advice", situation["advice"]},
          {"section", situation["section"]}};
}

}  // namespace

Json what_breaks_first(const Json& record, const std::string& kernel) {
  for (const Json& finding : record["findings"]) {
    if (finding["kernel"] == kernel)
      return break_json("", "finding", {"finding", finding_text(finding), finding["count"].get<std::uint64_t>(), 0});
  }
  for (const bool missed : {true, false}) {
    std::optional<Cause> deepest;
    std::string precision;
    for (const Json& entry : record["kernels"]) {
      if (entry["id"] != kernel) continue;
      const std::optional<Cause> cause = deepest_cause(record, entry, missed);
      if (!cause || (deepest && cause->deepest <= deepest->deepest)) continue;
      deepest = cause;
      precision = entry["precision"];
    }
    if (!deepest) continue;
    // Where only the verdict is seen, the situation says more than that nothing is known.
    if (deepest->name == link_names[Link::unattributed]) break;
    return break_json(precision, missed ? "missed contact" : "phantom contact", *deepest);
  }
  bool missed = true;
  const Json situations = situations_json(record, kernel);
  const Json* first = first_situation(situations, missed);
  return first == nullptr ? Json() : break_of_situation(*first, missed);
}

Json where_it_is_wrong(const Json& record, const std::string& kernel) {
  Json situations = situations_json(record, kernel);
  for (Json& situation : situations) {
    for (const char* depth : {"deepest_missed", "deepest_phantom"}) situation[depth] = amount(situation[depth], 3);
  }
  return situations;
}

std::vector<std::string_view> advised_sections() {
  std::vector<std::string_view> sections;
  for (const Advice& advice : advices) sections.push_back(advice.section);
  return sections;
}

Json worst_of_certificate(const Json& record, const std::string& kernel) {
  constexpr std::size_t most = 3;
  Json own = record;
  own["witnesses"] = Json::array();
  for (const Json& witness : record["witnesses"]) {
    if (witness["kernel"] == kernel) own["witnesses"].push_back(witness);
  }
  Json worst = Json::array();
  std::set<std::string> families;
  for (const bool another_family : {true, false}) {
    for (const Json* witness : worst_witnesses(own, own["witnesses"].size())) {
      const std::string family = (*witness)["family"], address = (*witness)["address"];
      if (worst.size() == most) return worst;
      const bool is_there =
          std::any_of(worst.begin(), worst.end(), [&](const Json& w) { return w["address"] == address; });
      if (is_there || (another_family && !families.insert(family).second)) continue;
      const Json query = query_of(*witness, test_of(record["plan"]));
      const std::string truth =
          (*witness)["touching"].get<bool>() ? "touching" : (*witness)["truth"].get<std::string>();
      const std::string depth =
          (*witness)["depth"].is_null() ? "" : fmt::format(", {} of the scene deep", amount((*witness)["depth"], 3));
      worst.push_back(
          {{"title", fmt::format("{} {}, family {}", kernel, (*witness)["precision"].get<std::string>(), family)},
           {"sentence", fmt::format("The truth is {}, the kernel says {}{}. Address {}.", truth,
                                    (*witness)["computed"].get<std::string>(), depth, address)},
           {"address", address},
           {"command", replay_command(*witness, record["plan"])},
           {"query", without_fractions(query)}});
    }
  }
  return worst;
}

}  // namespace axiscert

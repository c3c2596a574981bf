#include "reports/requirement.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>

#include "exact/judge.h"
#include "kernel/error.h"

namespace axiscert {
namespace {

using Shows = std::function<bool(const Json& verdict_flip)>;

class Search {
 public:
  explicit Search(const Json& record) : record_(record) {}

  std::vector<Failure> run(const Requirement& requirement) {
    for (const Json& kernel : record_["kernels"]) {
      kernel_ = &kernel;
      for (const auto& [family, result] : kernel["families"].items()) {
        family_ = family;
        search(requirement, result);
      }
    }
    return std::move(failures_);
  }

 private:
  void search(const Requirement& requirement, const Json& result) {
    const Json& verdict = result["verdict"];
    const auto count = [&](const char* member) { return verdict[member].get<std::uint64_t>(); };
    const std::uint64_t missed = count("false_separation"), phantom = count("false_contact");
    const Shows is_missed = [](const Json& flip) { return flip["kind"] == "false_separation"; };
    const Shows nothing = [](const Json&) { return false; };  // such an answer is no flip
    const Shows is_phantom = [](const Json& flip) { return flip["kind"] == "false_contact"; };
    switch (requirement.level) {
      case RequirementLevel::logic:
        return search_links({Link::specification, Link::implementation}, result);
      case RequirementLevel::range:
        return search_links({Link::specification, Link::implementation, Link::range}, result);
      case RequirementLevel::exact:
        add(missed, "missed contacts", is_missed);
        add(phantom, "phantom contacts", is_phantom);
        add(count("invalid"), "answers `invalid` to valid queries", nothing);
        return;
      case RequirementLevel::conservative:
        add(missed, "missed contacts", is_missed);
        add(count("invalid"), "answers `invalid` to valid queries", nothing);
        const double deepest = verdict["deepest_false_contact"].get<double>();
        if (deepest > requirement.deepest) {
          add(phantom,
              fmt::format("phantom contacts, the deepest by {:.4g} of the scene: {} is allowed", deepest,
                          requirement.deepest),
              is_phantom);
        }
    }
  }

  void search_links(std::initializer_list<Link> links, const Json& result) {
    const Json& verdict = result["verdict"];
    if ((*kernel_)["formulae"].is_null()) {
      // No reference to compare with: on exact arithmetic a wrong verdict can only be wrong logic. Whether touching is
      // contact is a convention, and the kernel's own may differ.
      if (!result["exact_arithmetic"].get<bool>()) return;
      const std::uint64_t wrong =
          verdict["false_separation"].get<std::uint64_t>() + verdict["false_contact"].get<std::uint64_t>();
      add(
          wrong - verdict["touching_flips"].get<std::uint64_t>(), "wrong verdicts in exact arithmetic, touching apart",
          [](const Json&) { return true; }, false);
      return;
    }
    for (const Link link : links) {
      const std::string name(link_names[static_cast<std::size_t>(link)]);
      add(verdict["links"][name].get<std::uint64_t>(), fmt::format("wrong verdicts with a broken {} link", name),
          [name](const Json& flip) {
            return std::find(flip["links"].begin(), flip["links"].end(), name) != flip["links"].end();
          });
    }
  }

  void add(std::uint64_t count, const std::string& what, const Shows& shows, bool touching_counts = true) {
    if (count == 0) return;
    const Json* deepest = nullptr;
    for (const Json& witness : record_["witnesses"]) {
      const bool is_of_family = witness["family"].get_ref<const std::string&>() == family_ &&
                                witness["kernel"] == (*kernel_)["id"] &&
                                witness["precision"] == (*kernel_)["precision"];
      if (!is_of_family || witness["depth"].is_null()) continue;
      if (witness["touching"].get<bool>() && !touching_counts) continue;
      const bool is_shown = std::any_of(witness["flips"].begin(), witness["flips"].end(),
                                        [&](const Json& flip) { return flip["level"] == "verdict" && shows(flip); });
      if (is_shown && (deepest == nullptr || witness["depth"] > (*deepest)["depth"])) deepest = &witness;
    }
    failures_.push_back({(*kernel_)["id"], (*kernel_)["precision"], family_, count, what,
                         deepest == nullptr ? "" : (*deepest)["id"].get<std::string>()});
  }

  const Json& record_;
  const Json* kernel_ = nullptr;
  std::string family_;
  std::vector<Failure> failures_;
};

}  // namespace

std::string Requirement::sentence() const {
  const std::string verdicts_only = "for a kernel that shows only verdicts: none in exact arithmetic, touching apart";
  switch (level) {
    case RequirementLevel::logic:
      return "no wrong verdict with a broken specification or implementation link; " + verdicts_only;
    case RequirementLevel::range:
      return "no wrong verdict with a broken specification, implementation or range link; " + verdicts_only;
    case RequirementLevel::exact:
      return "no wrong verdict";
    case RequirementLevel::conservative:
      break;
  }
  return deepest == std::numeric_limits<double>::infinity()
             ? "no missed contact"
             : fmt::format("no missed contact, and no phantom contact deeper than {} of the scene", deepest);
}

Requirement parse_requirement(const std::string& text) {
  if (text == "logic") return {RequirementLevel::logic};
  if (text == "range") return {RequirementLevel::range};
  if (text == "exact") return {RequirementLevel::exact};
  if (text == "conservative") return {RequirementLevel::conservative};
  const std::string prefix = "conservative=";
  if (!text.starts_with(prefix)) {
    throw Error(
        fmt::format("unknown requirement '{}'; levels: logic, range, exact, conservative, conservative=D", text));
  }
  Requirement requirement{RequirementLevel::conservative};
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + prefix.size(), end, requirement.deepest);
  if (problem != std::errc() || stop != end || !(requirement.deepest >= 0)) {
    throw Error(fmt::format("requirement '{}': D is a depth, a number from 0 on, as in conservative=0.001", text));
  }
  return requirement;
}

bool Failure::is_of(const Json& entry) const {
  return entry["id"].get_ref<const std::string&>() == kernel &&
         entry["precision"].get_ref<const std::string&>() == precision;
}

std::string Failure::text() const {
  const std::string shown_by = witness.empty() ? "" : fmt::format(" (witness {})", witness);
  return fmt::format("{} {} on {}: {}: {}{}", kernel, precision, family, what, count, shown_by);
}

std::vector<Failure> unmet(const Json& record, const std::string& level) {
  return Search(record).run(parse_requirement(level));
}

}  // namespace axiscert

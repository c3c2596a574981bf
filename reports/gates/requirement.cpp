#include "reports/gates/requirement.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>

#include "exact/judge/judge.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

using Shows = std::function<bool(const Json& verdict_flip)>;

class Search {
 public:
  explicit Search(const Json& record) : record_(record) {}

  std::vector<Failure> run(const Requirement& requirement) {
    for (const Json& finding : record_["findings"]) add_finding(finding);
    for (const Json& kernel : record_["kernels"]) {
      kernel_ = &kernel;
      for (const auto& [family, result] : kernel["families"].items()) {
        family_ = family;
        add(result["verdict"]["unanswered"].get<std::uint64_t>(), "valid queries without an answer", nothing);
        add(result["critical_radius"]["unanswered"].get<std::uint64_t>(),
            "searches for a critical radius without an answer", nothing);
        search(requirement, result);
      }
    }
    return std::move(failures_);
  }

 private:
  static bool nothing(const Json&) { return false; }  // such an answer is not a flip

  void add_finding(const Json& finding) {
    const auto text = [&](const char* member) {
      return finding[member].is_null() ? "" : finding[member].get<std::string>();
    };
    failures_.push_back({text("kernel"), text("precision"), text("family"), finding["count"].get<std::uint64_t>(),
                         fmt::format("{}: {}", text("kind"), text("detail")), ""});
  }

  void search(const Requirement& requirement, const Json& result) {
    const Json& verdict = result["verdict"];
    const auto count = [&](const char* member) { return verdict[member].get<std::uint64_t>(); };
    const std::uint64_t missed = count("false_separation"), phantom = count("false_contact");
    const Shows is_missed = [](const Json& flip) { return flip["kind"] == "false_separation"; };
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
    const Json &verdict = result["verdict"], &reference = (*kernel_)["reference"];
    const bool exact_arithmetic = result["exact_arithmetic"].get<bool>();
    const auto number = [&](const char* member) { return verdict[member].get<std::uint64_t>(); };
    if (reference.is_null()) {
      // Without formulae to compare with, a wrong verdict in exact arithmetic is wrong logic. A method of the kernel's
      // own may still round there, and for a touching sphere any rounding shows.
      if (!exact_arithmetic) return;
      const std::uint64_t wrong = number("false_separation") + number("false_contact");
      add(
          wrong - number("touching_flips"), "wrong verdicts in exact arithmetic, touching spheres not counted",
          [](const Json&) { return true; }, false);
      return;
    }
    for (const Link link : links) add_link(link, verdict["links"], 0);
    // Formulae evaluated in an order of operations of the kernel's own: where they round, an unattributed difference
    // may be rounding and is not a fault of logic. In exact arithmetic it is one.
    if (!reference.get<bool>() && exact_arithmetic) {
      const std::string name(link_names[Link::unattributed]);
      add_link(Link::unattributed, verdict["links"], verdict["touching_links"][name].get<std::uint64_t>());
    }
  }

  // `apart`: the number of them that are touching queries, which do not count.
  void add_link(Link link, const Json& links, std::uint64_t apart) {
    const std::string name(link_names[link]);
    const bool in_exact_arithmetic = link == Link::unattributed;
    add(
        links[name].get<std::uint64_t>() - apart,
        in_exact_arithmetic
            ? "wrong verdicts in exact arithmetic that its formulae do not give, touching spheres not counted"
            : fmt::format("wrong verdicts with a broken {} link", name),
        [name](const Json& flip) {
          return std::find(flip["links"].begin(), flip["links"].end(), name) != flip["links"].end();
        },
        !in_exact_arithmetic);
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
  const std::string verdicts_only =
      "for a kernel that claims no formulae, or evaluates them in its own way: none in exact arithmetic that its "
      "formulae "
      "do not give, touching spheres not counted";
  const std::string always = "; no finding, and an answer to every query within its limits";
  switch (level) {
    case RequirementLevel::logic:
      return "no wrong verdict with a broken specification or implementation link; " + verdicts_only + always;
    case RequirementLevel::range:
      return "no wrong verdict with a broken specification, implementation or range link; " + verdicts_only + always;
    case RequirementLevel::exact:
      return "no wrong verdict" + always;
    case RequirementLevel::conservative:
      break;
  }
  const bool any_depth = deepest == std::numeric_limits<double>::infinity();
  return "no missed contact" +
         (any_depth ? "" : fmt::format(", and no phantom contact deeper than {} of the scene", deepest)) + always;
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
         (precision.empty() || entry["precision"].get_ref<const std::string&>() == precision);
}

std::string Failure::text() const {
  const std::string shown_by = witness.empty() ? "" : fmt::format(" (witness {})", witness);
  if (family.empty()) return fmt::format("{}: {}", kernel, what);
  return fmt::format("{} {} on {}: {}: {}{}", kernel, precision, family, what, count, shown_by);
}

std::vector<Failure> unmet(const Json& record, const std::string& level) {
  return Search(record).run(parse_requirement(level));
}

}  // namespace axiscert

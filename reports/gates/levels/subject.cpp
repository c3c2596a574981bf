#include "reports/gates/levels/subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace axiscert {
namespace {

std::uint64_t number_in(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

}  // namespace

std::string Failure::text() const {
  const std::string shown_by = witness.empty() ? "" : fmt::format(" (witness {})", witness);
  if (family.empty()) return fmt::format("{}: {}", kernel, what);
  return fmt::format("{} {} on {}: {}: {}{}", kernel, precision, family, what, count, shown_by);
}

Subject::Basis Subject::basis() const {
  const Json& reference = kernel_["reference"];
  if (reference.is_null()) return Basis::verdicts;
  return reference.get<bool>() ? Basis::reference : Basis::formulae;
}

FamilyLook Subject::whole_look(const Json& result) const {
  const Evidence found = evidence(result);
  return {found.population, found.decided()};
}

void Subject::add(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                  const std::string& what, const Shows& shows, bool touching_counts) const {
  if (count == 0) return;
  const Json* deepest = nullptr;
  for (const Json& witness : record_["witnesses"]) {
    const bool is_of_family = witness["family"].get_ref<const std::string&>() == family &&
                              witness["kernel"] == kernel_["id"] && witness["precision"] == kernel_["precision"];
    if (!is_of_family || witness["depth"].is_null()) continue;
    if (witness["touching"].get<bool>() && !touching_counts) continue;
    const bool is_shown = std::any_of(witness["flips"].begin(), witness["flips"].end(),
                                      [&](const Json& flip) { return flip["level"] == "verdict" && shows(flip); });
    if (is_shown && (deepest == nullptr || witness["depth"] > (*deepest)["depth"])) deepest = &witness;
  }
  failures.push_back({kernel_["id"], kernel_["precision"], family, count, what,
                      deepest == nullptr ? "" : (*deepest)["id"].get<std::string>()});
}

void Subject::add_shown(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                        const std::string& what, std::string_view reason) const {
  if (count == 0) return;
  Failure failure{kernel_["id"], kernel_["precision"], family, count, what, ""};
  for (const Json& witness : record_["witnesses"]) {
    const bool is_ours = witness["family"].get_ref<const std::string&>() == family &&
                         witness["kernel"] == kernel_["id"] && witness["precision"] == kernel_["precision"];
    const Json& shows = witness["shows"];
    if (!is_ours || !std::any_of(shows.begin(), shows.end(), [&](const Json& text) {
          return text.get_ref<const std::string&>().starts_with(reason);
        })) {
      continue;
    }
    failure.witness = witness["id"];
    break;
  }
  failures.push_back(std::move(failure));
}

void Subject::add_pair(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                       const std::string& what, const Json& pair) const {
  if (count == 0) return;
  Failure failure{kernel_["id"], kernel_["precision"], family, count, what, ""};
  if (!pair.is_null()) {
    failure.what +=
        fmt::format("; first on {} beside {}", pair["image"].get<std::string>(), pair["base"].get<std::string>());
    for (const Json& witness : record_["witnesses"]) {
      if (witness["address"] == pair["image"] && witness["kernel"] == kernel_["id"]) failure.witness = witness["id"];
    }
  }
  failures.push_back(std::move(failure));
}

void Subject::add_link(std::vector<Failure>& failures, const std::string& family, Link link,
                       std::uint64_t count) const {
  const std::string name(link_names[link]);
  const bool in_exact_arithmetic = link == Link::unattributed;
  add(
      failures, family, count,
      in_exact_arithmetic
          ? "wrong verdicts in exact arithmetic that its formulae do not give, touching ones not counted"
          : fmt::format("wrong verdicts with a broken {} link", name),
      [name](const Json& flip) {
        return std::find(flip["links"].begin(), flip["links"].end(), name) != flip["links"].end();
      },
      !in_exact_arithmetic);
}

FamilyLook Subject::pairs_look(const Json& result, std::uint64_t compared, std::uint64_t declined) const {
  return {compared + declined + evidence(result).outside, compared, declined};
}

std::uint64_t Subject::wrong_verdicts() const {
  std::uint64_t wrong = 0;
  for (const Json& family : families())
    wrong += number_in(family["verdict"], "false_separation") + number_in(family["verdict"], "false_contact");
  return wrong;
}

std::uint64_t Subject::decided() const { return evidence_of(kernel_).decided(); }

std::string Subject::list_of_families() const {
  std::vector<std::string> names;
  for (const auto& [family, result] : families().items()) names.push_back(family);
  return names.size() > 4 ? fmt::format("{} families", names.size()) : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace axiscert

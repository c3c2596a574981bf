#include "reports/comparison/not_compared.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "kernel/base/error.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t most_reasons = 3;  // that a first line gives
constexpr std::size_t most_names = 20;   // that a message lists

bool has_name(const NotCompared& absent, const std::string& name) {
  if (name.empty()) return false;
  return absent.what == name || absent.family == name ||
         std::ranges::find(absent.kernels, name) != absent.kernels.end();
}

// One sentence is about everything of one reason.
std::string named_group(const std::vector<const NotCompared*>& group, std::size_t families) {
  const std::string& first = group.front()->what;
  if (group.size() == 1) return first;
  const bool are_families =
      std::ranges::all_of(group, [](const NotCompared* absent) { return absent->what == absent->family; });
  const std::string count = thousands(group.size());
  if (are_families && group.front()->absence != Absence::only_new)
    return fmt::format("{} of {} families ({}, ...)", count, thousands(families), first);
  return fmt::format("{} {} ({}, ...)", count, are_families ? "families" : "things", first);
}

}  // namespace

void allow(std::vector<NotCompared>& all, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    bool is_met = false;
    for (NotCompared& absent : all) {
      if (!has_name(absent, name)) continue;
      is_met = true;
      if (absent.absence == Absence::fails) absent.absence = Absence::allowed;
    }
    if (is_met) continue;
    std::vector<std::string> there;
    for (const NotCompared& absent : all) there.push_back(absent.what);
    const std::size_t left_out = there.size() - std::min(there.size(), most_names);
    there.resize(there.size() - left_out);
    throw Error(fmt::format("--allow-not-compared '{}': {}", name,
                            there.empty() ? "everything was compared; leave it out"
                                          : fmt::format("not compared is: {}{}", fmt::join(there, "; "),
                                                        left_out == 0 ? "" : fmt::format("; and {} more", left_out))));
  }
}

std::string absences_text(const std::vector<NotCompared>& all, Absence absence, std::size_t families) {
  std::vector<std::vector<const NotCompared*>> groups;  // by reason
  for (const NotCompared& absent : all) {
    if (absent.absence != absence) continue;
    const auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.front()->why == absent.why; });
    if (group == groups.end()) groups.push_back({&absent});
    else group->push_back(&absent);
  }
  std::vector<std::string> sentences;
  std::size_t left_out = 0;
  for (const auto& group : groups) {
    if (sentences.size() == most_reasons) left_out += group.size();
    else if (absence == Absence::only_new) sentences.push_back(named_group(group, families));
    else sentences.push_back(fmt::format("{}: {}", named_group(group, families), group.front()->why));
  }
  if (left_out != 0) sentences.push_back(fmt::format("{} more", thousands(left_out)));
  return fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace axiscert

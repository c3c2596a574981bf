// The level no-slack: no length by which the kernel answers as if a shape or a motion were larger or smaller.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "fuzz/confirm/slack.h"
#include "fuzz/text/number_text.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// An absolute one is in metres as it is asked for, and in the queries' unit of length as it is found.
struct SlackSize {
  SlackKind kind;
  double size;
};

SlackSize size_argument(const AskedLevel& asked) {
  static const std::string what = fmt::format("a part of a length above 0, as in no-slack=1e-4, or a length in {}",
                                              fmt::join(length_unit_names(), ", "));
  const SizeLimit size = size_limit(asked, {"SIZE", what.c_str(), "1mm", above_0, 1e6});
  return {size.is_length ? SlackKind::absolute : SlackKind::relative, size.most};
}

std::string size_text(const SlackSize& size) {
  return size.kind == SlackKind::relative ? fmt::format("{:.4g} of a length", size.size)
                                          : fmt::format("{:.4g} of the queries' unit", size.size);
}

std::optional<double> least_seen(const SlackLook& look, SlackKind kind) {
  return kind == SlackKind::relative ? look.least_relative : look.least_absolute;
}

std::string look_text(const SlackLook& look, SlackKind kind) {
  return fmt::format("{} on queries {}", size_text({kind, *least_seen(look, kind)}),
                     static_cast<const std::string&>(look.where));
}

// Why nothing is known; empty where a slack of the size would have been seen on the queries of every kind.
std::string unseen_text(const Subject& subject, const SlackSize& size) {
  const auto& slacks = subject.kernel().slack;
  if (!slacks) {
    return fmt::format("slacks were not looked for: {} has no scenes for them, or no kernel was run",
                       predicate_of(subject.record().plan).id);
  }
  const auto least = size.kind == SlackKind::relative ? least_relative(*slacks) : least_absolute(*slacks);
  if (!least) {
    return fmt::format("the turn of the answer was bracketed on {} of {} queries, and {} of one kind are needed",
                       slacks->bracketed, slacks->asked, least_bracketed);
  }
  // A slack may be in one branch alone: every kind has to show it.
  if (!slacks->blind.empty()) return blind_text(*slacks);
  std::vector<SlackLook> coarse;
  for (const SlackLook& look : slacks->looks) {
    if (least_seen(look, size.kind).value_or(0) > size.size) coarse.push_back(look);
  }
  if (coarse.empty()) return "";
  std::ranges::stable_sort(coarse, std::greater(), [&](const SlackLook& look) { return *least_seen(look, size.kind); });
  constexpr std::size_t most_named = 3;
  std::vector<std::string> named;
  for (std::size_t i = 0; i < std::min(coarse.size(), most_named); ++i)
    named.push_back(look_text(coarse[i], size.kind));
  if (coarse.size() > most_named)
    named.push_back(fmt::format("and on {} kinds more above that size", coarse.size() - most_named));
  return fmt::format("the least slack that would be seen is {}, and {} is required", fmt::join(named, ", "),
                     size_text(size));
}

LevelFindings judge_slack(const AskedLevel& asked, const Subject& subject) {
  SlackSize size = size_argument(asked);
  const LengthUnit* const unit = unit_of(subject.record().plan);
  if (size.kind == SlackKind::absolute && unit != nullptr) size.size /= unit->metres;
  LevelFindings found;
  const KernelRecord& kernel = subject.kernel();
  found.not_checked = unseen_text(subject, size);
  if (!kernel.slack) return found;
  for (const SlackRecord& slack : kernel.slack->found) {
    const double here = slack.kind == size.kind ? slack.size : slack.in_units;
    if (here <= size.size) continue;
    found.failures.push_back({kernel.id, std::string(name(kernel.precision)), "slacks", slack.shown,
                              fmt::format("{}, and {} is allowed; as on {}", slack_text(slack), size_text(size),
                                          static_cast<const std::string&>(slack.witness)),
                              "", true});
  }
  const SlackLook* const off = most_off(*kernel.slack, size.kind);
  if (found.failures.empty() && off != nullptr && *off_by(*off, size.kind) > size.size) {
    found.failures.push_back({kernel.id, std::string(name(kernel.precision)), "slacks", least_agreeing,
                              fmt::format("{}, and {} is allowed", off_text(*off, size.kind), size_text(size)), "",
                              true});
  }
  const SlackLook* finest = nullptr;
  const SlackLook* coarsest = nullptr;
  for (const SlackLook& look : kernel.slack->looks) {
    const auto least = least_seen(look, size.kind);
    if (!least) continue;
    if (finest == nullptr || *least < *least_seen(*finest, size.kind)) finest = &look;
    if (coarsest == nullptr || *least > *least_seen(*coarsest, size.kind)) coarsest = &look;
  }
  if (finest == nullptr) return found;
  found.covers =
      fmt::format("{} queries whose turn is bracketed; the least slack that would be seen is {}, and {}",
                  thousands(kernel.slack->bracketed), look_text(*finest, size.kind), look_text(*coarsest, size.kind));
  found.leaves_out = "a slack on other queries than these";
  return found;
}

std::string slack_sentence(const AskedLevel& asked) {
  const SlackSize size = size_argument(asked);
  return fmt::format(
      "no slack above {}: so near to the exact turn the answers turn, but for fewer than {} queries of a kind",
      size.kind == SlackKind::absolute ? metric_text(size.size) : size_text(size), least_agreeing);
}

}  // namespace

extern const GateLevel no_slack_level = {
    .usage = "no-slack=SIZE",
    .meaning =
        "no answers as if a shape or motion were larger or smaller by more than SIZE, a part of a length, or of "
        "the queries' unit where SIZE is in m, cm, mm, um, in or ft (the unit is taken for a metre)",
    .sentence = slack_sentence,
    .judge = judge_slack,
    .asks_itself = true,
    .in_certificates = {}};  // a certificate has the diagnosis, whose property `slack` says it

}  // namespace axiscert

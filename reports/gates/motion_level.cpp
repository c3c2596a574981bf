// The levels of a predicate of motions: never-late, to a length too, and no-tunnel.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr double whole_radius = 1;

double tunnel_argument(const AskedLevel& asked) {
  if (!asked.has_argument) return whole_radius;
  return number_argument(asked, {"F", "a share of the radius, above 0 and at most 1, of at most six digits", "0.5",
                                 above_0, whole_radius, true});
}

// Why times cannot be judged: the predicate has none, or the kernel gives none, or there was no hit.
std::string times_unseen(const Subject& subject) {
  const Predicate& predicate = predicate_of(subject.record().plan);
  if (!is_of_motions(predicate)) return fmt::format("the predicate {} has no time of contact", predicate.id);
  const auto& measures = subject.kernel().measures;
  if (!measures || measures->empty()) return "the kernel gives no time of contact";
  bool is_any = false;
  for (const auto& [family, result] : subject.families()) {
    if (!result.contacts || !result.contacts->missed || !result.contacts->time)
      return fmt::format("the record has no times of the kernel on {}", family);
    is_any = is_any || result.contacts->answers != 0;
  }
  if (is_any) return "";
  return "no query has a contact that it found";
}

// Hits of which nothing is known, since they have no time in [0, 1], and families without any hit.
void add_untimed(const Subject& subject, LevelFindings& found) {
  for (const auto& [family, result] : subject.families()) {
    if (result.contacts->answers == 0) found.unseen.push_back(family);
  }
  subject.add_untimed(found.failures);
}

// Contacts that were found; with `missed` those that were not are looked at too.
void look_at_contacts(const Subject& subject, bool missed, LevelFindings& found) {
  for (const auto& [family, result] : subject.families()) {
    const std::uint64_t looked_at = result.contacts->answers + (missed ? result.verdict.false_separation : 0);
    found.families[family] = {result.truth.contact, looked_at};
  }
}

std::string hits_covered(const Subject& subject) {
  std::uint64_t hits = 0;
  for (const auto& [family, result] : subject.families()) hits += result.contacts->answers;
  return fmt::format("{} contacts of {}, the time of each compared with the exact one", thousands(hits),
                     subject.list_of_families());
}

// "2.5 ulps, 1.5e-07 of the way, length 6e-07".
std::string lateness(const TimeErrors& errors) {
  const Decimal6 ulps = errors.largest_ulps.best();
  return (is_told_in_ulps(ulps) ? ulps.text() + " ulps, " : "") + way_text(errors);
}

// How late a time may be, in metres: 0 where nothing is given.
double late_argument(const AskedLevel& asked) {
  if (!asked.has_argument) return 0;
  const std::optional<double> length = length_in_metres(asked.argument);
  if (!length) {
    throw Error(fmt::format("requirement '{}': LENGTH is a length of the way in {}, as in {}=1mm", asked.text,
                            fmt::join(length_unit_names(), ", "), asked.name));
  }
  return *length;
}

LevelFindings judge_never_late(const AskedLevel& asked, const Subject& subject) {
  const double most = late_argument(asked), metres_of_unit = metres_of(subject.record().plan);
  LevelFindings found;
  found.not_checked = times_unseen(subject);
  if (!found.not_checked.empty()) return found;
  add_untimed(subject, found);
  look_at_contacts(subject, false, found);
  for (const auto& [family, result] : subject.families()) {
    const std::uint64_t missed = result.verdict.false_separation, hits = result.contacts->answers;
    if (missed > hits && found.not_checked.empty()) {
      found.not_checked = fmt::format("on {} it misses {} of {} contacts, and has to find half of them", family,
                                      thousands(missed), thousands(missed + hits));
    }
    const TimeTally& time = *result.contacts->time;
    const double length = time.late_errors.largest_length.best(), metres = length * metres_of_unit;
    if (!asked.has_argument) {
      subject.add_shown(found.failures, family, time.late,
                        "times after the first contact, the latest by " + lateness(time.late_errors), "latest time");
    } else if (metres > most) {
      // The record has the latest of those that are later, and not how many.
      subject.add_shown(found.failures, family, 1,
                        fmt::format("times after the first contact, the latest by {} of the way: {} is allowed",
                                    metric_text(metres), metric_text(most)),
                        fmt::format("latest time: {:.6g} in length", length));
    }
  }
  found.covers = hits_covered(subject);
  found.leaves_out = "missed contacts, which no-tunnel and conservative ask about";
  return found;
}

LevelFindings judge_no_tunnel(const AskedLevel& asked, const Subject& subject) {
  const double most = tunnel_argument(asked);
  LevelFindings found;
  found.not_checked = times_unseen(subject);
  if (!found.not_checked.empty()) return found;
  add_untimed(subject, found);
  look_at_contacts(subject, true, found);
  for (const auto& [family, result] : subject.families()) {
    const auto check = [&, family = family](const TunnelTally& tunnels, const char* many, const char* one,
                                            const std::string& beside, const char* shown) {
      const double deepest = tunnels.deepest.best().value();
      if (deepest < most) return;
      // The record counts those that go through; of the others it has the deepest.
      if (most == whole_radius) {
        subject.add_shown(found.failures, family, tunnels.through,
                          fmt::format("{} with which the centre comes to the triangle{}", many, beside), shown);
        return;
      }
      subject.add_shown(
          found.failures, family, 1,
          fmt::format("{} goes in by {:.6g} of the radius, and less than {} is allowed{}", one, deepest, most, beside),
          shown);
    };
    const TimeTally& time = *result.contacts->time;
    check(*result.contacts->missed, "missed contacts", "the deepest missed contact", "",
          "deepest tunnel of a missed contact");
    check(time.late_tunnels, "late times", "the deepest late time", "; the latest is by " + lateness(time.late_errors),
          "deepest tunnel of a late time");
  }
  found.covers = hits_covered(subject) + ", and every missed contact";
  found.leaves_out = "queries that these families do not make";
  return found;
}

std::string no_tunnel_sentence(const AskedLevel& asked) {
  const double most = tunnel_argument(asked);
  if (most == whole_radius) return "no missed contact and no late time with which the centre comes to the triangle";
  return fmt::format("no missed contact and no late time with which the sphere goes in by {} of its radius or more",
                     most);
}

}  // namespace

extern const GateLevel never_late_level = {
    "never-late[=LENGTH]", "no time after the first contact, or none by more than a LENGTH of the way such as 1mm",
    [](const AskedLevel& asked) {
      return "no time of contact after the exact first contact" +
             (asked.has_argument ? fmt::format(" by more than {} of the way", metric_text(late_argument(asked))) : "");
    },
    judge_never_late};

extern const GateLevel no_tunnel_level = {
    "no-tunnel[=F]", "no missed contact and no late time that tunnels by F of the radius (default 1) or more",
    no_tunnel_sentence, judge_no_tunnel};

}  // namespace axiscert

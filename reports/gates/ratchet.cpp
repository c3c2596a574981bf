#include "reports/gates/ratchet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "reports/comparison/cells.h"
#include "reports/wording/evidence.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

bool is_held(const Cell& cell) { return !cell.is_zero() && !is_error_in_u(cell); }

// The order of failures, the worst first: a promise of less, what was not checked at all, faults other than wrong
// answers, missed contacts and missing answers, late and missing times, phantom contacts, early times, then what no
// verdict shows.
constexpr int lesser_severity = 0, not_checked_severity = 1, expired_severity = 8;
int severity(const Cell& cell) {
  if (cell.kind == Cell::Kind::finding) return 2;
  if (cell.is_of_contacts()) {
    if (cell.place == "consistency" || cell.member == "flips") return 3;
    if (cell.place != "time" && cell.place != "missed") return 7;
    return cell.member == "early" ? 5 : 3;
  }
  if (cell.place != "verdict") return cell.member == "tolerance_failures" ? 6 : 7;
  if (cell.member == "undecided") return 5;
  return cell.member == "false_contact" || cell.member == "deepest_false_contact" ? 4 : 3;
}

// `key`: that of the cell, or of all cells of a kernel and precision, whose family and name are "*".
RatchetFailure failure_of(const Json& key, const std::string& kernel, const std::string& text) {
  return {fingerprint(key), kernel, key[1], key[2], key[3], text};
}

struct RankedFailure {
  RatchetFailure failure;
  int severity;
  double excess;  // by how much the figure is worse, relative to what is accepted: of two of one severity, the first
};

// The entries of one kernel, precision and waiver that fail in the same way.
using Group = std::vector<const RatchetEntry*>;

// The promise of a kernel's entry in a record; one that was edited may hold a kernel that its plan does not.
HeldPromise promise_held(const KernelRecord& kernel, const Identities& identities) {
  const auto known = identities.find(kernel.id);
  return {known == identities.end() ? kernel.id : known->second,
          std::string(name(kernel.precision)),
          promise_in(kernel),
          shown_in(kernel),
          evidence_of(kernel).promised(),
          0};
}

class Holder {
 public:
  Holder(const Ratchet& ratchet, const Record& record, std::string today)
      : ratchet_(ratchet), record_(record), identities_(identities_of(record)), today_(std::move(today)) {
    for (const auto& [id, identity] : identities_) {
      ids_[identity] = id;
      ids_[id] = id;
      if (Digests digests = digests_of(record, id); !digests.empty()) digests_[identity] = std::move(digests);
    }
    for (const KernelRecord& kernel : record.kernels) judged_.emplace(kernel.id, name(kernel.precision));
  }

  RatchetOutcome run() {
    for (const KernelRecord& kernel : record_.kernels) hold_promise(kernel);
    for (const Cell& cell : cells_of(record_)) {
      for (const std::string& known_by : {cell.identity, cell.kernel})
        shown_.insert(fingerprint(cell.key_of(known_by)));
      if (is_held(cell)) hold(cell);
    }
    for (const HeldPromise& held : ratchet_.promises) {
      if (!is_judged(held.kernel, held.precision)) hold_missing(held);
    }
    for (const auto& [fingerprint, entry] : ratchet_.entries) {
      if (!met_.contains(fingerprint)) hold_unmet(entry);
    }
    tell_groups();
    for (const auto& [kernel, digest] : ratchet_.digests) {
      const auto now = digests_.find(kernel);
      const std::string change = now == digests_.end() ? "" : digest_change(digest, now->second);
      if (!change.empty()) outcome_.changed.push_back(fmt::format("{}: {}", kernel, change));
      if (now == digests_.end()) digests_[kernel] = digest;
    }
    std::stable_sort(failures_.begin(), failures_.end(), [](const RankedFailure& x, const RankedFailure& y) {
      return x.severity != y.severity ? x.severity < y.severity : x.excess > y.excess;
    });
    for (RankedFailure& ranked : failures_) outcome_.failures.push_back(std::move(ranked.failure));
    outcome_.file = ratchet_.name;
    outcome_.plan = ratchet_.plan;
    outcome_.accepted = ratchet_file(ratchet_.plan, predicate_of(record_.plan), promises_, accepted_, digests_);
    return std::move(outcome_);
  }

 private:
  // One kernel in one precision, that the run judged.
  void hold_promise(const KernelRecord& kernel) {
    const HeldPromise now = promise_held(kernel, identities_);
    promises_.push_back(now);
    const std::string id = kernel.id, who = fmt::format("{} {}", id, now.precision);
    if (const Evidence evidence = evidence_of(kernel); evidence.population != 0 && evidence.decided() == 0) {
      fail_all(now, id,
               fmt::format("NOT CHECKED: {} decided none of its {} promised queries: no figure of it says anything",
                           who, thousands(evidence.promised())),
               not_checked_severity);
    }
    const HeldPromise* then = find_promise(ratchet_.promises, now.kernel, now.precision);
    if (then == nullptr) then = find_promise(ratchet_.promises, id, now.precision);
    if (then == nullptr) return;
    const PromiseChange change = change_of(then->promise, now.promise);
    const bool are_same = change.is_none() && then->queries == now.queries;
    std::vector<std::string> less;
    for (const Hidden& hidden : hidden_since(then->shows, now.shows, are_same)) {
      hidden_.insert({id, now.precision, hidden.name});
      if (hidden.kind != Hiding::verdicts) less.push_back(hidden.text);
      else outcome_.changed.push_back(fmt::format("{}: {}, as verdicts changed", who, hidden.text));
    }
    if (!less.empty()) {
      less_.emplace(id, now.precision);
      fail_all(now, id,
               fmt::format("{} shows less than the ratchet: {} ({}:{})", who, fmt::join(less, "; "), ratchet_.name,
                           then->line),
               lesser_severity);
    }
    if (are_same) return;
    apart_.emplace(id, now.precision);
    const std::string where = fmt::format("{} of its queries then, {} now ({}:{})", thousands(then->queries),
                                          thousands(now.queries), ratchet_.name, then->line);
    if (!change.less.empty()) {
      fail_all(now, id, fmt::format("{} promises less than the ratchet: {}: {}", who, change.text(), where),
               lesser_severity);
      return;
    }
    fail_all(now, id,
             fmt::format("NOT COMPARED: {} promises other things than the ratchet: {}{}", who,
                         change.is_none() ? "" : change.text() + ": ", where),
             not_checked_severity);
  }

  // One that the ratchet names, and the run did not judge.
  void hold_missing(const HeldPromise& held) {
    promises_.push_back(held);
    if (const auto id = ids_.find(held.kernel); id != ids_.end() && is_loaded(id->second)) {
      fail_all(held, id->second,
               fmt::format("{} {} promises less than the ratchet: it does not exist in {} any more ({}:{})", id->second,
                           held.precision, held.precision, ratchet_.name, held.line),
               lesser_severity);
    }
    not_checked_[{held.kernel, held.precision}];
  }

  // The accepted figure of a cell that is zero now, that the kernel does not show any more, or that was not judged.
  void hold_unmet(const RatchetEntry& entry) {
    check_expiry(entry);
    const std::string kernel = entry.key[0], precision = entry.key[1];
    if (!is_judged(kernel, precision)) {
      not_checked_[{kernel, precision}].push_back(&entry);
      accept(entry.key, entry.figure, entry.waiver);
    } else if (!is_finding(entry) && !shown_.contains(fingerprint(entry.key))) {
      not_shown_[{kernel, precision}].push_back(&entry);
      if (!is_hidden(ids_.at(kernel), precision, place_of(entry), member_of(entry)))
        accept(entry.key, entry.figure, entry.waiver);
    } else if (is_hidden(ids_.at(kernel), precision, place_of(entry), member_of(entry))) {
      return;  // over other answers than what is accepted
    } else if (!apart_.contains({ids_.at(kernel), precision}) || is_finding(entry)) {
      outcome_.better.push_back(fmt::format("{}: 0, accepted is {} ({}:{})", cell_text(entry.key), entry.figure.dump(),
                                            ratchet_.name, entry.line));
    }
  }
  static std::string place_of(const RatchetEntry& entry) {
    const std::string name = entry.key[3];
    return name.substr(0, name.rfind('.'));
  }
  static std::string member_of(const RatchetEntry& entry) {
    const std::string name = entry.key[3];
    return name.substr(name.rfind('.') + 1);
  }
  static bool is_finding(const RatchetEntry& entry) { return place_of(entry) == "finding"; }

  // Whether a kernel shows nothing of a place any more, or not beside the same answers: nothing is better there.
  bool is_hidden(const std::string& id, const std::string& precision, const std::string& place,
                 std::string_view member) const {
    return std::ranges::any_of(shown_of(place, member), [&](std::string_view shown) {
      return hidden_.contains({id, precision, std::string(shown)});
    });
  }

  // Ratchets of runs with two plug-ins of one name have the kernel by its id.
  const RatchetEntry* entry_of(const Cell& cell) const {
    for (const std::string& known_by : {cell.identity, cell.kernel}) {
      const auto found = ratchet_.entries.find(fingerprint(cell.key_of(known_by)));
      if (found != ratchet_.entries.end()) return &found->second;
    }
    return nullptr;
  }

  void accept(const Json& key, const Json& figure, const Waiver& waiver) {
    accepted_.push_back({key, figure, waiver, 0});
  }

  void hold(const Cell& cell) {
    const RatchetEntry* const entry = entry_of(cell);
    if (entry != nullptr) met_.insert(fingerprint(entry->key));
    const Json key = cell.key(), accepted = entry == nullptr ? Json(0) : entry->figure;
    if (cell.kind != Cell::Kind::finding && apart_.contains({cell.kernel, cell.precision})) {
      accept(key, cell.figure, open_waiver());  // over other queries than what is accepted
      return;
    }
    const std::string where = entry == nullptr ? "" : fmt::format(" ({}:{})", ratchet_.name, entry->line);
    const std::string among =
        cell.is_of_contacts() && cell.of.trials != 0 ? fmt::format(" of {}", thousands(cell.of.trials)) : "";
    const std::string text = fmt::format("{}: {}{}, accepted is {}{}", cell_text(cell.key_of(cell.kernel)),
                                         cell.figure.dump(), among, accepted.dump(), where);
    if (is_less(accepted, cell.figure)) {
      const double excess = entry == nullptr || accepted == 0 ? cell.figure.get<double>()
                                                              : cell.figure.get<double>() / accepted.get<double>();
      failures_.push_back({failure_of(key, cell.kernel, text), severity(cell), excess});
      accept(key, cell.figure, open_waiver());
    } else if (is_less(cell.figure, accepted) && less_.contains({cell.kernel, cell.precision}) &&
               is_hidden(cell.kernel, cell.precision, cell.place, cell.member)) {
      accept(key, cell.figure, open_waiver());  // over other answers than what is accepted
    } else {
      const bool is_hidden_too = is_hidden(cell.kernel, cell.precision, cell.place, cell.member);
      if (is_less(cell.figure, accepted) && !is_hidden_too) outcome_.better.push_back(text);
      accept(key, cell.figure, entry->waiver);
      if (!is_expired(*entry)) held_by(entry->waiver).push_back(fingerprint(key));
    }
    if (entry != nullptr) check_expiry(*entry);
  }

  std::vector<std::string>& held_by(const Waiver& waiver) {
    for (WaivedCells& held : outcome_.held) {
      if (held.waiver == waiver) return held.fingerprints;
    }
    return outcome_.held.emplace_back(WaivedCells{waiver, {}}).fingerprints;
  }

  bool is_expired(const RatchetEntry& entry) const {
    return entry.waiver.expiry != "never" && entry.waiver.expiry < today_;
  }
  void check_expiry(const RatchetEntry& entry) {
    if (!is_expired(entry)) return;
    expired_[{entry.key[0], entry.key[1], entry.waiver.expiry, entry.waiver.owner, entry.waiver.reason}].push_back(
        &entry);
  }

  // A finding made in loading has no precision: nothing was judged because of it, or it is gone.
  bool is_judged(const std::string& kernel, const std::string& precision) const {
    const auto id = ids_.find(kernel);
    if (id == ids_.end()) return false;
    return precision.empty() || judged_.contains({id->second, precision});
  }
  bool is_loaded(const std::string& id) const {
    return std::ranges::any_of(judged_, [&](const auto& judged) { return judged.first == id; });
  }

  // A failure of a kernel in a precision.
  void fail_all(const HeldPromise& of, const std::string& id, const std::string& text, int severity) {
    failures_.push_back({failure_of(Json::array({of.kernel, of.precision, "*", "*"}), id, text), severity, 0});
    told_.insert({of.kernel, of.precision});
  }

  // "published binary32"; a finding made in loading has no precision.
  static std::string judged_name(const Json& key) {
    const std::string kernel = key[0], precision = key[1];
    return precision.empty() ? kernel : kernel + " " + precision;
  }
  // "published binary32 on tangent: verdict.false_separation", or "312 figures of published binary32", and where.
  std::string named(const Group& group) const {
    const Json& key = group.front()->key;
    std::size_t line = group.front()->line;
    for (const RatchetEntry* entry : group) line = std::min(line, entry->line);
    return fmt::format(
        "{} ({}:{}{})",
        group.size() == 1 ? cell_text(key) : fmt::format("{} figures of {}", thousands(group.size()), judged_name(key)),
        ratchet_.name, line, group.size() == 1 ? "" : " and below");
  }
  void fail(const Group& group, const std::string& text, int severity) {
    const Json& key = group.front()->key;
    const auto id = ids_.find(key[0].get<std::string>());
    failures_.push_back({failure_of(group.size() == 1 ? key : Json::array({key[0], key[1], "*", "*"}),
                                    id == ids_.end() ? key[0].get<std::string>() : id->second, text),
                         severity, static_cast<double>(group.size())});
  }

  void tell_groups() {
    std::vector<std::string> known;
    for (const auto& [id, identity] : identities_)
      known.push_back(identity == id ? id : fmt::format("{} as {}", id, identity));
    for (const auto& [key, group] : not_checked_) {
      if (told_.contains({key[0], key[1]})) continue;
      const HeldPromise* const held = find_promise(ratchet_.promises, key[0], key[1]);
      const std::string line = held == nullptr ? "" : fmt::format(" ({}:{})", ratchet_.name, held->line);
      const std::string who = key[1].empty() ? key[0] : fmt::format("{} {}", key[0], key[1]);
      const std::string text = fmt::format(
          "NOT CHECKED: this run did not judge {}{}; the kernels of this run: {}", who,
          group.empty() ? line : fmt::format(", of which the ratchet has: {}", named(group)), fmt::join(known, ", "));
      if (!group.empty()) fail(group, text, not_checked_severity);
      else fail_all(*held, key[0], text, not_checked_severity);
    }
    for (const auto& [key, group] : not_shown_) {
      if (told_.contains({key[0], key[1]})) continue;
      fail(group, fmt::format("NOT CHECKED: this run does not show what the ratchet has: {}", named(group)),
           not_checked_severity);
    }
    for (const auto& [key, group] : expired_) {
      fail(group, fmt::format("expired on {} ({}, {}): {}", key[2], key[3], key[4], named(group)), expired_severity);
    }
  }

  const Ratchet& ratchet_;
  const Record& record_;
  Identities identities_;
  std::string today_;
  std::map<std::string, std::string> ids_;                      // of the record, by identity and by id
  std::map<std::string, Digests> digests_;                      // by identity
  std::set<std::pair<std::string, std::string>> judged_;        // ids and precisions
  std::set<std::pair<std::string, std::string>> apart_, less_;  // of these, that promise other things, or show less
  std::set<std::array<std::string, 3>> hidden_;                 // and what they show less of
  std::set<std::pair<std::string, std::string>> told_;          // as keys have them: those that fail as a whole
  std::set<std::string> met_;
  std::set<std::string> shown_;  // fingerprints of the record's cells, zeros among them
  std::map<std::array<std::string, 2>, Group> not_checked_, not_shown_;
  std::map<std::array<std::string, 5>, Group> expired_;
  std::vector<HeldPromise> promises_;
  std::vector<RatchetEntry> accepted_;
  std::vector<RankedFailure> failures_;
  RatchetOutcome outcome_;
};

}  // namespace

const HeldPromise* find_promise(const std::vector<HeldPromise>& all, const std::string& kernel,
                                const std::string& precision) {
  const auto found = std::ranges::find_if(
      all, [&](const HeldPromise& held) { return held.kernel == kernel && held.precision == precision; });
  return found == all.end() ? nullptr : &*found;
}

void require_plan(const Ratchet& ratchet, const PlanRecord& plan) {
  if (const std::string_view predicate = predicate_of(plan).id; predicate != ratchet.predicate) {
    throw Error(
        fmt::format("{}: of the predicate {}, and this run is of {}; figures of two predicates are not comparable",
                    ratchet.name, ratchet.predicate, predicate));
  }
  const std::string given = plan_fingerprint(plan);
  if (given == ratchet.plan) return;
  throw Error(fmt::format(
      "{}: belongs to plan {}, this run to {}: different families, trials, seed, files, precisions or tolerances, "
      "so the figures are not comparable; run without --ratchet and review the new ratchet.txt",
      ratchet.name, ratchet.plan, given.empty() ? "one that cannot be repeated" : given));
}

RatchetOutcome hold_against(const Ratchet& ratchet, const Record& record, const std::string& today) {
  require_plan(ratchet, record.plan);
  return Holder(ratchet, record, today).run();
}

std::string ratchet_text(const Record& record) {
  const std::string plan = plan_fingerprint(record.plan);
  if (plan.empty())
    return "# The queries of this run depended on the time available: no other run can be compared with it.\n";
  std::vector<RatchetEntry> entries;
  for (const Cell& cell : cells_of(record)) {
    if (is_held(cell)) entries.push_back({cell.key(), cell.figure, open_waiver(), 0});
  }
  const Identities identities = identities_of(record);
  std::vector<HeldPromise> promises;
  for (const KernelRecord& kernel : record.kernels) promises.push_back(promise_held(kernel, identities));
  std::map<std::string, Digests> digests;
  for (const auto& [id, identity] : identities) {
    if (Digests files = digests_of(record, id); !files.empty()) digests[identity] = std::move(files);
  }
  return ratchet_file(plan, predicate_of(record.plan), promises, entries, digests);
}

}  // namespace axiscert

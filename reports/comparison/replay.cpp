#include "reports/comparison/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

#include "exact/judge/examine.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/text/json_form.h"
#include "fuzz/files/query_line.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/record.h"
#include "kernel/plugin/load.h"
#include "reports/comparison/promise.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

// How one answer to a valid query is wrong.
struct Wrongs {
  std::vector<FlipRecord> flips;
  // A reported contact may have, besides, a time that is not safe, and a wrong feature. An early time is neither.
  std::vector<std::string> contact = {};
  std::optional<Verdict> no_verdict = {};  // the answer, where it is neither separated nor contact
  bool may_decline = false;

  bool is_none() const { return flips.empty() && contact.empty() && !no_verdict; }
  // A wrong verdict, or none where the kernel owes one.
  bool has_wrong_verdict() const {
    const auto is_verdict = [](const FlipRecord& flip) { return flip.level == Level::verdict; };
    return std::ranges::any_of(flips, is_verdict) || (no_verdict && !(no_verdict == Verdict::undecided && may_decline));
  }
  bool is_like(const Wrongs& other) const {
    return flips == other.flips && contact == other.contact && no_verdict == other.no_verdict;
  }
};

Wrongs wrongs_of(std::vector<FlipRecord> flips, const std::optional<MeasuresRecord>& measures, Verdict verdict,
                 bool may_decline) {
  Wrongs found{std::move(flips)};
  found.may_decline = may_decline;
  if (verdict != Verdict::separated && verdict != Verdict::contact) found.no_verdict = verdict;
  if (!measures) return found;
  const std::optional<TimeVerdict> time = measures->time.value_or(std::nullopt);
  if (time == TimeVerdict::late || time == TimeVerdict::none || time == TimeVerdict::invalid)
    found.contact.push_back(fmt::format("time {}", name(*time)));
  if (measures->feature_is_right.value_or(std::nullopt) == false) found.contact.emplace_back("feature wrong");
  const std::optional<Consistency> consistency = measures->consistency.value_or(std::nullopt);
  if (consistency && *consistency != Consistency::consistent)
    found.contact.emplace_back(consistency_words[*consistency]);
  if (measures->is_flip.value_or(std::nullopt) == true) found.contact.emplace_back("normal flipped");
  return found;
}

ReplayOutcome outcome_of(const Wrongs& before, const Wrongs& now) {
  const bool is_new_in_contact = std::any_of(now.contact.begin(), now.contact.end(), [&](const std::string& what) {
    return std::find(before.contact.begin(), before.contact.end(), what) == before.contact.end();
  });
  if (!before.has_wrong_verdict() && (now.has_wrong_verdict() || is_new_in_contact)) return ReplayOutcome::wrong_now;
  if (before.is_like(now)) return ReplayOutcome::as_before;
  if (now.no_verdict && !before.no_verdict) return ReplayOutcome::no_verdict;
  return now.is_none() ? ReplayOutcome::mended : ReplayOutcome::changed;
}

std::string wrongs_text(const Wrongs& wrongs) {
  std::vector<std::string> texts = wrongs.contact;
  if (wrongs.no_verdict) texts.emplace_back(name(*wrongs.no_verdict));
  for (const FlipRecord& flip : wrongs.flips) {
    std::vector<std::string_view> links;
    for (const Link link : flip.links) links.push_back(name(link));
    const std::string& place = flip.name;
    texts.push_back(fmt::format("{} {} [{}]", place, name(flip.kind), fmt::join(links, ", ")));
  }
  return texts.empty() ? "no flip" : fmt::format("{}", fmt::join(texts, "; "));
}

// One kernel of the record, started once; where that is not possible, `absent` says why.
struct ReplayKernel {
  std::unique_ptr<Examiner> examiner;
  const Kernel* kernel = nullptr;
  std::string absent;

  ReplayKernel(const std::string& id, std::string_view target, const TrustedPlugins& trusted) {
    const auto named = trusted.find(id);
    if (plugin::is_given_by_file(id) && named == trusted.end()) {
      const bool is_program = id.starts_with(plugin::by_manifest);
      absent = fmt::format("a {} that a record names is {} only with --kernel {}", is_program ? "program" : "plug-in",
                           is_program ? "started" : "loaded", shell_word(id));
      return;
    }
    try {
      kernel = &find_kernel(named == trusted.end() ? id : named->second);
      require_loaded(*kernel);
      examiner = std::make_unique<Examiner>(*kernel, target);
    } catch (const Error& none) {
      absent = none.what();
      kernel = nullptr;
    }
  }

  // The kernel's answer now, and whether it was to be right: under the promise of OLD, and under its own here. It takes
  // this query.
  struct ReplayedAnswer {
    Wrongs wrongs;
    bool was_promised = true, is_promised = true;
  };
  ReplayedAnswer on(const StoredQuery& stored, const Promise& then) const {
    const Promise now = promise_of_kernel(*kernel);
    const auto is_within_promise = [&](const Promise& p, bool is_touching) {
      if (is_touching && p.touching == TouchingPolicy::either) return false;
      const MotionPolicy motion = p.motion.value_or(MotionPolicy{});
      return std::visit([&](const auto& q) { return is_promised(oracles_of(*kernel), p.limits, motion, q); },
                        stored.numbers);
    };
    const Examination found = std::visit([&](const auto& q) { return examiner->examine(q); }, stored.numbers);
    ReplayedAnswer all{wrongs_of(flips_of(*kernel->predicate, found.judgement), measures_of(*kernel->predicate, found),
                                 found.answer.verdict, kernel->may_decline)};
    all.was_promised = is_within_promise(then, found.truth.touching);
    all.is_promised = is_within_promise(now, found.truth.touching);
    return all;
  }
};

// The promise that a record states of a witness's kernel; a record that was edited may not have it.
Promise promise_in_record(const Record& record, const WitnessRecord& witness) {
  for (const KernelRecord& entry : record.kernels) {
    if (entry.id == witness.kernel && entry.precision == witness.precision) return promise_in(entry);
  }
  return {};
}

// Why a kernel does not take a query that it took; empty where it does.
std::string refusal(const Kernel& kernel, const StoredQuery& stored) {
  if (!kernel.has(stored.precision)) return fmt::format("it does not exist in {} here", name(stored.precision));
  if (kernel.predicate == stored.predicate && kernel.entry == stored.entry) return "";
  return fmt::format("it takes the entry {} of the predicate {} here", kernel.predicate->entries[kernel.entry].name,
                     kernel.predicate->id);
}

}  // namespace

std::vector<ReplayedQuery> replay_witnesses(const Record& record, std::string_view target,
                                            const TrustedPlugins& trusted) {
  const Predicate& predicate = predicate_of(record.plan);
  std::map<std::string, ReplayKernel> kernels;
  std::vector<ReplayedQuery> all;
  for (const WitnessRecord& witness : record.witnesses) {
    ReplayedQuery& replayed =
        all.emplace_back(ReplayedQuery{witness.id, witness.kernel, std::string(name(witness.precision)), witness.family,
                                       ReplayOutcome::not_replayed, ""});
    if (record.plan.replies) {
      replayed.note = "its answers came through a pipe";
      continue;
    }
    Json line = json_of(witness);
    line["predicate"] = predicate.id;
    const StoredQuery stored = query_of_json(line.dump(), Place{"witness " + replayed.id, 1});
    const ReplayKernel& asked = kernels.try_emplace(replayed.kernel, replayed.kernel, target, trusted).first->second;
    if (asked.kernel == nullptr) {
      replayed.note = asked.absent;
      continue;
    }
    if (const std::string why = refusal(*asked.kernel, stored); !why.empty()) {
      replayed.outcome = ReplayOutcome::not_promised;
      replayed.note = why;
      continue;
    }
    const Promise then = promise_in_record(record, witness);
    const Wrongs before =
        wrongs_of(witness.flips, witness.measures.value_or(std::nullopt), witness.computed, then.may_decline);
    const ReplayKernel::ReplayedAnswer said = asked.on(stored, then);
    if (said.was_promised && !said.is_promised) {
      replayed.outcome = ReplayOutcome::not_promised;
      replayed.note = change_of(then, promise_of_kernel(*asked.kernel)).text();
      continue;
    }
    replayed.outcome = outcome_of(before, said.wrongs);
    if (replayed.outcome != ReplayOutcome::as_before) replayed.note = wrongs_text(said.wrongs);
  }
  return all;
}

}  // namespace axiscert

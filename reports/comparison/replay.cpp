#include "reports/comparison/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

#include "exact/sphere_triangle/claims/examine.h"
#include "exact/trait/examine.h"
#include "fuzz/confirm/motion_record.h"
#include "fuzz/files/query_line.h"
#include "fuzz/files/sphere_triangle_query.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/finding_record.h"
#include "fuzz/confirm/record.h"
#include "kernel/plugin/load.h"
#include "kernel/sphere_triangle/description.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

// How one answer is wrong.
struct Wrongs {
  Json flips;
  // A reported contact may have, besides, a time that is not safe, and a wrong feature. An early time is neither.
  std::vector<std::string> contact;

  bool is_none() const { return flips.empty() && contact.empty(); }
  bool operator==(const Wrongs&) const = default;
};

Wrongs wrongs_of(const Json& flips, const Json& measures) {
  Wrongs found{flips, {}};
  if (!measures.is_object()) return found;
  const auto time = measures.find("time");
  if (time != measures.end() && (*time == "late" || *time == "none" || *time == "invalid"))
    found.contact.push_back(fmt::format("time {}", time->get<std::string>()));
  const auto feature = measures.find("feature_is_right");
  if (feature != measures.end() && *feature == false) found.contact.emplace_back("feature wrong");
  return found;
}

bool has_wrong_verdict(const Wrongs& wrongs) {
  return std::any_of(wrongs.flips.begin(), wrongs.flips.end(),
                     [](const Json& flip) { return flip["level"] == "verdict"; });
}

ReplayOutcome outcome_of(const Wrongs& before, const Wrongs& now) {
  const bool is_new_in_contact = std::any_of(now.contact.begin(), now.contact.end(), [&](const std::string& what) {
    return std::find(before.contact.begin(), before.contact.end(), what) == before.contact.end();
  });
  if (!has_wrong_verdict(before) && (has_wrong_verdict(now) || is_new_in_contact)) return ReplayOutcome::wrong_now;
  if (before == now) return ReplayOutcome::as_before;
  return now.is_none() ? ReplayOutcome::mended : ReplayOutcome::changed;
}

std::string wrongs_text(const Wrongs& wrongs) {
  std::vector<std::string> texts = wrongs.contact;
  for (const Json& flip : wrongs.flips) {
    texts.push_back(fmt::format("{} {} [{}]", flip["name"].get<std::string>(), flip["kind"].get<std::string>(),
                                fmt::join(flip["links"].get<std::vector<std::string>>(), ", ")));
  }
  return texts.empty() ? "no flip" : fmt::format("{}", fmt::join(texts, "; "));
}

// One kernel of the record, started once; where that is not possible, `absent` says why.
struct Asked {
  std::unique_ptr<Examiner> examiner;  // of sphere-triangle; the other of any other test
  std::unique_ptr<OracleExaminer> oracle_examiner;
  const Kernel* kernel = nullptr;
  std::string absent;

  Asked(const std::string& id, std::string_view target, const TrustedPlugins& trusted) {
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
      if (kernel->test == &sphere_triangle_test()) examiner = std::make_unique<Examiner>(*kernel, target);
      else oracle_examiner = std::make_unique<OracleExaminer>(*kernel, target);
    } catch (const Error& none) {
      absent = none.what();
      kernel = nullptr;
    }
  }

  // The kernel takes this query.
  Wrongs wrongs_on(const StoredQuery& stored) const {
    if (examiner) {
      const Examination found =
          std::visit([&](const auto& q) { return examiner->examine(q); }, sphere_triangle_query(stored));
      return wrongs_of(flips_json(*kernel->test, found.judgement), nullptr);
    }
    const OracleExamination found =
        std::visit([&](const auto& q) { return oracle_examiner->examine(q); }, stored.numbers);
    return wrongs_of(flips_json(*kernel->test, found.judgement), measures_json(*kernel->test, found));
  }
};

}  // namespace

std::vector<Replayed> replay_witnesses(const Json& record, std::string_view target, const TrustedPlugins& trusted) {
  const TestDescription& test = test_of(record["plan"]);
  std::map<std::string, Asked> kernels;
  std::vector<Replayed> all;
  for (const Json& witness : record["witnesses"]) {
    Replayed& replayed = all.emplace_back(Replayed{witness["id"], witness["kernel"], witness["precision"],
                                                   witness["family"], ReplayOutcome::not_replayed, ""});
    if (record["plan"].contains("replies")) {
      replayed.note = "its answers came through a pipe";
      continue;
    }
    Json line = witness;
    line["test"] = test.id;
    const StoredQuery stored = query_of_json(line.dump(), Place{"witness " + replayed.id, 1});
    const Asked& asked = kernels.try_emplace(replayed.kernel, replayed.kernel, target, trusted).first->second;
    if (asked.kernel == nullptr || !asked.kernel->has(stored.precision)) {
      replayed.note = asked.kernel ? fmt::format("{} does not exist in {} here", replayed.kernel, replayed.precision)
                                   : asked.absent;
      continue;
    }
    if (asked.kernel->test != stored.test || asked.kernel->entry != stored.entry) {
      replayed.note = fmt::format("{} takes the entry {} of the test {} here", replayed.kernel,
                                  asked.kernel->test->entries[asked.kernel->entry].name, asked.kernel->test->id);
      continue;
    }
    const Wrongs before = wrongs_of(witness["flips"], witness.value("measures", Json())), now = asked.wrongs_on(stored);
    replayed.outcome = outcome_of(before, now);
    if (replayed.outcome != ReplayOutcome::as_before) replayed.note = wrongs_text(now);
  }
  return all;
}

}  // namespace axiscert

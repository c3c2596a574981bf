#include "reports/comparison/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

#include "exact/sphere_triangle/claims/examine.h"
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

bool is_wrong(const Json& flips) {
  return std::any_of(flips.begin(), flips.end(), [](const Json& flip) { return flip["level"] == "verdict"; });
}

ReplayOutcome outcome_of(const Json& before, const Json& now) {
  if (is_wrong(now) && !is_wrong(before)) return ReplayOutcome::wrong_now;
  if (before == now) return ReplayOutcome::as_before;
  return now.empty() ? ReplayOutcome::mended : ReplayOutcome::changed;
}

std::string flips_text(const Json& flips) {
  std::vector<std::string> texts;
  for (const Json& flip : flips) {
    texts.push_back(fmt::format("{} {} [{}]", flip["name"].get<std::string>(), flip["kind"].get<std::string>(),
                                fmt::join(flip["links"].get<std::vector<std::string>>(), ", ")));
  }
  return texts.empty() ? "no flip" : fmt::format("{}", fmt::join(texts, "; "));
}

// One kernel of the record, started once; where that is not possible, `absent` says why.
struct Asked {
  std::unique_ptr<Examiner> examiner;
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
      examiner = std::make_unique<Examiner>(*kernel, target);
    } catch (const Error& none) {
      absent = none.what();
    }
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
    if (&test != &sphere_triangle_test()) {
      replayed.note = fmt::format("witnesses of the test {} are not evaluated again yet", test.id);
      continue;
    }
    const std::string line = witness.dump();
    const StoredQuery stored = query_of_json(line, Place{"witness " + replayed.id, 1});
    Asked& asked = kernels.try_emplace(replayed.kernel, replayed.kernel, target, trusted).first->second;
    if (asked.examiner == nullptr || !asked.kernel->has(stored.precision)) {
      replayed.note = asked.examiner ? fmt::format("{} does not exist in {} here", replayed.kernel, replayed.precision)
                                     : asked.absent;
      continue;
    }
    const Examination found =
        std::visit([&](const auto& q) { return asked.examiner->examine(q); }, sphere_triangle_query(stored));
    const Json now = flips_json(*asked.kernel->test, found.judgement);
    replayed.outcome = outcome_of(witness["flips"], now);
    if (replayed.outcome != ReplayOutcome::as_before) replayed.note = flips_text(now);
  }
  return all;
}

}  // namespace axiscert

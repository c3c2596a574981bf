#include "cli/judged_run.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>

#include "cli/commands.h"
#include "cli/run_output.h"
#include "fuzz/campaign.h"
#include "kernel/error.h"
#include "kernel/self_check.h"
#include "reports/render.h"
#include "reports/requirement.h"

namespace axiscert {
int judged_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked) {
  const RunFolder folder(output.out);
  require_uncontracted(scalar_target);
  require_uncontracted(plan.target);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  const auto started = std::chrono::system_clock::now();
  CampaignResult result;
  try {
    ProgressLine progress;
    result = run_campaign(plan, interrupted, [&](const Progress& p) { progress.show(p); });
  } catch (const OracleDisagreement& disagreement) {
    throw HarnessFault(fmt::format("{}; the query is saved in {}", disagreement.what(), folder.save(disagreement)));
  }
  if (plan.planted != FilterFault::none) {
    throw HarnessFault(fmt::format("--plant {}: the cross-checks did not find it in this run",
                                   filter_fault_names[static_cast<std::size_t>(plan.planted)]));
  }
  const double seconds = std::chrono::duration<double>(std::chrono::system_clock::now() - started).count();
  const Json record = record_of(plan, result, output.require);
  folder.write("record.json", record);
  folder.write("run.json", run_info(plan, result, target_asked, iso_time(started), seconds));
  render_reports(output.out);

  fmt::print("{}{}/report.html\n", summary_text(record, seconds), output.out);
  if (!result.complete) return exit_interrupted;
  if (output.require.empty()) return exit_done;
  const auto failures = unmet(record, output.require);
  for (const auto& failure : failures)
    fmt::print(stderr, "axiscert: --require {}: {}\n", output.require, failure.text());
  return failures.empty() ? exit_done : exit_requirement_failed;
}

}  // namespace axiscert

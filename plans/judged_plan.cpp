#include "plans/judged_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <filesystem>
#include <span>

#include "fuzz/campaign/distribute.h"
#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/journal.h"
#include "fuzz/confirm/cause.h"
#include "fuzz/confirm/record.h"
#include "fuzz/diagnosis/beside_runs.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/registry/self_check.h"
#include "reports/gates/ratchet.h"
#include "reports/gates/requirement.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

namespace fs = std::filesystem;

// "FILE:LINE"; nothing where the text is not of that form.
std::optional<SourcePlace> place_of(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos || colon == 0 || !is_utf8(text)) return std::nullopt;
  std::uint32_t line = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + colon + 1, end, line);
  if (problem != std::errc() || stop != end || line == 0) return std::nullopt;
  fs::path file = fs::path(text.substr(0, colon)).lexically_normal();
  std::error_code none;
  if (const fs::path inside = file.lexically_relative(fs::current_path(none));
      file.is_absolute() && !inside.empty() && *inside.begin() != "..")
    file = inside;
  return SourcePlace{file.string(), line};
}

}  // namespace

SourcePlaces source_places(const std::vector<const Kernel*>& kernels, const std::vector<std::string>& given) {
  SourcePlaces places;
  for (const Kernel* kernel : kernels) {
    if (const auto own = place_of(kernel->source)) places.put(kernel->id) = *own;
  }
  for (const std::string& value : given) {
    std::vector<std::string> about;  // the kernels that the value names, or all of them
    std::string where = value;
    for (const Kernel* kernel : kernels) {
      if (value.starts_with(kernel->id + "=")) {
        about = {kernel->id};
        where = value.substr(kernel->id.size() + 1);
        break;
      }
      about.push_back(kernel->id);
    }
    const auto place = place_of(where);
    if (!place) {
      throw Error(fmt::format(
          "--source {}: give FILE:LINE, as in src/my_kernel.c:12, or KERNEL=FILE:LINE for one kernel", value));
    }
    if (!fs::is_regular_file(where.substr(0, where.rfind(':')))) {
      throw Error(fmt::format(
          "--source {}: there is no file {}; give a path from the folder in which axiscert runs, or "
          "KERNEL=FILE:LINE with a kernel of this run: {}",
          value, where.substr(0, where.rfind(':')),
          fmt::join(most_alike_first(where.substr(0, where.find('=')), {about.begin(), about.end()}), ", ")));
    }
    for (const std::string& id : about) places.put(id) = *place;
  }
  return places;
}

HarnessFault save_disagreement(const OutputFolder& folder, const OracleDisagreement& disagreement) {
  return HarnessFault(fmt::format("{}; the query is saved in {}", disagreement.what(), folder.save(disagreement)));
}

void run_stretches(const Plan& plan, const Stretches& stretches, const std::vector<std::uint64_t>& numbers,
                   const std::atomic<bool>& interrupted, const ShowProgress& show,
                   const std::function<void(const Entry&)>& done) {
  Crew crew(plan.running.threads, [&](Task task) { return encode(run_stretch(plan, stretches, task)); });
  Distributor distributor(crew, nullptr);
  ProgressCount count(show, numbers.size());
  auto next = numbers.begin();
  distributor.run({[&]() -> std::optional<Task> {
                     return next == numbers.end() || interrupted ? std::nullopt : std::optional<Task>(*next++);
                   },
                   [&] { return static_cast<std::uint64_t>(numbers.end() - next); },
                   [&](const TaskResult& result) {
                     const Entry entry = decode_entry(result.bytes);
                     done(entry);
                     count.finish_unit(stretches.at(entry.stretch).queries);
                   }});
}

namespace {

CampaignResult kept_campaign(const Plan& plan, const Keeping& keeping, const std::atomic<bool>& interrupted,
                             const ShowProgress& show, const OutputFolder& folder) {
  const Stretches stretches(plan.questions, Stretches::default_units_each(plan.questions));
  GatheredStretches gathered(plan.questions, plan.answerers.kernels.size(), stretches);
  if (!keeping.resumes) folder.remove(journal_file);
  const std::string of = json_of(plan_record(plan)).dump() + keeping.code;
  std::optional<Journal> journal;
  try {
    journal.emplace(folder.path(journal_file), sha256_hex(std::as_bytes(std::span(of))),
                    [&](std::string_view content) { gathered.replay(content); });
  } catch (const Error& wrong) {
    throw Error(fmt::format("{}; give another folder, or begin again without --resume", wrong.what()));
  }
  run_stretches(plan, stretches, gathered.missing(), interrupted, show, [&](const Entry& entry) {
    journal->append(encode(entry));
    gathered.add(entry);
  });
  journal->sync();
  return std::move(gathered).take();
}

}  // namespace

CampaignResult judge_plan(const Plan& plan, const std::atomic<bool>& interrupted, const ShowProgress& show,
                          const OutputFolder* folder, const Keeping* keeping) {
  for (const std::string& target : targets_of(plan.answerers.kernels, plan.running.target))
    require_uncontracted(target);
  CampaignResult result;
  try {
    result = keeping == nullptr ? run_campaign(plan, interrupted, show)
                                : kept_campaign(plan, *keeping, interrupted, show, *folder);
  } catch (const OracleDisagreement& disagreement) {
    if (folder == nullptr) throw;
    throw save_disagreement(*folder, disagreement);
  }
  if (plan.judging.planted != FilterFault::none) {
    throw HarnessFault(fmt::format("--plant {}: the cross-checks did not find it in this run",
                                   filter_fault_names[plan.judging.planted]));
  }
  return result;
}

RunFiles run_files(const Plan& plan, const CampaignResult& result, const OutputOptions& output,
                   const std::string& target_asked, std::chrono::system_clock::time_point started,
                   const BeginStage& begin_stage, std::optional<RunScale> scale) {
  const double seconds = std::chrono::duration<double>(std::chrono::system_clock::now() - started).count();
  const auto begin = [&](std::string_view stage) {
    if (begin_stage) begin_stage(stage);
  };
  begin("the witnesses are confirmed");
  RunFiles run{record_of(plan, result, output.required),
               run_info(plan, result, target_asked, iso_time(started), seconds)};
  begin("the causes are looked for");
  put_causes(run.record, plan, result);
  begin("other units of length are asked");
  put_windows(run.record, plan, result);
  run.info.scale = std::move(scale);
  run.info.sources = source_places(plan.answerers.kernels, output.sources);
  return run;
}

std::vector<LevelOutcome> write_run(const OutputFolder& folder, const RunFiles& run) {
  for (const char* file : {ratchet_outcome_file, shrunk_file}) folder.remove(file);
  folder.write("record.json", json_of(run.record));
  std::vector<LevelOutcome> outcomes = outcomes_of(run.record);
  folder.write("run.json", json_of(RunFile{run.info, outcomes.empty() ? std::nullopt : std::optional(outcomes)}));
  return outcomes;
}

}  // namespace axiscert

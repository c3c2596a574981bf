#include "cli/commands.h"
#include "cli/options/reply_plan.h"
#include "cli/options/require_options.h"
#include "cli/progress_line.h"
#include "cli/running/judged_run.h"

namespace axiscert {
namespace {

struct JudgeOptions : OutputOptions, ReplyOptions {};

int judge_replies(const JudgeOptions& options) {
  std::optional<ProgressLine> reading(std::in_place, "judge: the replies are read", options.quiet);
  ReplyPlan replies = reply_plan(options);
  reading.reset();
  replies.plan.running.threads = threads_of(options.threads);
  check_required(options.required, replies.plan);
  return put_result(judge_run(replies.plan, options, replies.plan.running.target), options);
}

}  // namespace

void add_judge(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "judge", "Judge a program's replies to the queries of `generate --binary` and write a report as `run` does");
  auto options = std::make_shared<JudgeOptions>();
  command->add_option("FILE", options->replies, "reply files, one for each precision; - for standard input")
      ->capture_default_str();
  add_reply_options(*command, *options);
  add_output_options(*command, *options);
  command->callback([&action, options] { action = [options] { return judge_replies(*options); }; });
}

}  // namespace axiscert

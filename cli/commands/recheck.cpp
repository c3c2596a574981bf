#include "cli/commands/planned_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#include "cli/commands/run_output.h"
#include "cli/progress_line.h"
#include "fuzz/campaign/gathered.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

namespace fs = std::filesystem;

// Runs a program to its end, without standard output and without the environment variables in which a launcher
// addressed this rank. Throws Error where it cannot be started or fails.
void run_program(const std::vector<std::string>& command) {
  std::vector<char*> arguments, environment;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    const bool is_of_launcher = text.starts_with("OMPI_") || text.starts_with("PMI") || text.starts_with("SLURM_STEP_");
    if (!is_of_launcher) environment.push_back(*variable);
  }
  environment.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int problem = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) {
    throw Error(fmt::format("--recheck-with {}: cannot be started: {}", command[0], std::strerror(problem)));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw Error(fmt::format("--recheck-with {}: failed on the sample (exit status {}); its own message is above",
                          command[0], WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)));
}

// A folder next to the journal that exists as long as this object.
class Scratch {
 public:
  explicit Scratch(const std::string& out) : path_(fs::path(out) / "recheck") { fs::remove_all(path_); }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

void do_with_another_build(const std::string& program, const PlanFile& file, const RecheckedRun& run,
                           const std::vector<std::uint64_t>& sample, Recheck& recheck) {
  const Scratch scratch(run.output.out);
  const OutputFolder folder(scratch.path());
  std::string numbers;
  for (const std::uint64_t stretch : sample) numbers += fmt::format("{}\n", stretch);
  folder.write_text("stretches", numbers);
  run_program({program, "run", "--plan", file.path, "--stretches", scratch.path() + "/stretches", "--out",
               scratch.path(), "--threads", std::to_string(run.on.threads)});
  read_journal(scratch.path() + "/" + journal_file, file.digest, [&](std::string_view content) {
    if (const auto entry = finished_in(content)) recheck.add_again(*entry);
  });
}

}  // namespace

std::string recheck_target(const PlannedOptions& options, const std::string& first) {
  if (!options.recheck_target.empty()) return resolve_target(options.recheck_target);
  return first == scalar_target ? resolve_target("auto") : std::string(scalar_target);
}

void recheck(const PlannedOptions& options, const PlanFile& file, const RecheckedRun& run, Distributor& distributor) {
  std::vector<std::uint64_t> finished;
  read_journal(run.journal, file.digest, [&](std::string_view content) {
    if (const auto entry = finished_in(content)) finished.push_back(entry->stretch);
  });
  std::sort(finished.begin(), finished.end());
  const std::uint64_t seed = options.recheck_seed ? *options.recheck_seed : std::random_device()();
  const std::vector<std::uint64_t> sample = sample_of(finished, options.recheck, seed);
  Recheck compared(run.kernels, run.stretches, sample);
  read_journal(run.journal, file.digest, [&](std::string_view content) {
    if (const auto entry = finished_in(content); entry && compared.is_in(entry->stretch)) compared.add_first(*entry);
  });

  const std::string another =
      options.recheck_with.empty() ? "on " + recheck_target(options, run.on.target) : "by " + options.recheck_with;
  if (!options.recheck_with.empty()) do_with_another_build(options.recheck_with, file, run, sample, compared);
  else {
    ProgressLine progress("--recheck", run.output.quiet);
    const ShowProgress show = progress.report();
    ProgressCount count(show, sample.size());
    auto next = sample.begin();
    distributor.run({[&]() -> std::optional<Task> {
                       return next == sample.end() ? std::nullopt : std::optional(task_of(*next++, true));
                     },
                     [&] { return static_cast<std::uint64_t>(sample.end() - next); },
                     [&](const TaskResult& result) {
                       compared.add_again(decode_entry(result.bytes));
                       count.finish_unit();
                     }});
  }
  if (!compared.differences().empty()) {
    const std::size_t others = compared.differences().size() - 1;
    throw HarnessFault(fmt::format("--recheck: {}{} ({}; --recheck-seed {} takes the same sample)",
                                   compared.differences().front(),
                                   others == 0 ? "" : fmt::format("; {} more differ", others), another, seed));
  }
  if (compared.compared() != sample.size()) {
    throw HarnessFault(
        fmt::format("--recheck: {} of {} stretches were done again", compared.compared(), sample.size()));
  }
  fmt::print("recheck: {} of {} stretches done again {}, every tally the same (--recheck-seed {})\n", sample.size(),
             finished.size(), another, seed);
}

}  // namespace axiscert

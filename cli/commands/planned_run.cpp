#include "cli/commands/planned_run.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "cli/commands.h"
#include "cli/commands/judged_run.h"
#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "fuzz/campaign/distribute.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "plans/notices.h"

namespace axiscert {
Selection shard_of(const std::string& given) {
  std::uint64_t shard = 0, shards = 0;
  char slash = 0;
  std::istringstream text(given);
  const bool is_pair = given.find_first_not_of("0123456789/") == given.npos && (text >> shard >> slash >> shards) &&
                       slash == '/' && text.peek() == std::istringstream::traits_type::eof();
  if (!is_pair || shard < 1 || shard > shards) {
    throw Error(fmt::format("--shard {}: give I/N with I from 1 to N: 3/8 is the third of eight", given));
  }
  return [=](std::uint64_t stretch) { return stretch % shards == shard - 1; };
}

namespace {

namespace fs = std::filesystem;

// Seconds between syncs of the journal to the disk itself: a kill loses nothing that was appended, a power cut at most
// what was appended since the last sync.
constexpr double seconds_between_syncs = 10;

Selection listed_in(const std::string& file, std::uint64_t count) {
  std::istringstream text(read_bytes(file));
  std::set<std::uint64_t> numbers;
  for (std::uint64_t number = 0; text >> number;) numbers.insert(number);
  if (!text.eof() || numbers.empty() || *numbers.rbegin() >= count) {
    throw Error(
        fmt::format("--stretches {}: give a file with numbers of stretches, one in each line, below {}", file, count));
  }
  return [=](std::uint64_t stretch) { return numbers.contains(stretch); };
}

// The work of rank 0.
class Lead {
 public:
  Lead(const PlannedOptions& options, const OutputOptions& output, const PlanFile& file, const Plan& plan,
       const Stretches& stretches, Crew& crew, Ranks* ranks)
      : options_(options),
        output_(output),
        file_(file),
        plan_(plan),
        stretches_(stretches),
        ratchet_(ratchet_of(output, plan)),
        folder_(output.out),
        gathered_(plan.questions, plan.answerers.kernels.size(), stretches),
        ranks_(ranks),
        distributor_(crew, ranks),
        is_whole_(options.shard.empty() && options.stretches.empty()),
        is_selected_([](std::uint64_t) { return true; }) {
    source_places(plan.answerers.kernels, output.sources);  // refuses what cannot be one, before anything runs
    if (!is_whole_ && output.format != "text")
      throw Error("--format csv: a part of a plan has no record; `axiscert merge` makes that of all parts");
    if (!options.shard.empty()) is_selected_ = shard_of(options.shard);
    if (!options.stretches.empty()) is_selected_ = listed_in(options.stretches, stretches.count());
  }

  int run(const std::string& target_asked) {
    open_journal();
    const auto started = std::chrono::system_clock::now();
    std::vector<RankUse> uses;
    try {
      do_what_is_missing();
      if (options_.recheck > 0 && !interrupted_) {
        recheck(options_, file_, {plan_.answerers.kernels, plan_.running, stretches_, path(journal_file), output_},
                distributor_);
      }
      uses = distributor_.finish();
    } catch (const OracleDisagreement& disagreement) {
      throw save_disagreement(folder_, disagreement);
    }
    journal_->sync();
    print_rank_uses(uses);
    if (!is_whole_) return print_part();
    // Stretches done by another process of the same plan are not counted: no rank of this run did them.
    const RunScale scale{file_.digest, stretches_.count(), stretches_.units_each(), lost_, journal_->bytes(), uses};
    return put_result(
        {folder_, ratchet_, shown_run_files(plan_, std::move(gathered_).take(), output_, target_asked, started, scale)},
        output_);
  }

 private:
  std::string path(const char* file) const { return (fs::path(output_.out) / file).string(); }

  void open_journal() {
    const std::string journal = path(journal_file);
    if (!options_.resume && fs::exists(journal)) {
      throw Error(fmt::format("{}: already exists; --resume continues it, or give another folder", journal));
    }
    journal_.emplace(journal, file_.digest, [this](std::string_view content) { gathered_.replay(content); });
    say_what_is_kept("");
    folder_.write_text(plan_copy, file_.text());
    if (!options_.shard.empty()) folder_.write_text(shard_file, options_.shard + "\n");
    if (journal_->torn() != 0) {
      fmt::print(stderr,
                 "axiscert: {}: its last entry was cut off while it was being written: {} bytes dropped, and done "
                 "again\n",
                 journal, journal_->torn());
    }
    lost_ = gathered_.lost_units();
    if (options_.resume) {
      fmt::print(stderr, "axiscert: {}: {} of {} units are done; units lost on the way: {}\n", journal,
                 gathered_.units(), stretches_.units(), lost_);
    }
    for (std::uint64_t stretch = 0; stretch < stretches_.count(); ++stretch) {
      left_ += is_selected_(stretch) && !gathered_.has(stretch);
    }
  }

  // What is appended stays; a launcher starts all ranks again.
  void say_what_is_kept(const std::string& time) const {
    const std::string launcher = ranks_ != nullptr ? fmt::format("mpirun -n {} ", ranks_->size()) : "";
    keep_work(fmt::format("the stretches that are done are in {}{}", path(journal_file), time),
              launcher + own_command("--resume"));
  }

  // The command that goes on has what is left of --time, and nothing of it where that is over.
  void say_what_is_left(double seconds) {
    if (!options_.seconds || is_told_) return;
    is_told_ = true;
    const double left = std::ceil(*options_.seconds - seconds);
    set_own_option("--time", left > 0 ? fmt::format("{:.0f}", left) : "");
    say_what_is_kept(left > 0 ? fmt::format(", and {:.0f} s of --time are left", left)
                              : ", and --time is over: the rest is done without it");
  }

  std::optional<Task> next() {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - began_;
    if (interrupted_ || (options_.seconds && since.count() > *options_.seconds)) {
      say_what_is_left(since.count());
      return std::nullopt;
    }
    for (; next_ < stretches_.count(); ++next_) {
      if (!is_selected_(next_) || gathered_.has(next_)) continue;
      journal_->append(begun_note(next_));
      --left_;
      return task_of(next_++, false);
    }
    return std::nullopt;
  }

  void do_what_is_missing() {
    ProgressLine progress("judging", output_.quiet);
    const std::uint64_t units_before = gathered_.units(), queries_before = gathered_.queries();
    std::uint64_t units_to_do = 0;
    for (const std::uint64_t stretch : gathered_.missing()) {
      if (is_selected_(stretch)) units_to_do += stretches_.at(stretch).units();
    }
    const std::string lost = lost_ == 0 ? "" : fmt::format("; {} units lost before and done again", lost_);
    const auto start = std::chrono::steady_clock::now();
    double synced = 0;
    distributor_.run({[this] { return next(); }, [this] { return left_; },
                      [&](const TaskResult& result) {
                        gathered_.add(decode_entry(result.bytes));
                        journal_->append(result.bytes);
                        const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start;
                        if (now.count() - synced > seconds_between_syncs) {
                          journal_->sync();
                          synced = now.count();
                        }
                        progress.show({gathered_.units() - units_before, units_to_do,
                                       gathered_.queries() - queries_before, now.count()},
                                      lost);
                      }});
  }

  static void print_rank_uses(const std::vector<RankUse>& uses) {
    if (uses.size() == 1) return;
    for (std::size_t rank = 0; rank < uses.size(); ++rank) {
      fmt::print(stderr, "axiscert: rank {}: {} stretches on {} thread{}, {:.1f} MiB at most\n", rank, uses[rank].tasks,
                 uses[rank].threads, uses[rank].threads == 1 ? "" : "s",
                 static_cast<double>(uses[rank].peak_memory) / 0x1p20);
    }
  }

  int print_part() const {
    fmt::print("{}: {} of the plan's {} units; `axiscert merge` joins the parts\n", path(journal_file),
               gathered_.units(), stretches_.units());
    if (interrupted_) return interrupted_code();
    int code = exit_done;
    for (const Kernel* kernel : plan_.answerers.kernels) {
      if (!is_unloadable(*kernel)) continue;
      fmt::print(stderr, "axiscert: {}: NOT JUDGED: it could not be loaded\n", kernel->id);
      code = exit_requirement_failed;
    }
    return code;
  }

  const PlannedOptions& options_;
  const OutputOptions& output_;
  const PlanFile& file_;
  const Plan& plan_;
  const Stretches& stretches_;
  std::optional<Ratchet> ratchet_;
  OutputFolder folder_;
  GatheredStretches gathered_;
  Ranks* ranks_;
  Distributor distributor_;
  bool is_whole_;
  Selection is_selected_;
  std::optional<Journal> journal_;
  std::uint64_t next_ = 0, left_ = 0, lost_ = 0;
  bool is_told_ = false;
  const std::atomic<bool>& interrupted_ = watch_for_interrupts();
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

// Runs one rank, or the only process.
int run_as(Ranks* ranks, const PlannedOptions& options, const RunOptions& run) {
  const PlanFile file = options.made ? *options.made : read_plan_file(options.plan);
  Plan plan = plan_of(file);
  plan.running.target = resolve_target(run.target);
  plan.judging.exact_only = run.exact_only;
  // A launcher starts one rank for each core, unless told otherwise.
  plan.running.threads = ranks && run.threads == 0 ? 1 : threads_of(run.threads);
  Plan again = plan;
  if (options.recheck > 0) again.running.target = recheck_target(options, plan.running.target);
  std::set<std::string> targets = targets_of(plan.answerers.kernels, plan.running.target);
  targets.insert(again.running.target);
  for (const std::string& target : targets) require_uncontracted(target);
  const Stretches stretches(plan.questions, file.units_each);
  Crew crew(plan.running.threads,
            [&](Task task) { return encode(run_stretch(is_again(task) ? again : plan, stretches, stretch_of(task))); });
  if (ranks && ranks->rank() != 0) {
    watch_for_interrupts();  // rank 0 decides when to stop, and says so
    leave_ending_to_another();
    serve(crew, *ranks);
    return exit_done;
  }
  print_first_look(plan.answerers.kernels);
  OutputOptions output = run;
  output.required = file.options.required;
  const int code = Lead(options, output, file, plan, stretches, crew, ranks).run(run.target);
  return options.after ? options.after(code) : code;
}

}  // namespace

void add_planned_options(CLI::App& command, PlannedOptions& o) {
  auto* plan =
      command.add_option("--plan", o.plan,
                         "plan file of `axiscert plan` to run, by all ranks where mpirun starts several; finished "
                         "stretches are kept in the folder's journal");
  for (const char* settled :
       {"--predicate", "--kernel", "KERNEL", "--family", "--mesh", "--queries", "--corpus", "--seed", "--trials",
        "--time", "--precision", "--tolerance", "--require", "--allow-unchecked", "--plant", "--preset"}) {
    plan->excludes(command.get_option(settled));
  }
  command.add_flag("--resume", o.resume, "continue the folder's journal, where there is one")->needs(plan);
  auto* shard = command.add_option("--shard", o.shard, "I/N: the I-th of N parts of the plan, for `axiscert merge`");
  auto* ratchet = command.get_option("--ratchet");  // needs a whole run
  shard->needs(plan)->excludes(ratchet);
  command.add_option("--stretches", o.stretches, "file of numbers: run only these stretches of the plan")
      ->needs(plan)
      ->excludes(shard)
      ->excludes(ratchet);
  auto* recheck = command.add_option("--recheck", o.recheck,
                                     "fraction of the finished stretches to repeat in another way; a difference is "
                                     "exit 3");
  recheck->needs(plan)->check(number_between(0, 1));
  command.add_option("--recheck-seed", o.recheck_seed, "seed that selects them (default: chosen anew, and printed)")
      ->needs(recheck);
  auto* target =
      command.add_option("--recheck-target", o.recheck_target,
                         "instruction set of the repetition (default: scalar, or the best where the first run "
                         "was scalar)");
  target->needs(recheck);
  command.add_option("--recheck-with", o.recheck_with, "another build's axiscert, which does the repetition")
      ->needs(recheck)
      ->excludes(target);
}

int run_planned(const PlannedOptions& options, const RunOptions& run) {
  const std::unique_ptr<Ranks> ranks = join_ranks();
  if (!ranks || ranks->size() == 1) return run_as(nullptr, options, run);
  try {
    return run_as(ranks.get(), options, run);
  } catch (...) {
    const int code = print_failure(std::current_exception());
    ranks->abort(code);  // otherwise the others would wait for this rank for ever
    return code;
  }
}

}  // namespace axiscert

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "fuzz/files/streams.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"
#include "plans/predicate_options.h"

namespace axiscert {
void add_query(CLI::App& app, Action& action) {
  struct Options {
    std::string address;
    AddressFiles files;
  };
  auto* command = app.add_subcommand("query", "Generate the query of an address again, as a line of a query file");
  auto options = std::make_shared<Options>();
  command->add_option("ADDRESS", options->address, "SEED:NAME:VERSION:PRECISION:UNIT:INDEX")->required();
  add_address_files(*command, options->files);
  add_examples(*command, {{"A query of a family", "axiscert query 1:tangent:2:binary32:0:9107"},
                          {"A query of a file, by the address that a report has",
                           "axiscert query 1:queries-SHA256:1:binary32:0:0 --queries mine.jsonl"}});
  command->callback([&action, options] {
    action = [options] {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(options->address, ignored)) {
        throw Error(fmt::format("ADDRESS '{}' is a file; `axiscert check {}` reads the queries of one",
                                options->address, options->address));
      }
      fmt::print("{}\n", query_line(query_at(parse_address(options->address), options->files)));
      return static_cast<int>(exit_done);
    };
  });
}

namespace {

struct GenerateOptions : SourceOptions {
  std::string precision = "binary32", out_file = "-";
  bool binary = false;
  std::size_t measures = 0;
  int threads = 0;
};

// Thrown when the reader of a pipe has closed it: it had enough, or it failed, which it reports itself.
struct ReaderLeft {};

// A file or standard output, by descriptor: a stream would not report a failed write until the end. A file has another
// name until finish(), unless it is there and no regular one, as a pipe.
class Output {
 public:
  explicit Output(const std::string& path) : name_(path == "-" ? "standard output" : path) {
    if (path == "-") return;
    std::error_code none;
    const bool is_whole_at_once = !std::filesystem::exists(path, none) || std::filesystem::is_regular_file(path, none);
    part_ = is_whole_at_once ? path + ".part" : "";
    descriptor_ = open(is_whole_at_once ? part_.c_str() : path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw cannot_write();
  }
  ~Output() {
    if (descriptor_ != STDOUT_FILENO) close(descriptor_);
    if (!part_.empty()) unlink(part_.c_str());  // after finish() there is none
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool is_terminal() const { return isatty(descriptor_) != 0; }

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written >= 0) bytes.remove_prefix(static_cast<std::size_t>(written));
      else if (errno == EPIPE) throw ReaderLeft();
      else if (errno != EINTR) throw cannot_write();
    }
  }
  void finish() const {
    if (!part_.empty() && std::rename(part_.c_str(), name_.c_str()) != 0) throw cannot_write();
  }

 private:
  Unwritable cannot_write() const { return {name_, errno, std::nullopt}; }

  std::string name_, part_;
  int descriptor_ = STDOUT_FILENO;
};

// The predicate and the entry that `all` and the default mean: those of the first family that is named; where there is
// none, the first entry of --predicate or of the default predicate.
struct MeantEntry {
  const Predicate& predicate;
  std::size_t entry;
};
MeantEntry meant_by_families(const GenerateOptions& options) {
  for (const std::string& name : options.families) {
    if (name == "all") continue;
    const Family& family = find_family(name);
    if (options.predicate.empty() || &family.predicate() == &predicate_given(options.predicate))
      return {family.predicate(), family.entry};
  }
  return {predicate_given(options.predicate), 0};
}

PipePlan pipe_plan_of(const GenerateOptions& options) {
  PipePlan plan{options.seed, parse_precision(options.precision), {}, options.measures};
  const MeantEntry meant = meant_by_families(options);
  const auto sources = sources_of(options, meant.predicate, meant.entry, plan.precision);
  predicate_of_sources(options.predicate, sources);
  print_left_out(sources, {plan.precision});
  for (const SourcePtr& source : sources) {
    const auto fixed = source->fixed_size(plan.precision);
    plan.parts.push_back({source, fixed ? *fixed : trials_of(options, *source, plan.precision)});
  }
  if (plan.queries() == 0)
    throw Error(fmt::format("no queries in {}; choose the other precision with --precision", options.precision));
  return plan;
}

int generate(const GenerateOptions& options) {
  const PipePlan plan = pipe_plan_of(options);
  const auto encoding = options.binary ? QueryEncoding::binary : QueryEncoding::json_lines;
  if (options.binary) header_of(plan);  // throws where there is none, before a file is created
  std::signal(SIGPIPE, SIG_IGN);
  const Output output(options.out_file);
  if (options.binary && output.is_terminal()) {
    throw Error("--binary would write bytes to a terminal: pipe them into a program, or give a file with -o");
  }
  try {
    ProgressLine progress("generate", output.is_terminal());  // where the queries themselves are seen to come
    std::uint64_t written = 0;
    write_queries(plan, encoding, threads_of(options.threads), [&](std::string_view bytes) {
      output.write(bytes);
      progress.begin_stage(fmt::format("{} bytes written", written += bytes.size()));
    });
    output.finish();
  } catch (const ReaderLeft&) {
  }
  return exit_done;
}

}  // namespace

void add_generate(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "generate", "Write queries, as a query file or (--binary) for a program whose replies `axiscert judge` takes");
  auto options = std::make_shared<GenerateOptions>();
  add_source_options(*command, *options);
  add_precision(*command, options->precision, of_csv_files);
  auto* binary =
      command->add_flag("--binary", options->binary, "the query stream of docs/pipe.md instead of JSON Lines");
  command
      ->add_option(
          "--measures", options->measures,
          "the program gives so many of the predicate's measures beside each verdict, from the first on (`axiscert "
          "predicates`)")
      ->needs(binary);
  add_out_file(*command, options->out_file, "the queries, - for standard output");
  add_thread_option(*command, options->threads);
  add_progress(*command);
  add_examples(*command, {{"A query file", "axiscert generate --family tangent --trials 100 -o queries.jsonl"},
                          {"For a program, whose replies are judged",
                           "axiscert generate --binary --family tangent | ./my_program | axiscert judge"}});
  command->callback([&action, options] { action = [options] { return generate(*options); }; });
}

}  // namespace axiscert

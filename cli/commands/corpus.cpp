#include "fuzz/files/corpus.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/shared_options.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

struct CorpusOptions {
  std::string folder, file, name, provenance, about, note, precision = "binary32", format = "text";
};

std::string folder_of(const CorpusOptions& options) {
  return options.folder.empty() ? default_corpus_folder() : options.folder;
}

// One file for each predicate that its lines name, and for the others one of each kind of provenance.
std::string file_for(const StoredQuery& stored, const Provenance& provenance) {
  const std::string_view predicate = written_name(*stored.predicate);
  return fmt::format("{}.jsonl", predicate.empty() ? provenance.kind : predicate);
}

int list(const CorpusOptions& options) {
  const auto entries = read_corpus(folder_of(options));
  for (const CorpusEntry& entry : entries) {
    if (options.format != "text") {
      fmt::print("{}\n", corpus_line(entry));
      continue;
    }
    const std::string about = entry.provenance.about.empty() ? "" : " (" + entry.provenance.about + ")";
    fmt::print("{:<40} {} {}{}  {}: {}{}\n", entry.stored.id, name(entry.stored.precision),
               name(entry.expected.verdict), entry.expected.touching ? ", touching" : "", entry.provenance.kind,
               entry.provenance.where, about);
  }
  return exit_done;
}

int add(const CorpusOptions& options) {
  const std::string folder = folder_of(options);
  const Provenance provenance = parse_provenance(options.provenance, options.about);
  const auto queries = read_query_file(options.file, parse_precision(options.precision));
  if (queries.size() != 1) {
    throw Error(fmt::format("{}: {} queries; give a file with one query, which gets the name '{}'", options.file,
                            queries.size(), options.name));
  }
  if (options.name.empty()) throw Error("--name: empty; an entry needs a name");
  std::vector<CorpusEntry> entries;
  // A corpus without entries has nothing to compare the first one with.
  std::error_code problem;
  if (!std::filesystem::is_empty(folder, problem) && !problem) entries = read_corpus(folder);
  if (problem) throw Error(fmt::format("{}: the corpus cannot be read: {}", folder, problem.message()));
  CorpusEntry entry{queries.front(), provenance, options.note, exact_answers(queries.front()),
                    (std::filesystem::path(folder) / file_for(queries.front(), provenance)).string()};
  entry.stored.id = options.name;
  for (const CorpusEntry& other : entries) {
    if (other.stored.id == options.name) {
      throw Error(fmt::format("--name {}: {}:{} has this name already", options.name, other.file, other.stored.line));
    }
  }
  if (const CorpusEntry* same = find_image(entries, entry.stored)) {
    throw Error(
        fmt::format("{}: already in the corpus as '{}' ({}:{}), up to vertex order, axes, signs, translation or "
                    "a power of two",
                    options.file, same->stored.id, same->file, same->stored.line));
  }
  std::error_code none;
  const std::string before = std::filesystem::exists(entry.file, none) ? read_bytes(entry.file) : "";
  write_files({}, {{entry.file, before + corpus_line(entry) + "\n"}});
  fmt::print("{}: {}\n", entry.file, corpus_line(entry));
  return exit_done;
}

}  // namespace

void add_corpus(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("corpus", "List the queries that are kept with their exact answers, and add to them");
  command->require_subcommand(1);
  auto options = std::make_shared<CorpusOptions>();
  const auto add_folder = [&](CLI::App& to) {
    to.add_option("--folder", options->folder, "the corpus (default: the one supplied with axiscert)");
  };
  add_examples(*command, {{"What is there", "axiscert corpus list"},
                          {"One more", "axiscert corpus add mine.jsonl --name two-points --provenance made:me"}});
  auto* listing = command->add_subcommand("list", "Every entry: name, exact verdict, where it came from");
  add_folder(*listing);
  add_format(*listing, options->format, {"jsonl"});
  add_examples(*listing, {{"The one that comes with axiscert", "axiscert corpus list"},
                          {"Its lines", "axiscert corpus list --format jsonl"}});
  listing->callback([&action, options] { action = [options] { return list(*options); }; });

  auto* adding = command->add_subcommand(
      "add",
      "Add a query with its exact answers, unless the corpus has it already up to the symmetries of the predicate");
  adding->add_option("FILE", options->file, "query file with one query; - reads standard input")->required();
  adding->add_option("--name", options->name, "the entry's name")->required();
  adding->add_option("--provenance", options->provenance, "KIND:WHERE; kinds: address, search, report, made")
      ->required();
  adding->add_option("--about", options->about, "the subject of a report: static, sweep or other");
  adding->add_option("--note", options->note, "a sentence on why the query is hard");
  add_precision(*adding, options->precision, of_csv_files);
  add_folder(*adding);
  add_examples(*adding, {{"A query of one's own",
                          "axiscert corpus add mine.jsonl --name two-points --provenance made:me --folder corpus"},
                         {"A query that a search found",
                          "axiscert corpus add mine.jsonl --name worst --provenance "
                          "search:published --note sliver --folder corpus"}});
  adding->callback([&action, options] { action = [options] { return add(*options); }; });
}

}  // namespace axiscert

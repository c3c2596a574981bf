#include "cli/reply_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "cli/usage.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

FilePlaces places_of(const ReplyOptions& options) {
  FilePlaces places;
  for (const auto* paths : {&options.meshes, &options.queries}) {
    for (const std::string& path : *paths) {
      const auto [place, is_new] = places.try_emplace(base_name(path), path);
      if (!is_new) throw Error(fmt::format("{} and {}: two files with the same name", place->second, path));
    }
  }
  return places;
}

StoredReplies read(const ReplyOptions& options) {
  const FilePlaces places = places_of(options);
  std::vector<ReplyStream> streams;
  for (const std::string& path : options.replies) {
    if (path != "-") {
      std::ifstream file = open_file(path);
      streams.push_back(read_replies(file, path, places));
      continue;
    }
    if (isatty(STDIN_FILENO) != 0) {
      throw Error("nothing is piped in: `axiscert generate --binary | PROGRAM | axiscert judge`, or give a reply file");
    }
    streams.push_back(read_replies(std::cin, "stdin", places));
  }
  StoredReplies replies(std::move(streams));
  for (const auto& place : places) {
    const bool is_used = std::any_of(replies.sources().begin(), replies.sources().end(), [&](const SourcePtr& source) {
      const auto file = source->file();
      return file && file->name == place.first;
    });
    if (!is_used) throw Error(fmt::format("{}: none of the queries come from a file of this name", place.second));
  }
  return replies;
}

// The program, represented by a kernel that is never run: its answers are stored.
Kernel program(const ReplyOptions& options, const StoredReplies& replies) {
  const Source& source = *replies.sources().front();
  Kernel kernel = claimed_kernel(options, {&source.predicate(), source.entry(), replies.precisions(),
                                           replies.has_bits(), replies.measure_count()});
  kernel.summary = "a program's replies, through a pipe";
  const auto never_run = [](const auto& batch, Verdict* out) { std::fill_n(out, batch.size, Verdict::unanswered); };
  for (const Precision precision : replies.precisions()) {
    if (precision == Precision::binary32)
      kernel.binary32 = [=](std::string_view) { return Implementation<float>{never_run}; };
    else kernel.binary64 = [=](std::string_view) { return Implementation<double>{never_run}; };
  }
  return kernel;
}

}  // namespace

void add_reply_options(CLI::App& command, ReplyOptions& options) {
  command.add_option("--as", options.id, "the program's id in the record")->capture_default_str();
  auto* conforms_to = command.add_option("--conforms-to", options.claim.conforms_to,
                                         "built-in kernel that the program claims to equal bit for bit");
  command
      .add_option(
          "--formulae", options.claim.formulae,
          "built-in kernel whose formulae the program evaluates in its own way (default: published where the replies "
          "give comparison bits)")
      ->excludes(conforms_to);
  command
      .add_option("--touching", options.touching,
                  "the program's intended answer for a sphere that touches the triangle")
      ->check(one_of({"contact", "separated", "either"}))
      ->capture_default_str();
  command
      .add_option("--sides", options.sides,
                  "the triangles that the program promises to judge: front, those in front of which the other body is, "
                  "or that a motion meets from the front")
      ->check(one_of({"both", "front"}))
      ->capture_default_str();
  command
      .add_option("--margin", options.margin,
                  "a length in the unit of the queries: the program may report contact where the two are apart by at "
                  "most this")
      ->check(number_above_zero());
  command.add_flag("--may-decline", options.may_decline,
                   "the program may answer undecided; without it each such answer is a fault");
  add_reply_files(command, options);
}

void add_reply_files(CLI::App& command, ReplyOptions& options) {
  command.add_option("--mesh", options.meshes, "present path of a mesh of the queries, repeatable")
      ->allow_extra_args(false);
  command.add_option("--queries", options.queries, "present path of a query file of the queries, repeatable")
      ->allow_extra_args(false);
}

ReplyPlan reply_plan(const ReplyOptions& options) {
  const auto replies = std::make_shared<const StoredReplies>(read(options));
  ReplyPlan made{std::make_shared<const Kernel>(program(options, *replies)), {}};
  Plan& plan = made.plan;
  plan.questions.seed = replies->seed();
  plan.answerers.kernels = {made.kernel.get()};
  plan.questions.sources = replies->sources();
  plan.questions.precisions = replies->precisions();
  plan.questions.fixed_size = [replies](const Source& source, Precision precision) {
    return replies->size(source, precision);
  };
  plan.running.target = scalar_target;  // the target of the claim's reference
  plan.answerers.replies = replies;
  plan.answerers.claim = options.claim;
  return made;
}

}  // namespace axiscert

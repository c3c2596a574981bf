#include "cli/options/reply_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "cli/usage.h"
#include "exact/trait/oracles.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/plugin/load.h"

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

// The built-in kernel that an option names, checked to fit what the replies show.
const Kernel& claimed(const char* option, const std::string& id, const StoredReplies& replies) {
  if (plugin::plugin_path(id))
    throw Error(fmt::format("{} {}: not a built-in kernel; see `axiscert kernels`", option, id));
  const Kernel& kernel = find_kernel(id);
  const Source& source = *replies.sources().front();
  if (kernel.predicate != &source.predicate()) {
    throw Error(fmt::format("{} {}: of the predicate {}, and the replies are to queries of {}", option, id,
                            kernel.predicate->id, source.predicate().id));
  }
  for (const Precision precision : replies.precisions()) {
    if (!kernel.has(precision)) throw Error(fmt::format("{} {}: does not exist in {}", option, id, name(precision)));
  }
  if (replies.has_bits() && !has_comparisons(kernel)) {
    throw Error(fmt::format("{} {}: it has no comparisons, but the replies give comparison bits", option, id));
  }
  return kernel;
}

bool is_id(const std::string& id) {
  return !id.empty() && id.size() <= 100 && std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  });
}

// Declares for the kernel which sides of a triangle it promises, and its margin.
void promise(const ReplyOptions& options, Kernel& kernel) {
  const Predicate& predicate = *kernel.predicate;
  if (options.sides == name(SidesPolicy::front)) {
    if (is_of_motions(predicate)) kernel.motion.sides = SidesPolicy::front;
    else if (predicate.has_front) kernel.limits.sides = SidesPolicy::front;
    else throw Error(fmt::format("--sides front: the predicate {} has no triangle with a front", predicate.id));
  }
  kernel.limits.margin = options.margin;
  if (options.margin != 0 && kernel.touching == TouchingPolicy::separated)
    throw Error(
        fmt::format("--margin {}: contact may be reported within it, so --touching is contact or either, not "
                    "separated",
                    options.margin));
}

// The program, represented by a kernel that is never run: its answers are stored.
Kernel program(const ReplyOptions& options, const StoredReplies& replies) {
  if (!is_id(options.id))
    throw Error(fmt::format("--as {}: an id is 1 to 100 letters, digits, '-', '_', '.'", options.id));
  for (const Kernel& kernel : kernels()) {
    if (kernel.id == options.id) throw Error(fmt::format("--as {}: that is a built-in kernel", options.id));
  }
  // Replies with bits are of the usual or the first formulae of their predicate, unless the command says which.
  const Predicate& predicate = replies.sources().front()->predicate();
  std::string formulae;
  if (replies.has_bits()) {
    formulae = predicate.usual_formulae.empty() ? std::string(oracles_of(predicate).formulae().front())
                                                : find_kernel(predicate.usual_formulae).formulae;
  }
  Kernel kernel{.id = options.id,
                .summary = "a program's replies, through a pipe",
                .formulae = std::move(formulae),
                .exposes = replies.has_bits() ? Exposure::comparisons : Exposure::verdict,
                .binary32 = {},
                .binary64 = {},
                .is_reference = false};
  kernel.predicate = &predicate;
  kernel.entry = replies.sources().front()->entry();
  kernel.measure_count = replies.measure_count();
  if (const std::string& id = options.claim.conforms_to; !id.empty()) {
    const Kernel& model = claimed("--conforms-to", id, replies);
    if (!model.is_reference) {
      throw Error(
          fmt::format("--conforms-to {}: it chooses its own order of operations, so nothing can be compared with "
                      "it bit for bit; --formulae {} judges by its formulae",
                      id, id));
    }
    kernel.formulae = model.formulae;
    kernel.strictness = model.strictness;
    kernel.arithmetic = model.arithmetic;
    kernel.is_reference = true;
  }
  if (const std::string& id = options.claim.formulae; !id.empty()) {
    const Kernel& model = claimed("--formulae", id, replies);
    kernel.formulae = model.formulae;
    kernel.strictness = model.strictness;
  }
  const auto touching = std::find(touching_names.begin(), touching_names.end(), options.touching);
  kernel.touching = static_cast<TouchingPolicy>(touching - touching_names.begin());
  kernel.may_decline = options.may_decline;
  promise(options, kernel);
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

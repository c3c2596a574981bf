#include <fmt/format.h>

#include "cli/commands.h"
#include "exact/examine.h"
#include "fuzz/address.h"
#include "fuzz/query_file.h"
#include "reports/finding.h"

namespace axiscert {
namespace {

std::string bits16(ComparisonBits bits) { return bit_string(bits, comparison_count); }
std::string bits7(ComparisonBits bits) { return bit_string(axes_of(bits), axis_count); }

Json exact_json(const Examination& found) {
  Json json = {{"verdict", name(found.truth.verdict)}, {"touching", found.truth.touching}};
  const auto& formula = found.truth.formula;
  json["squared_distance"] = nullptr;
  if (found.squared_distance) {
    const Rational& d = *found.squared_distance;
    json["squared_distance"] = d.get_num().get_str() + "/" + d.get_den().get_str();
  }
  json["comparisons"] = formula ? Json(bits16(formula->strict)) : Json(nullptr);
  json["axes"] = formula ? Json(bits7(formula->strict)) : Json(nullptr);
  json["ties"] = formula ? Json(bits16(formula->ties)) : Json(nullptr);
  return json;
}

Json computed_json(const Answer& answer) {
  Json json = {{"verdict", name(answer.verdict)}};
  json["comparisons"] = answer.bits ? Json(bits16(*answer.bits)) : Json(nullptr);
  json["axes"] = answer.bits ? Json(bits7(*answer.bits)) : Json(nullptr);
  return json;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json all = Json::array();
  for (const Finding& finding : findings) all.push_back({{"kind", name(finding.kind)}, {"detail", finding.detail}});
  return all;
}

// " (touching)", and what the kernel means to say of it where that is not contact.
std::string touching_text(const Truth& truth, const Kernel& kernel) {
  if (!truth.touching) return "";
  switch (kernel.touching) {
    case Touching::contact:
      return " (touching)";
    case Touching::separated:
      return fmt::format(" (touching, which {} calls separated)", kernel.id);
    case Touching::either:
      return fmt::format(" (touching, where {} may say either)", kernel.id);
  }
  return "";
}

void print_text(const std::string& id, const Kernel& kernel, const Examination& found) {
  const bool answered = found.answer.verdict != Verdict::unanswered;
  fmt::print("{}: exact {}{}, {} {}", id, name(found.truth.verdict), touching_text(found.truth, kernel), kernel.id,
             answered ? name(found.answer.verdict) : "gave no answer");
  if (found.truth.formula && !found.within_limits) fmt::print(" (outside the limits that it declares)");
  if (found.depth) fmt::print(", wrong by {:.3g} of the scene", *found.depth);
  for (const Flip& flip : found.judgement.flips()) {
    fmt::print("; {} {}{} [", name(flip), flip_kind_names[static_cast<std::size_t>(flip.kind)],
               flip.level == Level::verdict ? ""
               : flip.decisive              ? " decisive"
                                            : " masked");
    const char* separator = "";
    for (std::size_t i = 0; i < link_count; ++i) {
      if (!((flip.links >> i) & 1u)) continue;
      fmt::print("{}{}", separator, link_names[i]);
      separator = " ";
    }
    fmt::print("]");
  }
  for (const Finding& finding : found.findings) fmt::print("; {}: {}", name(finding.kind), finding.detail);
  fmt::print("\n");
}

struct Options {
  std::string file, kernel = "published", format = "text", target = "auto", precision = "binary32";
};

int check(const Options& options) {
  const Kernel& kernel = find_kernel(options.kernel);
  require_loaded(kernel);
  const std::string target = resolve_target(options.target);
  const auto queries = read_query_file(options.file, parse_precision(options.precision));
  Examiner examiner(kernel, target);
  for (const StoredQuery& stored : queries) {
    if (!kernel.has(stored.precision)) {
      throw Error(fmt::format("{}: query '{}' is in {}, in which kernel {} does not exist", options.file, stored.id,
                              name(stored.precision), kernel.id));
    }
    const Examination found = std::visit([&](const auto& q) { return examiner.examine(q); }, stored.query);
    if (options.format == "text") {
      print_text(stored.id, kernel, found);
      continue;
    }
    const Json line = {{"id", stored.id},
                       {"kernel", kernel.id},
                       {"exact", exact_json(found)},
                       {"computed", computed_json(found.answer)},
                       {"within_limits", found.within_limits},
                       {"findings", findings_json(found.findings)},
                       {"flips", flips_json(found.judgement)}};
    fmt::print("{}\n", line.dump());
  }
  return exit_done;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("check", "Judge each query of a file: exact and computed answers, and why they differ");
  auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "query file, JSON Lines or CSV; - reads standard input")->required();
  command->add_option("--kernel", options->kernel, "kernel id")->capture_default_str();
  command->add_option("--target", options->target, "instruction set, or auto")->capture_default_str();
  command->add_option("--precision", options->precision, "of a CSV file, which does not say")->capture_default_str();
  add_format(*command, options->format, "jsonl");
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace axiscert

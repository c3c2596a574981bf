// axiscert prove: runs the checkers on the proofs and reports for every bound whether it was accepted.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "cli/commands.h"
#include "cli/commands/run_output.h"
#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "proofs/bounds.h"
#include "proofs/checkers.h"
#include "proofs/emit.h"
#include "reports/instrument/proofs_data.h"

namespace axiscert {
namespace {

using namespace proofs;

struct ProveOptions {
  std::string precision, format = "text", out, proofs = AXISCERT_PROOFS;
  bool without_coq = false;
};

struct ScriptEntry {
  Setting setting;
  Comparison which;
  std::string status;  // proved, open, refused, NOT CHECKED
};

std::string kernel_of(const Setting& setting) {
  return std::string(name(setting.form)) + (setting.contraction == proofs::Contraction::fma ? "+fma" : "");
}

std::vector<ScriptEntry> entries_of(const ProveOptions& options) {
  std::vector<ScriptEntry> entries;
  for (const Form form : {Form::published, Form::reduced}) {
    for (const proofs::Contraction contraction : {proofs::Contraction::plain, proofs::Contraction::fma}) {
      for (const Precision precision : {Precision::binary32, Precision::binary64}) {
        if (!options.precision.empty() && precision != parse_precision(options.precision)) continue;
        for (const Domain domain : {Domain::scaled, Domain::absolute}) {
          for (std::size_t k = 0; k < comparison_count; ++k) {
            entries.push_back({{form, contraction, precision, domain}, static_cast<Comparison>(k), "NOT CHECKED"});
          }
        }
      }
    }
  }
  return entries;
}

// The largest error that a search attained with the kernel, or with the kernel whose comparison is the same program.
std::optional<double> attained_of(const ScriptEntry& entry) {
  if (entry.setting.domain != Domain::scaled || entry.setting.precision != Precision::binary32) return std::nullopt;
  Setting searched = entry.setting;
  if (is_shared(entry.which)) searched.form = Form::published;
  for (const AttainedBound& attained : attained_errors) {
    if (attained.kernel == kernel_of(searched) && attained.kind == kind_of(entry.which)) return attained.u;
  }
  return std::nullopt;
}

// A bound is proved where Gappa accepts its script and Coq accepts every range that the script takes as a hypothesis.
// The ranges of the absolute domain have no proof in Coq.
void check(std::vector<ScriptEntry>& entries, const std::optional<bool>& ranges, const ShowProgress& report) {
  const Files scripts = gappa_files();
  std::vector<std::pair<std::string, bool>> accepted;  // each script once, whichever bounds share it
  for (const ScriptEntry& entry : entries) accepted.emplace_back(script_path(entry.setting, entry.which), false);
  std::sort(accepted.begin(), accepted.end());
  accepted.erase(std::unique(accepted.begin(), accepted.end()), accepted.end());
  ProgressCount progress(report, accepted.size(), "Gappa's scripts");
  tbb::parallel_for(std::size_t{0}, accepted.size(), [&](std::size_t i) {
    accepted[i].second = gappa_accepts(scripts.at(accepted[i].first));
    progress.finish_unit();
  });
  for (ScriptEntry& entry : entries) {
    const auto found =
        std::lower_bound(accepted.begin(), accepted.end(), std::pair(script_path(entry.setting, entry.which), false));
    if (!found->second || ranges == false) entry.status = "refused";
    else if (entry.setting.domain == Domain::absolute) entry.status = "open";
    else entry.status = ranges ? "proved" : "NOT CHECKED";
  }
}

ProofsData proofs_data(const std::vector<ScriptEntry>& entries, const std::optional<std::string>& gappa,
                       const std::optional<std::string>& coq) {
  ProofsData data;
  data.checkers = {gappa.value_or("NOT CHECKED"), coq.value_or("NOT CHECKED")};
  for (const ScriptEntry& entry : entries) {
    const double u = bound(entry.setting, entry.which) / 16.0;
    const auto attained = attained_of(entry);
    data.bounds.push_back({info(entry.which).name, kernel_of(entry.setting), entry.setting.precision,
                           name(entry.setting.domain), u, attained,
                           attained ? std::optional(u / *attained) : std::nullopt, entry.status,
                           "proofs/" + script_path(entry.setting, entry.which)});
  }
  return data;
}

void print_text(const ProofsData& data) {
  fmt::print("gappa: {}\ncoq: {}\n", data.checkers.gappa, data.checkers.coq);
  const auto shown = [](const std::optional<double>& number) {
    return number ? fmt::format("{:.4g}", *number) : std::string("-");
  };
  for (const ProvedBoundData& b : data.bounds) {
    fmt::print("{:14} {:8} {:8} {:16} bound {:9.2f} u  attained {:>6}  ratio {:>5}  {}\n", b.kernel, name(b.precision),
               b.domain, b.comparison, b.bound_u, shown(b.attained_u), shown(b.ratio), b.status);
  }
}

int prove(const ProveOptions& options) {
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  std::vector<ScriptEntry> entries = entries_of(options);
  const auto gappa = gappa_version(), coq = options.without_coq ? std::nullopt : coq_version();
  if (gappa) {
    ProgressLine progress("prove");
    progress.begin_stage("Coq's proof of the ranges");
    std::optional<bool> ranges;
    if (coq) ranges = coq_accepts_ranges(options.proofs, range_files().begin()->second);
    check(entries, ranges, progress.report());
  }
  const ProofsData data = proofs_data(entries, gappa, coq);
  const Json json = json_of(data);
  if (folder) {
    folder->write_text("proofs.json", json.dump(2) + "\n");
    for (const auto& [path, script] : gappa_files()) folder->write_text("proofs/" + path, script);
  }
  if (options.format == "text") print_text(data);
  else std::cout << data_text(json, options.format);
  const bool refused =
      std::any_of(entries.begin(), entries.end(), [](const ScriptEntry& e) { return e.status == "refused"; });
  return refused ? exit_requirement_failed : exit_done;
}

}  // namespace

void add_prove(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "prove", "Check the proofs of the rounding errors with Gappa and Coq, and report what they prove");
  auto options = std::make_shared<ProveOptions>();
  ProveOptions& o = *options;
  add_precision(*command, o.precision, "", "both");
  command->add_option("--proofs", o.proofs, "folder with coq/formulae/Ranges.v")->capture_default_str();
  command->add_flag("--without-coq", o.without_coq, "Gappa alone, which takes a minute less; nothing counts as proved");
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  add_out(*command, o.out, "proofs.json and for Gappa's scripts");
  add_examples(*command, {{"Every bound of binary32", "axiscert prove --precision binary32"},
                          {"Gappa's alone, a minute less", "axiscert prove --without-coq --out proofs"}});
  command->callback([&action, options] { action = [options] { return prove(*options); }; });
}

}  // namespace axiscert

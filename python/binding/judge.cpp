// Plans that are judged, as `axiscert run` does it; functions among their kernels.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "fuzz/diagnosis/beside_runs.h"
#include "fuzz/text/json_form.h"
#include "fuzz/files/query_file.h"
#include "kernel/kernel.h"
#include "kernel/base/error.h"
#include "plans/judged_plan.h"
#include "plans/notices.h"
#include "plans/run_plan.h"
#include "python/binding/callables.h"
#include "python/binding/common.h"
#include "python/binding/options.h"
#include "python/binding/work.h"
#include "reports/formats/format.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/evidence.h"

namespace axiscert::python {
namespace {

// A run that was judged.
struct Judged {
  RunFiles files;

  std::vector<LevelOutcome> outcomes() const { return outcomes_of(files.record); }
};

RunOptions run_options(Options& taken) {
  RunOptions o;
  taken.take("predicate", o.predicate);
  taken.take("kernels", o.kernels);
  taken.take("families", o.families);
  taken.take("meshes", o.meshes);
  taken.take("queries", o.queries);
  taken.take("corpus", o.corpus);
  taken.take("trials", o.trials);
  taken.take("seed", o.seed);
  taken.take("seconds", o.seconds);
  taken.take("precision", o.precision);
  taken.take("preset", o.preset);
  taken.take("tolerances", o.tolerances);
  taken.take("require", o.required.levels);
  taken.take("allow_unchecked", o.required.allow_unchecked);
  taken.take("unit", o.required.unit);
  taken.take("sources", o.sources);
  taken.take("target", o.target);
  taken.take("exact_only", o.exact_only);
  taken.take("threads", o.threads);
  return o;
}

// The record of the plan, and what a signal raised, after which it is of the units that were done. With a folder, what
// is done is kept there.
py::tuple judge(const py::dict& given, const py::object& progress) {
  Options taken(given);
  const RunOptions asked = run_options(taken);
  std::optional<std::string> out;
  Keeping keeping;
  taken.take("out", out);
  taken.take("resume", keeping.resumes);
  taken.take("code", keeping.code);
  taken.require_all_taken();
  auto [judged, raised] = watched<Judged>(progress, [&](Watch& watch) {
    const RunOptions options = with_preset(asked);
    std::optional<OutputFolder> folder;
    if (out) folder.emplace(*out);  // checked before anything runs
    const Plan plan = plan_of(options);
    source_places(plan.answerers.kernels, options.sources);
    print_first_look(plan.answerers.kernels);
    for (const Kernel* kernel : plan.answerers.kernels) {
      if (given_kernel(kernel->id) != kernel) continue;
      if (const std::string found = first_look(*kernel); !found.empty()) notice("kernel {}: {}", kernel->id, found);
    }
    const auto started = std::chrono::system_clock::now();
    const CampaignResult result = judge_plan(plan, watch.interrupted(), watch.show(), folder ? &*folder : nullptr,
                                             folder && !plan.questions.seconds ? &keeping : nullptr);
    return Judged{run_files(plan, result, options, options.target, started,
                            [&](std::string_view stage) { watch.begin_stage(stage); })};
  });
  return py::make_tuple(std::move(judged), value_of(raised));
}

template <class Data>
std::string json_text(const Data& data) {
  const Unlocked unlocked;
  return json_of(data).dump(1) + "\n";
}

py::list texts_of(const std::vector<LevelOutcome>& outcomes) {
  py::list texts;
  for (const LevelOutcome& outcome : outcomes) texts.append(py::str(json_of(outcome).dump()));
  return texts;
}

std::mutex notices_mutex;
std::vector<std::string> notices;

}  // namespace

void bind_judge(py::module_& m) {
  py::class_<Judged>(m, "Judged")
      .def_property_readonly("complete", [](const Judged& run) { return run.files.record.complete; })
      .def("record", [](const Judged& run) { return py::bytes(json_text(run.files.record)); })
      .def("run",
           [](const Judged& run) {
             const auto outcomes = run.outcomes();
             return py::bytes(
                 json_text(RunFile{run.files.info, outcomes.empty() ? std::nullopt : std::optional(outcomes)}));
           })
      // Of each kernel of the record, the queries that it promises and has decided.
      .def("decided",
           [](const Judged& run) {
             std::vector<std::uint64_t> decided;
             for (const KernelRecord& kernel : run.files.record.kernels)
               decided.push_back(evidence_of(kernel).decided());
             return decided;
           })
      .def("outcomes", [](const Judged& run) { return texts_of(run.outcomes()); })
      .def("passes", [](const Judged& run) { return pass(run.outcomes()); })
      .def(
          "save",
          [](const Judged& run, const std::string& folder) {
            const OutputFolder to(folder);
            write_run(to, run.files);
            render_reports(folder);
          },
          py::call_guard<Unlocked>())
      .def(py::pickle(
          [](const Judged& run) {
            return py::make_tuple(py::bytes(json_text(run.files.record)), py::bytes(json_text(run.files.info)));
          },
          [](const py::tuple& texts) {
            const auto json = [&](std::size_t i) { return parsed_json(texts[i].cast<std::string>()); };
            return Judged{{read_record(json(0), "the pickled record"), read_run_info(json(1), "the pickled run")}};
          }));
  m.def("judge", &judge);
  m.def("take_notices", [] {
    const std::lock_guard lock(notices_mutex);
    return std::exchange(notices, {});
  });
  const auto keep = [](const std::string& line) {
    const std::lock_guard lock(notices_mutex);
    if (std::ranges::find(notices, line) == notices.end()) notices.push_back(line);
  };
  set_notices(keep);
  set_query_notes(keep);
}

void bind_callables(py::module_& m) {
  py::register_exception<CallableFailed>(m, "CallableFailed");
  py::class_<Callable, std::shared_ptr<Callable>>(m, "Callable")
      .def(py::init([](const std::string& layout, bool records_errors, const py::dict& given) {
        Options taken(given);
        std::string predicate, entry;
        std::vector<std::string> precisions;
        KernelClaims claims;
        ShownAnswers shown{};
        taken.take("predicate", predicate);
        taken.take("entry", entry);
        taken.take("precisions", precisions);
        taken.take("bits", shown.has_bits);
        taken.take("measures", shown.measure_count);
        taken.take("id", claims.id);
        taken.take("touching", claims.touching);
        taken.take("sides", claims.sides);
        taken.take("margin", claims.margin);
        taken.take("may_decline", claims.may_decline);
        taken.take("conforms_to", claims.claim.conforms_to);
        taken.take("formulae", claims.claim.formulae);
        taken.require_all_taken();
        const EntryOf of = entry_named(predicate, entry);
        shown.predicate = of.predicate;
        shown.entry = of.entry;
        for (const std::string& precision : precisions) shown.precisions.push_back(parse_precision(precision));
        if (shown.measure_count > of.predicate->measures.size()) {
          throw Error(fmt::format("measures={}: the predicate {} has {}", shown.measure_count, of.predicate->id,
                                  of.predicate->measures.size()));
        }
        auto made = std::make_shared<Callable>(layout == "columns" ? Layout::columns : Layout::groups, records_errors,
                                               shown, claims.id);
        give_kernel(kernel_of(made, claims));
        return made;
      }))
      .def_property_readonly("seconds", &Callable::seconds)
      .def_property_readonly("calls", &Callable::calls)
      .def("hold", &Callable::hold)
      .def("release", &Callable::release);
}

}  // namespace axiscert::python

// The instruments: what each command of the same name measures, finds or compares.
#include <fmt/format.h>

#include <functional>

#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "plans/formula_figures.h"
#include "plans/given_queries.h"
#include "plans/kernel_figures.h"
#include "plans/notices.h"
#include "plans/shrink_query.h"
#include "python/binding/common.h"
#include "python/binding/options.h"
#include "python/binding/work.h"
#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/instrument/diagnosis_report.h"
#include "reports/instrument/instrument.h"
#include "reports/instrument/search_report.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert::python {
namespace {

// As (name, the figures as JSON, text, page, what a signal raised): the JSON as the command of that name prints it.
py::tuple in_python(const InstrumentReport& report, const std::optional<py::error_already_set>& raised = {},
                    int indentation = 2) {
  return py::make_tuple(report.name, report.data.dump(indentation) + "\n", instrument_text(report),
                        instrument_page(report), value_of(raised));
}

// The figures are of all queries or of none: an interrupt ends them.
py::tuple figures(const py::object& progress, const std::function<InstrumentReport(const ShowProgress&)>& measure) {
  const auto [report, raised] =
      watched<InstrumentReport>(progress, [&](Watch& watch) { return measure(watch.show_or_stop()); });
  return in_python(report, raised);
}

// What is found of a kernel until an interrupt: the figures, and with them (complete, the witnesses as lines of a query
// file).
struct Found {
  InstrumentReport report;
  bool is_complete;
  std::string witnesses;
};
py::tuple found(const py::object& progress, const std::function<Found(Watch&)>& find) {
  const auto [found, raised] = watched<Found>(progress, find);
  return py::make_tuple(in_python(found.report, raised), found.is_complete, found.witnesses);
}

void take_measured(Options& taken, InstrumentOptions& o, const char* command) {
  o.command = command;
  taken.take("kernels", o.kernels);
  taken.take("families", o.families);
  taken.take("queries", o.queries);
  taken.take("meshes", o.meshes);
  taken.take("corpus", o.corpus);
  taken.take("sweep", o.sweep);
  taken.take("trials", o.trials);
  taken.take("seed", o.seed);
  taken.take("precision", o.precision);
  taken.take("threads", o.threads);
}

py::tuple ladder(const py::dict& given, const py::object& progress) {
  Options taken(given);
  LadderOptions o;
  o.trials = ladder_trials;
  take_measured(taken, o, "ladder");
  taken.take("no_speed", o.no_speed);
  taken.take("factorial", o.factorial);
  taken.require_all_taken();
  return figures(progress, [&](const ShowProgress& show) { return ladder_figures(o, show); });
}

py::tuple precision(const py::dict& given, const py::object& progress) {
  Options taken(given);
  PrecisionOptions o;
  o.trials = precision_trials;
  take_measured(taken, o, "precision");
  taken.take("bits", o.bits);
  taken.take("numbers", o.numbers);
  taken.take("rounding", o.rounding);
  taken.take("rounding_seeds", o.rounding_seeds);
  taken.take("contraction", o.contraction);
  taken.take("round_inputs", o.round_inputs);
  taken.require_all_taken();
  return figures(progress, [&](const ShowProgress& show) { return precision_figures(o, show); });
}

py::tuple condition(const py::dict& given, const py::object& progress) {
  Options taken(given);
  ConditionOptions o;
  o.trials = condition_trials;
  take_measured(taken, o, "condition");
  taken.take("flips", o.flips);
  taken.take("sample", o.sample);
  taken.require_all_taken();
  return figures(progress, [&](const ShowProgress& show) { return condition_figures(o, show); });
}

py::tuple diagnose(const py::dict& given, const py::object& progress) {
  Options taken(given);
  DiagnoseOptions o;
  taken.take("kernel", o.kernel);
  taken.take("precision", o.precision);
  taken.take("seed", o.seed);
  taken.require_all_taken();
  return found(progress, [&](Watch& watch) -> Found {
    Diagnosed made = diagnosed(o, watch.interrupted(), watch.show());
    return {std::move(made.report), made.diagnosis.complete, diagnosis_witnesses(made.diagnosis)};
  });
}

py::tuple search(const py::dict& given, const py::object& progress) {
  Options taken(given);
  SearchOptions o;
  taken.take("kernel", o.kernel);
  taken.take("predicate", o.predicate);
  taken.take("precision", o.precision);
  taken.take("comparisons", o.comparisons);
  taken.take("families", o.families);
  taken.take("evaluations", o.evaluations);
  taken.take("seconds", o.seconds);
  taken.take("seed", o.seed);
  taken.take("target", o.target);
  taken.take("threads", o.threads);
  taken.take("out", o.out);
  taken.take("resume", o.resume);
  taken.require_all_taken();
  return found(progress, [&](Watch& watch) -> Found {
    const SearchPlan plan = search_plan_of(o);
    const auto state = search_state(o);
    std::optional<OutputFolder> folder;
    if (!o.out.empty()) folder.emplace(o.out);  // checked before anything runs
    Searched made = searched(o, plan, state, watch.interrupted(), [&](const SearchProgress& p) {
      watch.take({p.islands, 0, p.evaluations, p.seconds});
    });
    if (folder) write_search(*folder, made.result);
    return {std::move(made.report), made.result.complete, search_witnesses(made.result)};
  });
}

// Lines as `axiscert shrink --format jsonl` prints them, for each query that shows something to keep; and why others
// show nothing.
py::tuple shrink(const py::dict& given, const py::object& progress) {
  Options taken(given);
  ShrinkOptions o;
  taken.take("queries", o.queries);
  taken.take("kernels", o.kernels);
  taken.take("target", o.target);
  taken.take("precision", o.precision);
  taken.take("what", o.what);
  taken.take("evaluations", o.evaluations);
  taken.take("any_class", o.any_class);
  taken.require_all_taken();
  struct Lines {
    std::vector<std::string> smaller, nothing;
  };
  const auto [lines, raised] = watched<Lines>(progress, [&](Watch& watch) {
    Lines made;
    std::vector<const Kernel*> kernels;
    for (const std::string& id : o.kernels) require_known_symptom(*kernels.emplace_back(&find_kernel(id)), o.what);
    require_one_of_each(kernels);
    const auto queries = queries_given(o.queries, o.precision, o.files);
    for (const Kernel* kernel : kernels) require_loaded(*kernel);
    print_first_look(kernels);
    const std::string target = resolve_target(o.target);
    for (const StoredQuery& stored : queries) require_known_symptom(kernel_to_shrink(stored, kernels), o.what);
    for (std::size_t i = 0; i < queries.size() && !watch.interrupted(); ++i) {
      try {
        const Shrunk found = shrunk(queries[i], o, kernel_to_shrink(queries[i], kernels), target,
                                    [&](std::uint64_t) { return !watch.interrupted(); });
        made.smaller.push_back(json_of(ShrinkLine{{}, found.line}).dump());
      } catch (const NothingToKeep& none) {
        if (queries.size() == 1) throw;
        made.nothing.emplace_back(none.what());
      }
      watch.take({i + 1, queries.size(), i + 1, 0});
    }
    return made;
  });
  return py::make_tuple(lines.smaller, lines.nothing, value_of(raised));
}

// Also (whether nothing is new or worse, a text for a pull request).
py::tuple compare(const std::string& before_folder, const std::string& after_folder,
                  const std::vector<std::string>& allowed, bool replays, const py::object& progress) {
  struct Compared {
    InstrumentReport report;
    bool passes;
    std::string markdown;
  };
  const auto [compared, raised] = watched<Compared>(progress, [&](Watch& watch) {
    const Run before = read_run(before_folder), after = read_run(after_folder);
    require_same_predicate(before.record, after.record, before_folder, after_folder);
    watch.begin_stage("the witnesses are evaluated again");
    std::vector<ReplayedQuery> replayed;
    if (replays) replayed = replay_witnesses(before.record, resolve_target("auto"), {});
    const RunComparison comparison = compare_records(before.record, after.record, std::move(replayed), allowed);
    const ComparedRuns runs{before.record, after.record, before_folder, after_folder};
    return Compared{comparison_report(runs, comparison), comparison.passes(), comparison_markdown(runs, comparison)};
  });
  return py::make_tuple(in_python(compared.report, raised, 1), compared.passes, compared.markdown);
}

}  // namespace

void bind_instruments(py::module_& m) {
  m.def("ladder", &ladder);
  m.def("precision", &precision);
  m.def("condition", &condition);
  m.def("diagnose", &diagnose);
  m.def("search", &search);
  m.def("compare", &compare);
  m.def("shrink", &shrink);
}

}  // namespace axiscert::python

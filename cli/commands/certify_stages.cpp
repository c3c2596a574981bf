#include "cli/commands/certify.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands/mutation_gate.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/instruments/black_box.h"
#include "fuzz/instruments/safe_margin.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "plans/predicate_options.h"
#include "plans/search_plan.h"
#include "reports/certificate/margin.h"
#include "reports/certificate/statement.h"
#include "reports/gates/requirement.h"
#include "reports/instrument/black_box_report.h"
#include "reports/instrument/mutation_report.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

constexpr const char* stages_file = "stages.json";
constexpr const char* states = "states";  // the member of stages.json that has the states of parts not done
constexpr double seconds_between_states = 60;

// A stage that asks the kernel again, before it begins: with a reason where it cannot.
template <class Stage>
Stage stage_of(const StagedCertificate& staged) {
  Stage all;
  if (staged.options.is_of_replies) all.reason = "replies are judged as they are: their program cannot be asked again";
  return all;
}

const std::atomic<bool>& interrupts() { return watch_for_interrupts(); }

FindStatement find_statement(const Find& find) {
  FindStatement said;
  (find.aim.goal == Goal::critical_radius ? said.ulps : said.depth) = find.value.text();
  said.links.emplace();
  for (const std::string_view link : names(find.links)) said.links->emplace_back(link);
  said.query.json = Json::parse(query_line(find.witness));
  return said;
}

SearchedStatement search_precision(const StagedCertificate& staged, Precision precision, Stages& stages,
                                   const std::string& stage) {
  SearchOptions options;
  options.kernel = staged.kernel.id;
  options.precision = name(precision);
  options.what = {std::string(verdict_word)};
  options.evaluations = staged.size.evaluations;
  options.first_queries = std::min(std::uint64_t{1} << 13, staged.size.trials);
  options.seed = staged.options.seed;
  options.threads = staged.options.threads;
  const SearchPlan plan = search_plan_of(options);
  SearchResult result;
  {
    ProgressLine progress(fmt::format("certify: search, {}", name(precision)), staged.options.quiet);
    result =
        run_resumable_search(plan, stages, stage, seconds_between_states, interrupts(), [&](const SearchProgress& p) {
          progress.show({p.islands, 0, 0, p.seconds},
                        fmt::format("; {} of {} evaluations", p.evaluations, *plan.evaluations));
        });
  }
  SearchedStatement said{result.evaluations, plan.first_queries, {}, {}};
  for (std::size_t i = 0; i < result.aims.size(); ++i) {
    const Aim& aim = result.aims[i];
    if (is_about_a_comparison(aim.goal)) continue;
    said.finds.put(name(aim, *plan.kernel->predicate));
    said.looked_at.put(name(aim, *plan.kernel->predicate)) = result.seen(i);
  }
  for (const Find& find : result.finds) {
    if (!is_about_a_comparison(find.aim.goal))
      said.finds.put(name(find.aim, *plan.kernel->predicate)) = find_statement(find);
  }
  return said;
}

// The queries that a search found, of all goals but those without a wrong verdict.
std::vector<StoredQuery> found_queries(const SearchesStatement& search, Precision precision) {
  std::vector<StoredQuery> queries;
  const SearchedStatement* here = search.precisions.find(name(precision));
  if (here == nullptr) return queries;
  for (const auto& [aim, find] : here->finds) {
    if (!find) continue;
    for (StoredQuery& query : parse_queries(find->query.json.dump() + "\n", "the search", precision)) {
      query.id = fmt::format("search {}", aim);
      queries.push_back(std::move(query));
    }
  }
  return queries;
}

// How many queries of each source were run: of a run that ended early those of the units that were done.
std::function<std::uint64_t(const Source&)> queries_run(const Record& record, Precision precision) {
  return [&record, precision](const Source& source) -> std::uint64_t {
    const auto count_in = [&](const CountsByFamily& counts) -> std::uint64_t {
      const auto* family = counts.find(source.name());
      return family && family->contains(precision) ? family->at(precision) : 0;
    };
    const PlanRecord& plan = record.plan;
    const std::uint64_t queries = count_in(plan.trials);
    return plan.units_done ? std::min(queries, count_in(*plan.units_done) * unit_size) : queries;
  };
}

MarginStatement measure_margin(const StagedCertificate& staged, const SearchesStatement& search, Precision precision) {
  SafeMarginPlan plan{&staged.questions,
                      &staged.running,
                      &staged.kernel,
                      precision,
                      queries_run(staged.record, precision),
                      staged.size.probes,
                      found_queries(search, precision)};
  ProgressLine progress(fmt::format("certify: safe margin, {}", name(precision)), staged.options.quiet);
  const SafeMargin margin = safe_margin(plan, interrupts(), progress.report());
  if (!margin.complete) throw StageInterrupted();
  return margin_statement(margin);
}

DiagnosedStatement diagnose_precision(const StagedCertificate& staged, Precision precision) {
  ProgressLine progress(fmt::format("certify: diagnosis, {}", name(precision)), staged.options.quiet);
  DiagnosisOptions options;
  options.precision = precision;
  options.seed = staged.options.seed;
  options.target = staged.running.target;
  options.interrupted = &interrupts();
  options.report = progress.report();
  const Diagnosis found = diagnose(staged.kernel, options);
  if (!found.complete) throw StageInterrupted();
  DiagnosedStatement said{precision, {}};
  for (const Property& p : found.properties) said.properties.push_back({p.name, p.value, p.sentence, p.queries});
  return said;
}

// The mutants of an effort: every so manieth, of both kinds where only verdicts are judged.
std::vector<const mutants::Mutant*> mutants_judged(std::string_view base, bool by_verdict, std::uint64_t stride,
                                                   std::size_t& exist) {
  std::vector<const mutants::Mutant*> all, judged;
  for (const mutants::Mutant& m : mutants::mutants_of(base)) all.push_back(&m);
  if (by_verdict) {
    for (const mutants::Mutant* m : mutants::value_mutants_of(base, mutants::default_magnitudes)) all.push_back(m);
  }
  exist = all.size();
  for (std::size_t i = 0; i < all.size(); i += stride) judged.push_back(all[i]);
  return judged;
}

HarnessStatement score_harness(const StagedCertificate& staged, std::string_view base) {
  const bool by_verdict = staged.kernel.exposes == Exposure::verdict;
  std::size_t exist = 0;
  MutationPlan plan;
  plan.mutants = mutants_judged(base, by_verdict, staged.size.mutant_stride, exist);
  plan.base = base;
  plan.families = families_of(*staged.kernel.predicate);
  plan.precisions = staged.precisions();
  plan.trials = staged.size.mutant_trials;
  plan.seed = staged.options.seed;
  plan.threads = staged.running.threads;
  plan.controls = false;
  ProgressLine progress("certify: faults planted in a right kernel", staged.options.quiet);
  Json score;
  const char* noticed = "refused";
  if (by_verdict) {
    const BlackBoxScore found = judge_black_boxes(plan, mutation_gate, interrupts(), progress.report());
    if (!found.complete) throw StageInterrupted();
    score = black_box_report(plan, found, level_of_mutation, "axiscert certify").data["score"];
  } else {
    const MutationResult found = run_mutation(plan, interrupts(), progress.report());
    if (!found.complete) throw StageInterrupted();
    score = mutation_report(plan, found, {}, "axiscert certify", false).data["score"];
    noticed = "caught";
  }
  HarnessStatement said;
  said.judged_by = by_verdict ? "its verdict alone, at the level logic" : "its comparison bits";
  said.made_of = base;
  said.planted = plan.mutants.size();
  said.exist = exist;
  said.queries = plan.trials;
  for (const auto& [precision, of] : score.items()) {
    const auto count = [&](const char* member) {
      return of[member].is_null() ? 0 : of[member].template get<std::uint64_t>();
    };
    said.score.put(precision) = {count("mutants"), count("judged"), count(noticed), count("survived"),
                                 count("equivalent")};
  }
  return said;
}

}  // namespace

std::vector<Precision> StagedCertificate::precisions() const {
  std::vector<Precision> all;
  for (const Precision precision : questions.precisions) {
    if (kernel.has(precision)) all.push_back(precision);
  }
  return all;
}

Stages::Stages(const OutputFolder& folder, const std::string& path, const std::string& plan_digest, bool resume)
    : folder_(folder) {
  const std::filesystem::path stored = std::filesystem::path(path) / stages_file;
  std::error_code ignored;
  if (resume && std::filesystem::exists(stored, ignored)) {
    try {
      done_ = parsed_json(read_bytes(stored.string()));
    } catch (const Json::exception&) {
      // cut off: the stages are done again
    }
  }
  if (!done_.is_object() || done_.value("plan", Json()) != plan_digest) done_ = {{"plan", plan_digest}};
  if (!done_.value(states, Json()).is_object()) done_[states] = Json::object();
}

Json Stages::get(const std::string& name, const std::function<Json()>& make) {
  if (!done_.contains(name)) {
    done_[name] = make();
    done_[states].erase(name);
    folder_.write(stages_file, done_);
  }
  return done_[name];
}

std::optional<std::string> Stages::state(const std::string& name) const {
  const auto kept = done_[states].find(name);
  if (kept == done_[states].end() || !kept->is_string()) return std::nullopt;
  return kept->get<std::string>();
}

void Stages::keep_state(const std::string& name, const std::string& state) {
  done_[states][name] = state;
  folder_.write(stages_file, done_);
}

SearchResult run_resumable_search(SearchPlan plan, Stages& stages, const std::string& name, double seconds,
                                  const std::atomic<bool>& interrupted,
                                  const std::function<void(const SearchProgress&)>& report) {
  plan.seconds = seconds;
  for (double before = 0;;) {
    double elapsed = 0;
    const SearchResult result = search(plan, stages.state(name), interrupted, [&](const SearchProgress& p) {
      elapsed = p.seconds;
      report({p.islands, p.evaluations, before + p.seconds});
    });
    stages.keep_state(name, result.state);
    if (!result.complete) throw StageInterrupted();
    if (result.evaluations >= *plan.evaluations) return result;
    before += elapsed;
  }
}

SearchesStatement run_search_stage(const StagedCertificate& staged, Stages& stages) {
  auto all = stage_of<SearchesStatement>(staged);
  if (all.reason) return all;
  if (!staged.kernel.predicate->entries[staged.kernel.entry].has_free_numbers) {
    all.reason = fmt::format("the search does not move queries of the entry {} of {}",
                             staged.kernel.predicate->entries[staged.kernel.entry].name, staged.kernel.predicate->id);
    return all;
  }
  for (const Precision precision : staged.precisions()) {
    const std::string in(name(precision));
    const std::string stage = "search " + in;
    all.precisions.put(in) =
        stages.part<SearchedStatement>(stage, [&] { return search_precision(staged, precision, stages, stage); });
  }
  return all;
}

DiagnosisStatement run_diagnosis_stage(const StagedCertificate& staged, Stages& stages) {
  auto all = stage_of<DiagnosisStatement>(staged);
  if (all.reason) return all;
  for (const Precision precision : staged.precisions()) {
    all.precisions.push_back(stages.part<DiagnosedStatement>(fmt::format("diagnosis {}", name(precision)),
                                                             [&] { return diagnose_precision(staged, precision); }));
  }
  return all;
}

SafeMarginStatement run_margin_stage(const StagedCertificate& staged, Stages& stages, const SearchesStatement& search) {
  auto all = stage_of<SafeMarginStatement>(staged);
  if (all.reason) return all;
  if (!has_sphere_radius(*staged.kernel.predicate, staged.kernel.entry)) {
    all.reason = fmt::format("the answer of {} does not depend on one radius", staged.kernel.predicate->id);
    return all;
  }
  for (const Precision precision : staged.precisions()) {
    all.precisions.push_back(stages.part<MarginStatement>(fmt::format("margin {}", name(precision)),
                                                          [&] { return measure_margin(staged, search, precision); }));
  }
  return all;
}

HarnessStatement run_harness_stage(const StagedCertificate& staged, Stages& stages) {
  for (const std::string_view base : mutants::bases) {
    if (&mutants::predicate_of(mutants::base_index(base)) != staged.kernel.predicate) continue;
    return stages.part<HarnessStatement>("harness", [&] { return score_harness(staged, base); });
  }
  HarnessStatement none;
  none.reason = fmt::format("no kernel of {} has faults to plant", staged.kernel.predicate->id);
  return none;
}

}  // namespace axiscert

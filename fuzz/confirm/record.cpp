#include "fuzz/confirm/record.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/judge/oracles.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/confirm/nearest_kernel.h"
#include "fuzz/confirm/slack.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/merge.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The statement that no kernel was run, and the claim made for the program.
RepliesRecord replies_record(const Answerers& answerers) {
  const auto given = [](const std::string& id) { return id.empty() ? std::nullopt : std::optional(id); };
  RepliesRecord record{given(answerers.claim.conforms_to),
                       given(answerers.claim.formulae),
                       answerers.kernels.front()->touching,
                       answerers.kernels.front()->may_decline,
                       {},
                       {},
                       {}};
  const Kernel& kernel = *answerers.kernels.front();
  if (kernel.limits.margin != 0) record.margin = kernel.limits.margin;
  const bool is_front = kernel.limits.sides == SidesPolicy::front || kernel.motion.sides == SidesPolicy::front;
  if (is_front) record.sides = SidesPolicy::front;
  if (answerers.replies->measure_count() != 0) record.measures = answerers.replies->measure_count();
  return record;
}

FileRecord file_record(const FileInfo& file) {
  FileRecord record;
  record.name = file.name;
  record.kind = file.kind;
  if (!file.sha256.empty()) record.sha256 = Sha256(file.sha256);
  if (record.has_queries()) record.queries = file.queries;
  if (file.kind == "mesh") {
    record.triangles = file.triangles;
    record.degenerate_triangles = file.degenerate_triangles;
    record.skipped_primitives = file.skipped_primitives;
  }
  return record;
}

// A source's queries of precisions that nobody asked for, as of those in which a kernel exists.
std::optional<std::map<Precision, std::uint64_t>> left_out_of(const Source& source, const Questions& questions) {
  std::map<Precision, std::uint64_t> left_out;
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const bool is_asked =
        std::ranges::count(questions.precisions, precision) + std::ranges::count(questions.idle, precision) != 0;
    const std::uint64_t queries = is_asked ? 0 : source.fixed_size(precision).value_or(0);
    if (queries != 0) left_out[precision] = queries;
  }
  return left_out.empty() ? std::nullopt : std::optional(left_out);
}

// The sizes of files that a time limit ended before their end: other families have none.
void put_left_in_part(const Questions& questions, const CampaignResult& result,
                      std::optional<CountsByFamily>& planned) {
  for (const CellResult& cell : result.cells) {
    const Source& source = *questions.sources[cell.source];
    const auto size = questions.fixed_size(source, cell.precision);
    if (!size || cell.queries == *size) continue;
    if (!planned) planned.emplace();
    planned->put(source.name())[cell.precision] = *size;
  }
}

}  // namespace

PlanRecord plan_record(const Plan& plan, const CampaignResult& result, const RunRequirements& required) {
  const Questions& questions = plan.questions;
  const Answerers& answerers = plan.answerers;
  PlanRecord record;
  record.axiscert = axiscert_version;
  record.predicate = questions.predicate().id;
  record.seed = {questions.seed};
  for (const Kernel* kernel : answerers.kernels) record.kernels.push_back(kernel->id);
  record.precisions = questions.precisions;
  for (const SourcePtr& source : questions.sources) {
    record.families.push_back(source->name());
    record.generators.put(source->name()) = {static_cast<std::uint64_t>(source->version()), source->exact_arithmetic(),
                                             source->purpose()};
    if (const auto file = source->file()) {
      record.files.push_back(file_record(*file));
      record.files.back().left_out = left_out_of(*source, questions);
    }
  }
  for (const FileInfo& file : answerers.plugins) record.files.push_back(file_record(file));
  const auto put_counts = [&](const CampaignResult& of, CountsByFamily& counts, auto member) {
    for (std::size_t s = 0; s < questions.sources.size(); ++s) {
      for (const CellResult& cell : of.cells) {
        if (cell.source == s) counts.put(questions.sources[s]->name())[cell.precision] = cell.*member;
      }
    }
  };
  put_counts(result, record.trials, &CellResult::queries);
  for (const SourcePtr& source : questions.sources) {
    for (const Precision precision : questions.idle) {
      if (const std::uint64_t lines = source->fixed_size(precision).value_or(0); lines != 0)
        record.trials.put(source->name())[precision] = lines;
    }
  }
  if (!result.complete && !questions.seconds)
    put_counts(planned(questions), record.planned.emplace(), &CellResult::queries);
  if (result.complete && questions.seconds) put_left_in_part(questions, result, record.planned);
  // Without a time limit the trials determine the units; an interrupted run did only some of them.
  if (!result.complete || questions.seconds) put_counts(result, record.units_done.emplace(), &CellResult::units_done);
  for (const auto& [comparison, tolerance] : plan.judging.tolerance_texts) record.tolerance.put(comparison) = tolerance;
  for (const std::string& level : required.levels) record.require.levels.push_back(level);
  if (!required.allow_unchecked.empty())
    record.allow_unchecked.emplace(required.allow_unchecked.begin(), required.allow_unchecked.end());
  record.margin_queries = margin_queries;
  if (!required.unit.empty()) record.unit = required.unit;
  if (answerers.replies) record.replies = replies_record(answerers);
  return record;
}

PlanRecord plan_record(const Plan& plan, const RunRequirements& required) {
  return plan_record(plan, planned(plan.questions), required);
}

namespace {

// A figure that the kernel does not show, or nobody asked for, was not measured: empty, and no count of zero.
Tally measured(Tally tally, const Kernel& kernel, const Tolerances& tolerances) {
  const Predicate& predicate = *kernel.predicate;
  const std::uint64_t promised = tally.trials - tally.truth.invalid - tally.verdict.outside_limits->trials;
  const std::uint64_t answered = promised - std::min(promised, tally.verdict.unanswered);
  const bool has_sides = kernel.exposes == Exposure::sides && answered != 0;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    ComparisonTally& comparison = tally.comparisons[i];
    comparison.judged = tally.with_signs;
    const bool has_errors = has_sides && *comparison.range_events + *comparison.error_without_scale < answered;
    comparison.max_error = has_errors ? std::optional(comparison.largest_error.best()) : std::nullopt;
    if (!has_errors || !tolerances[i]) comparison.tolerance_failures.reset();
    if (!has_sides) comparison.range_events = comparison.error_without_scale = std::nullopt;
  }
  for (std::size_t a = 0; a < predicate.clauses.size(); ++a) {
    bool has_tolerance = false;
    std::optional<Decimal6> max_error;
    for_each_bit(predicate.clauses[a].comparisons, [&](std::size_t i) {
      has_tolerance |= tally.comparisons[i].tolerance_failures.has_value();
      max_error = std::max(max_error, tally.comparisons[i].max_error);
    });
    tally.axes[a].judged = tally.with_signs;
    tally.axes[a].max_error = max_error;
    if (!has_sides || !has_tolerance) tally.axes[a].tolerance_failures.reset();
  }
  if (!kernel.limits.any() && kernel.motion == MotionPolicy{}) tally.verdict.outside_limits.reset();
  if (has_reference(kernel)) tally.verdict.clear.reset();
  if (!oracles_of(predicate).has_depth()) tally.verdict.depths.reset();
  if (!capabilities_of(predicate).has_engine_queries) tally.verdict.engine.reset();
  tally.contacts = given_contacts(std::move(tally.contacts), predicate, kernel.measure_count);
  return tally;
}

std::map<InputClass, ClassRecord> class_records(const ClassTally& tally, const AddressOf& address) {
  std::map<InputClass, ClassRecord> classes;
  for (const InputClass which : enumerators<InputClass>) {
    const ClassCount& count = tally.classes[which];
    if (!count.deepest.candidates().empty())
      classes[which] = {count, address(count.deepest.candidates().front().position)};
  }
  return classes;
}

// The family's figures that its tally has.
FamilyRecord counted(Tally tally, const Kernel& kernel, const Tolerances& tolerances, const AddressOf& address) {
  tally = measured(std::move(tally), kernel, tolerances);
  FamilyRecord family;
  family.trials = tally.trials;
  family.truth = tally.truth;
  family.verdict = std::move(tally.verdict);
  family.critical_radius = summary_of(std::move(tally.critical_radius));
  if (has_input_classes(kernel)) family.classes = class_records(tally.classes, address);
  if (says_contacts(kernel)) family.contacts = std::move(tally.contacts);
  if (!kernel.file.empty()) family.asked_again = tally.asked_again;
  if (kernel.exposes != Exposure::verdict) {
    family.axes = std::move(tally.axes);
    family.comparisons = std::move(tally.comparisons);
  }
  return family;
}

FamilyRecord family_of(const SeededSource& of, const Kernel& kernel, const Tolerances& tolerances, const Tally& tally,
                       const std::optional<Asymmetry>& asymmetry) {
  const AddressOf address = of.addresses();
  FamilyRecord family = counted(tally, kernel, tolerances, address);
  family.base_triangles = of.source.base_triangles(of.precision, tally.trials);
  family.exact_arithmetic = of.source.exact_arithmetic();
  if (asymmetry) {
    family.asymmetry = asymmetry_record(*asymmetry, address, kernel.measure_count != 0);
    if (!has_comparisons(kernel)) family.asymmetry->comparisons.reset();
    family.invariance = invariance_of(of, *asymmetry);
  }
  return family;
}

// The digests of the files of which somebody else's kernel consists; empty for a kernel that comes with axiscert.
std::optional<std::vector<DigestRecord>> digests_of(const std::vector<FileInfo>& plugins, const Kernel& kernel) {
  std::vector<DigestRecord> digests;
  for (const FileInfo& file : plugins) {
    if (file.kernel == kernel.id && !file.sha256.empty()) digests.push_back({file.kind, file.sha256});
  }
  return digests.empty() ? std::nullopt : std::optional(std::move(digests));
}

std::optional<NearestRecord> nearest_record(const std::optional<NearestKernel>& nearest) {
  if (!nearest) return std::nullopt;
  return NearestRecord{nearest->kernel->id, nearest->queries, nearest->wrong, nearest->both, nearest->either};
}

}  // namespace

std::map<ImageKind, ImageChangesRecord> invariance_of(const SeededSource& of, const Asymmetry& asymmetry) {
  return invariance_record(asymmetry.invariance, *image_group(of.source.name()), of.precision, of.addresses(),
                           [&](const auto& flips) { return absolute_sizes(of, flips); });
}

// Figures that levels do not read, and those that do not add up, are left out.
Json counts_json(const Kernel& kernel, const Tally& tally) {
  const FamilyRecord family = counted(tally, kernel, {}, [](std::uint64_t) { return std::string(); });
  Json json = json_of(family);
  put_unseen(json, family);
  for (const char* member : {"base_triangles", "exact_arithmetic", "axes", "comparisons"}) json.erase(member);
  for (const char* member : {"masked_links", "first_by_link", "depths", "engine_like"}) json["verdict"].erase(member);
  for (const char* member : {"median_ulps", "signed_median_ulps"}) json["critical_radius"].erase(member);
  if (family.classes) {
    for (Json& count : json["classes"]) count.erase("witness");
  }
  if (family.contacts && family.contacts->time) {
    for (const char* errors : {"late_errors", "early_errors"}) json["contacts"]["time"][errors].erase("by_power");
  }
  if (family.contacts && family.contacts->separation) json["contacts"]["separation"].erase("by_decade");
  Json& findings = json["findings"] = Json::object();
  for (const FindingKind kind : enumerators<FindingKind>) {
    if (tally.findings[kind].count != 0) findings[std::string(name(kind))] = tally.findings[kind].count;
  }
  return json;
}

std::vector<Exposure> exposures_of(const Kernel& kernel) {
  std::vector<Exposure> all;
  for (std::size_t i = 0; i <= index_of(kernel.exposes); ++i) all.push_back(static_cast<Exposure>(i));
  return all;
}

std::optional<LimitsRecord> limits_of(const Limits& limits) {
  if (!limits.any()) return std::nullopt;
  const auto bound = [](double value) { return value == 0 ? std::nullopt : std::optional(value); };
  return LimitsRecord{bound(limits.least_coordinate),
                      bound(limits.greatest_coordinate),
                      bound(limits.least_area),
                      bound(limits.least_radius),
                      bound(limits.greatest_radius),
                      bound(limits.margin),
                      limits.sides == SidesPolicy::both ? std::nullopt : std::optional(limits.sides)};
}

PolicyRecord policy_of(const MotionPolicy& policy) { return {policy.start, policy.still, policy.sides}; }

std::vector<Name> given_measures(const Kernel& kernel) {
  std::vector<Name> names;
  for (std::size_t k = 0; k < kernel.measure_count; ++k) names.push_back(kernel.predicate->measures[k].name);
  return names;
}

KernelRecord kernel_record(const std::vector<FileInfo>& plugins, const Kernel& kernel, Precision precision) {
  KernelRecord record;
  record.id = kernel.id;
  record.digest = digests_of(plugins, kernel);
  if (!kernel.declared_name.empty() && record.digest) record.name = Name(kernel.declared_name);
  record.precision = precision;
  record.summary = kernel.summary;
  if (!kernel.formulae.empty()) {
    record.formulae = kernel.formulae;
    record.reference = kernel.is_reference;
    if (kernel.predicate->claims_arithmetic) record.arithmetic = name(kernel.arithmetic);
  }
  if (has_comparisons(kernel) && kernel.predicate->has_strictness) record.strictness = kernel.strictness;
  record.exposes = exposures_of(kernel);
  record.touching = kernel.touching;
  record.limits = limits_of(kernel.limits);
  record.may_decline = kernel.may_decline;
  if (!kernel.predicate->measures.empty()) record.measures = given_measures(kernel);
  if (is_of_motions(*kernel.predicate)) record.motion = policy_of(kernel.motion);
  return record;
}

Record record_of(const Plan& plan, const CampaignResult& result, const RunRequirements& required) {
  const Questions& questions = plan.questions;
  const Answerers& answerers = plan.answerers;
  const RunningOptions& running = plan.running;
  const StoredReplies* const replies = answerers.replies.get();
  Record record;
  record.complete = result.complete;
  record.plan = plan_record(plan, result, required);
  WitnessWriter witnesses(replies, running.target);
  for (std::size_t k = 0; k < answerers.kernels.size(); ++k) {
    const Kernel& kernel = *answerers.kernels[k];
    put_loading_findings(record.findings, kernel);
    for (const Precision precision : questions.precisions) {
      if (!kernel.has(precision)) continue;
      KernelRecord& entry = record.kernels.emplace_back(kernel_record(answerers.plugins, kernel, precision));
      CriticalRadiusTally radii;
      std::vector<TalliedSource> tallied;
      for (std::size_t s = 0; s < questions.sources.size(); ++s) {
        const SeededSource of{*questions.sources[s], questions.seed, precision};
        for (const CellResult& cell : result.cells) {
          if (cell.source != s || cell.precision != precision || cell.tallies[k].trials == 0) continue;
          const Tally& tally = cell.tallies[k];
          // After an interrupted run it is not known which bases have all their images.
          const auto asymmetry =
              result.complete ? asymmetry_of(of, cell.queries, kernel, replies, running) : std::nullopt;
          entry.families.put(of.source.name()) = family_of(of, kernel, plan.judging.tolerances, tally, asymmetry);
          merge_fields(radii, tally.critical_radius);
          put_findings(record.findings, kernel, of, tally);
          witnesses.add(kernel, of, tally, asymmetry);
          tallied.push_back({of, cell.queries, &tally});
        }
      }
      entry.critical_radius = summary_of(std::move(radii));
      if (result.complete && !replies) entry.slack = slacks_of(kernel, precision, questions.seed, running.target);
      if (has_input_classes(kernel)) entry.nearest = nearest_record(nearest_kernel(kernel, tallied, running.target));
    }
  }
  record.witnesses = std::move(witnesses).take();
  return record;
}

namespace {

template <class Real>
NamedValues<std::optional<GroupNumbers>> numbers_of(const SeededSource& of, std::uint64_t position) {
  NamedValues<std::optional<GroupNumbers>> numbers;
  for (auto& [group, values] :
       groups_of_numbers(of.source.predicate().entries[of.source.entry()], of.source.make<Real>(of.seed, position)))
    numbers.put(group) = std::move(values);
  return numbers;
}

}  // namespace

std::string why_not_loaded(const Kernel& kernel) {
  std::string why;
  for (const Finding& finding : kernel.findings) why += fmt::format("{} {}", why.empty() ? ":" : ";", finding.detail);
  return why;
}

void require_loaded(const Kernel& kernel) {
  if (kernel.has(Precision::binary32) || kernel.has(Precision::binary64)) return;
  throw Error(fmt::format("--kernel {}: it could not be loaded{}", kernel.id, why_not_loaded(kernel)));
}

void put_loading_findings(std::vector<FindingRecord>& findings, const Kernel& kernel) {
  for (const Finding& finding : kernel.findings) {
    FindingRecord& record = findings.emplace_back();
    record.kernel = kernel.id;
    record.kind = finding.kind;
    record.count = 1;
    record.detail = finding.detail;
    for (const ColumnGroup& group : groups_of(kernel.predicate->entries[kernel.entry])) record.numbers.put(group.name);
  }
}

void put_findings(std::vector<FindingRecord>& findings, const Kernel& kernel, const SeededSource& of,
                  const Tally& tally) {
  for (const FindingKind kind : enumerators<FindingKind>) {
    const FindingTally& found = tally.findings[kind];
    if (found.count == 0) continue;
    findings.push_back({kernel.id, of.precision, Name(of.source.name()), kind, found.count, found.detail,
                        Name(of.address(found.first)),
                        of.precision == Precision::binary32 ? numbers_of<float>(of, found.first)
                                                            : numbers_of<double>(of, found.first)});
  }
}

}  // namespace axiscert

// The report of `axiscert ladder`.
#pragma once

#include "fuzz/sphere_triangle/formulae/ladder.h"
#include "fuzz/text/field.h"
#include "reports/instrument/data.h"
#include "reports/instrument/figures.h"
#include "reports/instrument/instrument.h"
#include "reports/instrument/sweep_axis.h"

namespace axiscert {
// ladder.json: what `axiscert ladder` writes.

// A quantile of errors.
struct ErrorQuantile {
  double value;
};
template <>
struct JsonForm<ErrorQuantile> {
  static Json write(ErrorQuantile at);
  static Json schema();
};

using WindowData = std::optional<std::array<int, 2>>;

struct FiguresData {
  ComparisonAccuracy counts;
  std::optional<std::optional<ErrorQuantile>> median_u, p99_u;
  std::optional<std::optional<Decimal6>> worst_u;
  std::optional<std::uint64_t> errors, range_events, error_without_scale;

  static constexpr std::string_view about = "Of some comparisons; errors are absent where the kernel shows no sides.";
  AXISCERT_FIELDS(
      FiguresData, inlined(&Of::counts),
      AXISCERT_OPTIONAL_FIELD(median_u, "The median error of lhs - rhs, in u of |lhs| + |rhs|; null: none."),
      AXISCERT_OPTIONAL_FIELD(p99_u, "The 99 % quantile of that."), AXISCERT_OPTIONAL_FIELD(worst_u, "The greatest."),
      AXISCERT_OPTIONAL_FIELD(errors, "How many errors were measured."),
      AXISCERT_OPTIONAL_FIELD(range_events, "How many sides left the range of normal numbers."),
      AXISCERT_OPTIONAL_FIELD(error_without_scale,
                              "How many errors have no scale: both exact sides are zero, or the right one is a root."))
};

struct KindData {
  FiguresData figures, radius;
  std::optional<FiguresData> side;

  static constexpr std::string_view about = "The same, and by side.";
  AXISCERT_FIELDS(KindData, inlined(&KindData::figures), AXISCERT_FIELD(radius, "Its radius comparisons."),
                  AXISCERT_OPTIONAL_FIELD(side, "Its side comparisons."))
};

struct LadderVerdictData {
  std::uint64_t false_separation = 0, false_contact = 0, touching_flips = 0;
  double flips_per_million = 0;

  static constexpr std::string_view about = "Verdicts against the geometry.";
  AXISCERT_FIELDS(LadderVerdictData, AXISCERT_FIELD(false_separation, "Missed contacts."),
                  AXISCERT_FIELD(false_contact, "Phantom contacts."),
                  AXISCERT_FIELD(touching_flips, "Wrong answers to spheres that touch."),
                  AXISCERT_FIELD(flips_per_million, "Wrong verdicts for a million queries."))
};

// How often a form is wrong, with the limits of that.
struct LadderRateData {
  std::uint64_t failures = 0, trials = 0, clusters = 0;
  std::optional<double> rate, low, high;

  static constexpr std::string_view about = "A rate of failures.";
  AXISCERT_FIELDS(
      LadderRateData, AXISCERT_FIELD(failures, "How many fail."),
      AXISCERT_FIELD(trials, "Of so many: queries, or comparisons of queries."),
      AXISCERT_FIELD(clusters, "Independent parts of them: queries, image groups, or triangles that queries share."),
      AXISCERT_FIELD(rate, "failures / trials; null: none was asked.", "share"),
      AXISCERT_FIELD(low, "Wilson's lower limit, 95 %, of clusters that may fail together; null: of fewer than 20.",
                     "share"),
      AXISCERT_FIELD(high, "The upper one; without a failure the rate that so many clusters exclude.", "share"))
};

struct LadderResultData {
  std::uint64_t queries = 0;
  LadderVerdictData verdict;
  RadiusSummary critical_radius;
  NamedValues<FiguresData> axes;
  NamedValues<KindData> kinds;
  NamedValues<FiguresData> comparisons;
  NamedValues<LadderRateData> rates;
  std::optional<SignedNumber> swept;

  static constexpr std::string_view about = "Of one family.";
  AXISCERT_FIELDS(
      LadderResultData, AXISCERT_FIELD(queries, "Valid queries."),
      field(&Of::verdict, figure_of("queries", "verdict", LadderVerdictData::about)),
      AXISCERT_FIELD(critical_radius, RadiusSummary::about),
      AXISCERT_FIELD(axes, "By axis: all its comparisons together."),
      AXISCERT_FIELD(kinds, "By kind of axis: plane, vertex, edge."), AXISCERT_FIELD(comparisons, "By comparison."),
      AXISCERT_FIELD(
          rates,
          "missed and phantom: wrong verdicts; plane_signs, vertex_signs and edge_signs: sign errors of comparisons."),
      field(&Of::swept, swept_field))
};

struct LadderWindowsData {
  NamedValues<WindowData> axes, kinds;

  static constexpr std::string_view about =
      "The exponents from which to which a scene can be scaled by a power of two, and nothing over- or underflows; "
      "null: none.";
  AXISCERT_FIELDS(LadderWindowsData, AXISCERT_FIELD(axes, "Of each axis."),
                  AXISCERT_FIELD(kinds, "Of each kind of axis."))
};

struct LadderKernelData {
  Name id;
  std::string summary;
  bool shows_sides = false;
  LadderWindowsData windows;
  NamedValues<LadderResultData> families;

  static constexpr std::string_view about = "One kernel.";
  AXISCERT_FIELDS(LadderKernelData, AXISCERT_FIELD(id, "The kernel."), AXISCERT_FIELD(summary, "What it computes."),
                  AXISCERT_FIELD(shows_sides, "Whether errors could be measured."),
                  AXISCERT_FIELD(windows, LadderWindowsData::about),
                  AXISCERT_FIELD(families, "What it gets wrong, by family."))
};

struct LadderStepData {
  Name from, to;

  AXISCERT_FIELDS(LadderStepData, AXISCERT_FIELD(from, "A rung."), AXISCERT_FIELD(to, "The one made from it."))
};

// Forms against each other on the same queries.
struct LadderDifferenceData {
  Name kind;
  std::optional<Name> factor;
  Name from, to, family, figure;
  std::uint64_t pairs = 1, trials = 0, clusters = 0, failures_from = 0, failures_to = 0, only_from = 0, only_to = 0;
  std::optional<SignedNumber> difference, low, high;
  std::optional<double> design_effect, p;
  bool p_is_bound = false;
  std::optional<double> mcnemar_p, holm_p, least;

  static constexpr std::string_view about = "What one form changes of another on the same queries of a family.";
  AXISCERT_FIELDS(
      LadderDifferenceData,
      AXISCERT_FIELD(kind,
                     "step: from one form to the next; pair: two forms that differ in one factor; effect: all pairs of "
                     "a factor together."),
      AXISCERT_FIELD(factor, "That in which a pair differs; null: a step."),
      AXISCERT_FIELD(from, "The form, or the level of the factor, before."), AXISCERT_FIELD(to, "After."),
      AXISCERT_FIELD(family, "The family."),
      AXISCERT_FIELD(figure, "What is counted: missed, phantom, or the signs of a kind of axis."),
      AXISCERT_FIELD(pairs, "Pairs of forms.", "pairs"),
      AXISCERT_FIELD(trials, "Queries, or comparisons of queries, times pairs."),
      AXISCERT_FIELD(clusters, "Independent parts of them."), AXISCERT_FIELD(failures_from, "Failures before."),
      AXISCERT_FIELD(failures_to, "After."), AXISCERT_FIELD(only_from, "Those before that are none after."),
      AXISCERT_FIELD(only_to, "Those after that were none before."),
      AXISCERT_FIELD(difference, "The rate after less that before; null: none was asked.", "share"),
      AXISCERT_FIELD(low,
                     "Tango's lower limit of it, 95 %, of counts divided by design_effect; null: below 20 clusters.",
                     "share"),
      AXISCERT_FIELD(high, "The upper one.", "share"),
      AXISCERT_FIELD(design_effect, "The variance over that of as many independent trials, at least 1.", "times"),
      AXISCERT_FIELD(p, "The exact sign-flip test over clusters, two-sided.", "probability"),
      AXISCERT_FIELD(p_is_bound, "Whether p is a bound of it, from above."),
      AXISCERT_FIELD(mcnemar_p, "McNemar's exact test, as if all trials were independent.", "probability"),
      AXISCERT_FIELD(holm_p, "p corrected by Holm for all differences of its kind.", "probability"),
      AXISCERT_FIELD(least,
                     "The least difference that would be found with 80 % at a level of 5 %, corrected for all of its "
                     "kind; null: none.",
                     "share"))
};

struct CostliestData {
  std::optional<Name> sign_errors, rounding_sign_errors, worst_error, range;

  AXISCERT_FIELDS(CostliestData, AXISCERT_FIELD(sign_errors, "The rung whose step adds most sign errors."),
                  AXISCERT_FIELD(rounding_sign_errors, "Those that are not of range."),
                  AXISCERT_FIELD(worst_error, "Most to the worst error."),
                  AXISCERT_FIELD(range, "Takes most of the range."))
};

struct LadderSpeedData {
  Name unit = std::string("ns a query, median");
  std::uint64_t queries = speed_queries, repetitions = speed_repetitions;
  NamedValues<NamedValues<double>> kernels;
  std::vector<Name> front;

  static constexpr std::string_view about = "Times; absent with --no-speed.";
  AXISCERT_FIELDS(
      LadderSpeedData, AXISCERT_FIELD(unit, "The unit of times."),
      AXISCERT_FIELD(queries, "Distinct queries that were timed."), AXISCERT_FIELD(repetitions, "Repetitions."),
      AXISCERT_FIELD(
          kernels,
          "Times by kernel and instruction set, `scalar` among them; scalar_least is the least of the repetitions."),
      AXISCERT_FIELD(front, "The kernels that none beats in both time and accuracy."))
};

struct LadderData : CommandData<LadderData> {
  static constexpr std::string_view format = "axiscert-ladder/4", title = "What each step of the derivation costs";
  Precision precision = Precision::binary32;
  WholeNumber seed;
  std::uint64_t trials = 0;
  std::vector<Name> families;
  std::optional<SweepData> sweep;
  std::array<int, 2> scanned_exponents{};
  std::vector<LadderKernelData> kernels;
  std::vector<LadderStepData> steps;
  std::vector<LadderDifferenceData> differences;
  NamedValues<NamedValues<CostliestData>> costliest_steps;
  std::optional<LadderSpeedData> speed;

  static constexpr std::string_view about =
      "ladder.json, which `axiscert ladder` writes. Without `speed` it depends on the command alone.";
  AXISCERT_FIELDS(LadderData, base<Of, CommandData<Of>>(), AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(seed, "The seed of every family."), AXISCERT_FIELD(trials, "Queries of each family."),
                  AXISCERT_FIELD(families, "The families asked."), field(&Of::sweep, SweepData::in_data),
                  AXISCERT_FIELD(scanned_exponents, "The exponents between which windows were looked for."),
                  AXISCERT_FIELD(kernels, "The rungs, in the order of the derivation."),
                  AXISCERT_FIELD(steps, "The steps between them."),
                  AXISCERT_FIELD(differences, LadderDifferenceData::about),
                  AXISCERT_FIELD(costliest_steps, "By family, and by kind of axis."),
                  AXISCERT_OPTIONAL_FIELD(speed, LadderSpeedData::about))
};

// Tables, plots, notes and the figures as JSON. `command` produces the report again.
InstrumentReport ladder_report(const LadderPlan& plan, const LadderResult& result, const std::string& command);
// The figures alone; all times are in the member "speed", which is absent where none were taken.
Json ladder_json(const LadderPlan& plan, const LadderResult& result,
                 const std::vector<LadderDifferenceData>& differences, const std::string& command);

// In ladder_differences.cpp: the differences, by kind, then by family; each kind corrected by itself. And what is shown
// of them: the effects whole; of steps and pairs those that are significant, and what the others could have shown.
std::vector<LadderDifferenceData> ladder_differences(const LadderPlan& plan, const LadderResult& result);
void add_difference_tables(InstrumentReport& report, const LadderPlan& plan, const LadderResult& result,
                           const std::vector<LadderDifferenceData>& differences);
void add_difference_plots(InstrumentReport& report, const LadderPlan& plan, const LadderResult& result,
                          const std::vector<LadderDifferenceData>& differences);
LadderRateData ladder_rate(const LadderResult& result, std::size_t source, std::size_t kernel, Figure figure);

}  // namespace axiscert

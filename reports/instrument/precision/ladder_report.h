// The report of `axiscert ladder`.
#pragma once

#include "fuzz/fields/field.h"
#include "fuzz/sphere_triangle/formulae/ladder.h"
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
  static Json write(ErrorQuantile at) { return std::isfinite(at.value) ? Json(at.value) : Json("beyond binary64"); }
  static Json schema() { return {{"type", {"number", "string"}}, {"minimum", 0}}; }
};

using WindowData = std::optional<std::array<int, 2>>;

struct FiguresData {
  ComparisonAccuracy counts;
  std::optional<std::optional<ErrorQuantile>> median_u, p99_u;
  std::optional<std::optional<Decimal6>> worst_u;
  std::optional<std::uint64_t> errors, range_events, error_without_scale;

  static constexpr std::string_view about = "Of some comparisons; errors are absent where the kernel shows no sides.";
  static constexpr auto fields(auto&& visit) {
    using Of = FiguresData;
    const auto may_be_absent = [](auto member, std::string_view name, std::string_view said) {
      return field(member, {.name = name, .about = said, .may_be_absent = true});
    };
    return visit(
        inlined(&Of::counts),
        may_be_absent(&Of::median_u, "median_u", "The median error of lhs - rhs, in u of |lhs| + |rhs|; null: none."),
        may_be_absent(&Of::p99_u, "p99_u", "The 99 % quantile of that."),
        may_be_absent(&Of::worst_u, "worst_u", "The greatest."),
        may_be_absent(&Of::errors, "errors", "How many errors were measured."),
        may_be_absent(&Of::range_events, "range_events", "How many sides left the range of normal numbers."),
        may_be_absent(&Of::error_without_scale, "error_without_scale",
                      "How many errors have no scale: both exact sides are zero, or the right one is a root."));
  }
};

struct KindData {
  FiguresData figures, radius;
  std::optional<FiguresData> side;

  static constexpr std::string_view about = "The same, and by side.";
  static constexpr auto fields(auto&& visit) {
    return visit(inlined(&KindData::figures), field(&KindData::radius, {"radius", "Its radius comparisons."}),
                 field(&KindData::side, {.name = "side", .about = "Its side comparisons.", .may_be_absent = true}));
  }
};

struct LadderVerdictData {
  std::uint64_t false_separation = 0, false_contact = 0, touching_flips = 0;
  double flips_per_million = 0;

  static constexpr std::string_view about = "Verdicts against the geometry.";
  static constexpr auto fields(auto&& visit) {
    using Of = LadderVerdictData;
    return visit(field(&Of::false_separation, {"false_separation", "Missed contacts."}),
                 field(&Of::false_contact, {"false_contact", "Phantom contacts."}),
                 field(&Of::touching_flips, {"touching_flips", "Wrong answers to spheres that touch."}),
                 field(&Of::flips_per_million, {"flips_per_million", "Wrong verdicts for a million queries."}));
  }
};

// How often a form is wrong, with the limits of that.
struct LadderRateData {
  std::uint64_t failures = 0, trials = 0, clusters = 0;
  std::optional<double> rate, low, high;

  static constexpr std::string_view about = "A rate of failures.";
  static constexpr auto fields(auto&& visit) {
    using Of = LadderRateData;
    return visit(
        field(&Of::failures, {"failures", "How many fail."}),
        field(&Of::trials, {"trials", "Of so many: queries, or comparisons of queries."}),
        field(&Of::clusters,
              {"clusters", "Independent parts of them: queries, image groups, or triangles that queries share."}),
        field(&Of::rate, {"rate", "failures / trials; null: none was asked.", "share"}),
        field(&Of::low,
              {"low", "Wilson's lower limit, 95 %, of clusters that may fail together; null: of fewer than 20.",
               "share"}),
        field(&Of::high,
              {"high", "The upper one; without a failure the rate that so many clusters exclude.", "share"}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = LadderResultData;
    return visit(field(&Of::queries, {"queries", "Valid queries."}),
                 field(&Of::verdict, {"verdict", LadderVerdictData::about}),
                 field(&Of::critical_radius, {"critical_radius", RadiusSummary::about}),
                 field(&Of::axes, {"axes", "By axis: all its comparisons together."}),
                 field(&Of::kinds, {"kinds", "By kind of axis: plane, vertex, edge."}),
                 field(&Of::comparisons, {"comparisons", "By comparison."}),
                 field(&Of::rates, {"rates",
                                    "missed and phantom: wrong verdicts; plane_signs, vertex_signs and edge_signs: "
                                    "sign errors of comparisons."}),
                 field(&Of::swept, swept_field));
  }
};

struct LadderWindowsData {
  NamedValues<WindowData> axes, kinds;

  static constexpr std::string_view about =
      "The exponents from which to which a scene can be scaled by a power of two, and nothing over- or underflows; "
      "null: none.";
  static constexpr auto fields(auto&& visit) {
    using Of = LadderWindowsData;
    return visit(field(&Of::axes, {"axes", "Of each axis."}), field(&Of::kinds, {"kinds", "Of each kind of axis."}));
  }
};

struct LadderKernelData {
  Name id;
  std::string summary;
  bool shows_sides = false;
  LadderWindowsData windows;
  NamedValues<LadderResultData> families;

  static constexpr std::string_view about = "One kernel.";
  static constexpr auto fields(auto&& visit) {
    using Of = LadderKernelData;
    return visit(field(&Of::id, {"id", "The kernel."}), field(&Of::summary, {"summary", "What it computes."}),
                 field(&Of::shows_sides, {"shows_sides", "Whether errors could be measured."}),
                 field(&Of::windows, {"windows", LadderWindowsData::about}),
                 field(&Of::families, {"families", "What it gets wrong, by family."}));
  }
};

struct LadderStepData {
  Name from, to;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&LadderStepData::from, {"from", "A rung."}),
                 field(&LadderStepData::to, {"to", "The one made from it."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = LadderDifferenceData;
    return visit(
        field(&Of::kind, {"kind",
                          "step: from one form to the next; pair: two forms that differ in one factor; effect: all "
                          "pairs of a factor together."}),
        field(&Of::factor, {"factor", "That in which a pair differs; null: a step."}),
        field(&Of::from, {"from", "The form, or the level of the factor, before."}), field(&Of::to, {"to", "After."}),
        field(&Of::family, {"family", "The family."}),
        field(&Of::figure, {"figure", "What is counted: missed, phantom, or the signs of a kind of axis."}),
        field(&Of::pairs, {"pairs", "Pairs of forms.", "pairs"}),
        field(&Of::trials, {"trials", "Queries, or comparisons of queries, times pairs."}),
        field(&Of::clusters, {"clusters", "Independent parts of them."}),
        field(&Of::failures_from, {"failures_from", "Failures before."}),
        field(&Of::failures_to, {"failures_to", "After."}),
        field(&Of::only_from, {"only_from", "Those before that are none after."}),
        field(&Of::only_to, {"only_to", "Those after that were none before."}),
        field(&Of::difference, {"difference", "The rate after less that before; null: none was asked.", "share"}),
        field(&Of::low,
              {"low", "Tango's lower limit of it, 95 %, of counts divided by design_effect; null: below 20 clusters.",
               "share"}),
        field(&Of::high, {"high", "The upper one.", "share"}),
        field(&Of::design_effect,
              {"design_effect", "The variance over that of as many independent trials, at least 1.", "times"}),
        field(&Of::p, {"p", "The exact sign-flip test over clusters, two-sided.", "probability"}),
        field(&Of::p_is_bound, {"p_is_bound", "Whether p is a bound of it, from above."}),
        field(&Of::mcnemar_p, {"mcnemar_p", "McNemar's exact test, as if all trials were independent.", "probability"}),
        field(&Of::holm_p, {"holm_p", "p corrected by Holm for all differences of its kind.", "probability"}),
        field(&Of::least, {"least",
                           "The least difference that would be found with 80 % at a level of 5 %, corrected for all of "
                           "its kind; null: none.",
                           "share"}));
  }
};

struct CostliestData {
  std::optional<Name> sign_errors, rounding_sign_errors, worst_error, range;

  static constexpr auto fields(auto&& visit) {
    using Of = CostliestData;
    return visit(field(&Of::sign_errors, {"sign_errors", "The rung whose step adds most sign errors."}),
                 field(&Of::rounding_sign_errors, {"rounding_sign_errors", "Those that are not of range."}),
                 field(&Of::worst_error, {"worst_error", "Most to the worst error."}),
                 field(&Of::range, {"range", "Takes most of the range."}));
  }
};

struct LadderSpeedData {
  Name unit = std::string("ns a query, median");
  std::uint64_t queries = speed_queries, repetitions = speed_repetitions;
  NamedValues<NamedValues<double>> kernels;
  std::vector<Name> front;

  static constexpr std::string_view about = "Times; absent with --no-speed.";
  static constexpr auto fields(auto&& visit) {
    using Of = LadderSpeedData;
    return visit(field(&Of::unit, {"unit", "The unit of times."}),
                 field(&Of::queries, {"queries", "Distinct queries that were timed."}),
                 field(&Of::repetitions, {"repetitions", "Repetitions."}),
                 field(&Of::kernels,
                       {"kernels",
                        "Times by kernel and instruction set, `scalar` among them; scalar_least is the least of the "
                        "repetitions."}),
                 field(&Of::front, {"front", "The kernels that none beats in both time and accuracy."}));
  }
};

struct LadderData : CommandData<LadderData> {
  static constexpr std::string_view format = "axiscert-ladder/3", title = "What each step of the derivation costs";
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
  static constexpr auto fields(auto&& visit) {
    using Of = LadderData;
    return visit(
        base<Of, CommandData<Of>>(), field(&Of::precision, {"precision", "The precision of the queries."}),
        field(&Of::seed, {"seed", "The seed of every family."}),
        field(&Of::trials, {"trials", "Queries of each family."}),
        field(&Of::families, {"families", "The families asked."}), field(&Of::sweep, SweepData::in_data),
        field(&Of::scanned_exponents, {"scanned_exponents", "The exponents between which windows were looked for."}),
        field(&Of::kernels, {"kernels", "The rungs, in the order of the derivation."}),
        field(&Of::steps, {"steps", "The steps between them."}),
        field(&Of::differences, {"differences", LadderDifferenceData::about}),
        field(&Of::costliest_steps, {"costliest_steps", "By family, and by kind of axis."}),
        field(&Of::speed, {.name = "speed", .about = LadderSpeedData::about, .may_be_absent = true}));
  }
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

// The report of `axiscert mutate`, and what it writes: mutation.json and mutation-by-verdict.json.
#pragma once

#include <map>

#include "fuzz/instruments/black_box.h"
#include "fuzz/instruments/mutation.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// The members about the run that both reports have.
struct MutationRunData {
  bool complete = true;
  Name kernel, require;
  WholeNumber seed;
  std::uint64_t trials = 0;
  std::vector<Name> families;

  AXISCERT_FIELDS(MutationRunData, AXISCERT_FIELD(complete, "False where it was interrupted."),
                  AXISCERT_FIELD(kernel, "The kernel that the mutants are made from."),
                  AXISCERT_FIELD(require, "The level of `run --require` that has to catch them."),
                  AXISCERT_FIELD(seed, "The seed of every family."),
                  AXISCERT_FIELD(trials,
                                 "Queries per family and precision on which a mutant is run, unless fewer catch it."),
                  AXISCERT_FIELD(families, "In the order in which they are run, a batch of each in turn."))
};
MutationRunData run_data(const MutationPlan& plan, bool complete, const std::string& require);

struct MutantData {
  Name id;
  Precision precision = Precision::binary32;
  Name fault, where, what;

  AXISCERT_FIELDS(
      MutantData, AXISCERT_FIELD(id, "The id that --kernel takes; there it claims the bits of its base."),
      AXISCERT_FIELD(precision, "The precision of the queries."), AXISCERT_FIELD(fault, "The kind of the fault."),
      AXISCERT_FIELD(where,
                     "An operation's number and text, a comparison, an axis, a lane, a width, or a value and its E."),
      AXISCERT_FIELD(what, "The fault in words."))
};
inline MutantData mutant_data(const mutants::Mutant& mutant, Precision precision) {
  return {mutant.id, precision, mutant.fault, mutant.where, mutant.what};
}

// mutation.json.

struct CatchData {
  Name family;
  std::uint64_t queries = 0;
  Name address;
  FlipKind kind = FlipKind::false_separation;
  double depth = 0;

  static constexpr std::string_view about = "The first wrong verdict.";
  AXISCERT_FIELDS(CatchData, AXISCERT_FIELD(family, "The family."),
                  AXISCERT_FIELD(queries, "Queries up to and including this one."),
                  AXISCERT_FIELD(address, "The address, from which `axiscert query ADDRESS` makes it again."),
                  AXISCERT_FIELD(kind, "Missed, or phantom."), AXISCERT_FIELD(depth, "As a share of the scene."))
};

struct CatchScoreData {
  std::uint64_t mutants = 0, equivalent = 0, caught = 0, survived = 0, not_judged = 0, caught_within_10000 = 0;
  std::optional<std::uint64_t> median_queries;
  std::optional<std::uint64_t> caught_by_formulae_alone;
  std::uint64_t judged() const { return caught + survived; }

  AXISCERT_FIELDS(
      CatchScoreData, AXISCERT_FIELD(mutants, "All.", "mutants"),
      AXISCERT_FIELD(equivalent, "Mutants that no query can distinguish from the kernel.", "mutants"),
      AXISCERT_FIELD(judged, "The others that were asked a valid query.", "mutants"),
      field(&Of::caught, figure_of("judged", "caught", "By a wrong verdict.", "mutants")),
      field(&Of::survived, figure_of("judged", "survived", "Neither caught nor argued to be equivalent.", "mutants")),
      AXISCERT_FIELD(not_judged, "The others that were asked no valid query.", "mutants"),
      field(&Of::caught_within_10000,
            figure_of("judged", "caught_within_10000", "By so many queries, of all families together.", "mutants")),
      AXISCERT_FIELD(median_queries,
                     "The number of queries by which half of the mutants that are not equivalent are "
                     "caught; null: they never are."),
      field(&Of::caught_by_formulae_alone,
            figure_of("judged", "caught_by_formulae_alone",
                      "Where they claim the formulae and not their bits; null without a family of exact "
                      "arithmetic.",
                      "mutants")))
};

struct CaughtMutantData {
  MutantData mutant;
  std::optional<CatchData> caught, caught_by_formulae_alone;
  std::optional<Name> equivalent;

  AXISCERT_FIELDS(CaughtMutantData, inlined(&Of::mutant),
                  AXISCERT_FIELD(caught, "The catch where it claims the bits of its base; null: none."),
                  AXISCERT_FIELD(caught_by_formulae_alone,
                                 "The catch where it claims the formulae and not their bits; `queries` are those in "
                                 "exact arithmetic; null: none."),
                  AXISCERT_FIELD(equivalent,
                                 "The argument that no query distinguishes it from its base; null where one should."))
};

struct ControlData {
  Name kernel;
  Precision precision = Precision::binary32;
  Name claims;
  std::uint64_t queries = 0, flagged = 0;

  AXISCERT_FIELDS(ControlData, AXISCERT_FIELD(kernel, "The kernel."),
                  AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(claims, "What it claims: its own bits, or the formulae alone."),
                  AXISCERT_FIELD(queries, "Valid queries asked."),
                  field(&Of::flagged, {.name = "flagged",
                                       .about = "Wrong verdicts that `logic` does not allow.",
                                       .looked_at = "queries"}))
};

struct MutationData : CommandData<MutationData> {
  static constexpr std::string_view format = "axiscert-mutation/4",
                                    title = "What the harness catches of the faults planted in a kernel";
  MutationRunData run;
  std::map<Precision, CatchScoreData> score;
  std::vector<CaughtMutantData> mutants;
  std::vector<ControlData> controls;

  static constexpr std::string_view about =
      "mutation.json, which `axiscert mutate` writes. It depends on the plan alone.";
  AXISCERT_FIELDS(MutationData, base<Of, CommandData<Of>>(), inlined(&Of::run),
                  AXISCERT_FIELD(score, "Scores by precision."),
                  AXISCERT_FIELD(mutants, "The mutants by precision, in the order of `axiscert mutate --list`."),
                  AXISCERT_FIELD(controls,
                                 "Correct kernels that are written in another way; empty where they were left out."))
};

// mutation-by-verdict.json.

struct FailureData {
  std::string family;
  Name what;

  static constexpr std::string_view about = "What the gate says.";
  AXISCERT_FIELDS(FailureData, AXISCERT_FIELD(family, "The family; empty: none in particular."),
                  AXISCERT_FIELD(what, "Why the kernel does not meet it."))
};

struct GateScoreData {
  std::uint64_t mutants = 0, equivalent = 0, refused = 0, not_judged = 0;
  std::uint64_t judged() const { return mutants - equivalent - not_judged; }
  std::uint64_t survived() const { return judged() - refused; }

  AXISCERT_FIELDS(GateScoreData, AXISCERT_FIELD(mutants, "All.", "mutants"),
                  AXISCERT_FIELD(equivalent, "Mutants that no query can distinguish from the kernel.", "mutants"),
                  AXISCERT_FIELD(judged, "The others that were asked a valid query.", "mutants"),
                  field(&Of::refused, figure_of("judged", "refused", "By the gate.", "mutants")),
                  field(&Of::survived, figure_of("judged", "survived", "Not refused.", "mutants")),
                  AXISCERT_FIELD(not_judged, "The others that were asked no valid query.", "mutants"))
};

struct DeepestWrongData {
  Name family, address;
  double depth = 0;

  AXISCERT_FIELDS(DeepestWrongData, AXISCERT_FIELD(family, "The family."),
                  AXISCERT_FIELD(address, "The address, from which `axiscert query ADDRESS` makes it again."),
                  AXISCERT_FIELD(depth, "As a share of the scene."))
};

struct SurvivalData {
  Survival counts;
  std::optional<DeepestWrongData> deepest;

  AXISCERT_FIELDS(SurvivalData, inlined(&SurvivalData::counts),
                  AXISCERT_FIELD(deepest,
                                 "The deepest of the first four wrong ones in each family and batch of 251; null: none "
                                 "but of touching spheres."))
};

struct JudgedMutantData {
  MutantData mutant;
  std::optional<double> magnitude;
  std::uint64_t trials = 0;
  std::optional<FailureData> refused;
  std::optional<Name> reason;
  std::optional<SurvivalData> survival;

  AXISCERT_FIELDS(
      JudgedMutantData, inlined(&Of::mutant), AXISCERT_FIELD(magnitude, "E; null for a fault without one."),
      AXISCERT_FIELD(trials, "Queries of each family after which it was refused, or which it passed."),
      AXISCERT_FIELD(refused, "What the gate says; null: nothing."),
      AXISCERT_FIELD(reason,
                     "Why it passed: equivalent, no-other-verdict, never-wrong, not-in-exact-arithmetic, "
                     "touching or let-pass; not-judged: no query asked was valid; null where it was refused."),
      AXISCERT_FIELD(survival, "How a survivor differs from the kernel without the fault; null for others."))
};

struct GateControlData {
  Name kernel;
  Precision precision = Precision::binary32;
  std::optional<FailureData> refused;

  AXISCERT_FIELDS(GateControlData, AXISCERT_FIELD(kernel, "The kernel."),
                  AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(refused, "What the gate says; null: nothing."))
};

struct MutationByVerdictData : CommandData<MutationByVerdictData> {
  static constexpr std::string_view format = "axiscert-mutation-by-verdict/3",
                                    title =
                                        "What a gate refuses of the faults planted in a kernel that shows its verdict "
                                        "alone";
  MutationRunData run;
  std::map<Precision, GateScoreData> score;
  std::vector<JudgedMutantData> mutants;
  std::vector<GateControlData> controls;

  static constexpr std::string_view about =
      "mutation-by-verdict.json, which `axiscert mutate --verdict-only` writes. It depends on the plan alone.";
  AXISCERT_FIELDS(MutationByVerdictData, base<Of, CommandData<Of>>(), inlined(&Of::run),
                  AXISCERT_FIELD(score, "Scores by precision."),
                  AXISCERT_FIELD(mutants,
                                 "The mutants by precision, in the order of `axiscert mutate --verdict-only --list`."),
                  AXISCERT_FIELD(controls, "Kernels that are right, judged in the same way."))
};

// mutation-of-certified.json.

struct CertifiedStepData {
  Name step, precision;
  std::uint64_t mutants = 0, shown = 0;
  std::vector<Name> equivalent_faults, faults_by_the_recording_alone;
  std::uint64_t equivalent() const { return equivalent_faults.size(); }
  std::uint64_t by_the_recording_alone() const { return faults_by_the_recording_alone.size(); }

  AXISCERT_FIELDS(
      CertifiedStepData, AXISCERT_FIELD(step, "The step."),
      AXISCERT_FIELD(precision, "The precision of the step's own numbers."),
      AXISCERT_FIELD(mutants, "Faults.", "faults"),
      AXISCERT_FIELD(shown, "Faults with which some answer of the step differs on one of the queries.", "faults"),
      AXISCERT_FIELD(equivalent, "Faults that no query shows, by an argument in proofs/certified/mutants.cpp.",
                     "faults"),
      AXISCERT_FIELD(by_the_recording_alone,
                     "Faults that none of the queries shows, and for which there is no argument.", "faults"),
      AXISCERT_FIELD(equivalent_faults, "Each by the operation that it is planted in."),
      AXISCERT_FIELD(faults_by_the_recording_alone, "Each by the operation that it is planted in."))
};

struct MutationOfCertifiedData : CommandData<MutationOfCertifiedData> {
  static constexpr std::string_view
      format = "axiscert-mutation-of-certified/2",
      title = "What queries show of the faults planted in the recorded steps of the certified predicate";
  std::uint64_t queries = 0;
  WholeNumber seed;
  std::vector<CertifiedStepData> steps;

  static constexpr std::string_view about =
      "mutation-of-certified.json, which `axiscert mutate --kernel certified` writes. It depends on the number of "
      "queries and the seed alone.";
  AXISCERT_FIELDS(MutationOfCertifiedData, base<Of, CommandData<Of>>(),
                  AXISCERT_FIELD(queries, "Queries of each step."), AXISCERT_FIELD(seed, "The seed of the queries."),
                  AXISCERT_FIELD(steps, "The steps as proofs/certified records them, without fused multiply-add."))
};

// Faults of the harness, or of an argument for equivalence; empty if there are none.
std::vector<std::string> mutation_faults(const MutationResult& result, const std::vector<Control>& controls);

// `whole`: include a row for each mutant.
InstrumentReport mutation_report(const MutationPlan& plan, const MutationResult& result,
                                 const std::vector<Control>& controls, const std::string& command, bool whole);
std::string instrument_markdown(const InstrumentReport& report);

}  // namespace axiscert

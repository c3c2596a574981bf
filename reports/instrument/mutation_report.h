// The report of `axiscert mutate`, and what it writes: mutation.json and mutation-by-verdict.json.
#pragma once

#include <map>

#include "fuzz/mutation/black_box.h"
#include "fuzz/mutation/mutation.h"
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

  static constexpr auto fields(auto&& visit) {
    using Of = MutationRunData;
    return visit(field(&Of::complete, {"complete", "False where it was interrupted."}),
                 field(&Of::kernel, {"kernel", "The kernel that the mutants are made from."}),
                 field(&Of::require, {"require", "The level of `run --require` that has to catch them."}),
                 field(&Of::seed, {"seed", "The seed of every family."}),
                 field(&Of::trials,
                       {"trials", "Queries per family and precision on which a mutant is run, unless fewer catch it."}),
                 field(&Of::families, {"families", "In the order in which they are run, a batch of each in turn."}));
  }
};
MutationRunData run_data(const MutationPlan& plan, bool complete, const std::string& require);

struct MutantData {
  Name id;
  Precision precision = Precision::binary32;
  Name fault, where, what;

  static constexpr auto fields(auto&& visit) {
    using Of = MutantData;
    return visit(
        field(&Of::id, {"id", "The id that --kernel takes; there it claims the bits of its base."}),
        field(&Of::precision, {"precision", "The precision of the queries."}),
        field(&Of::fault, {"fault", "The kind of the fault."}),
        field(
            &Of::where,
            {"where", "An operation's number and text, a comparison, an axis, a lane, a width, or a value and its E."}),
        field(&Of::what, {"what", "The fault in words."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = CatchData;
    return visit(field(&Of::family, {"family", "The family."}),
                 field(&Of::queries, {"queries", "Queries up to and including this one."}),
                 field(&Of::address, {"address", "The address, from which `axiscert query ADDRESS` makes it again."}),
                 field(&Of::kind, {"kind", "Missed, or phantom."}),
                 field(&Of::depth, {"depth", "As a share of the scene."}));
  }
};

struct CatchScoreData {
  std::uint64_t mutants = 0, equivalent = 0, caught = 0, survived = 0, caught_within_10000 = 0;
  std::optional<std::uint64_t> median_queries;
  std::uint64_t caught_by_formulae_alone = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = CatchScoreData;
    return visit(
        field(&Of::mutants, {"mutants", "All.", "mutants"}),
        field(&Of::equivalent, {"equivalent", "Mutants that no query can distinguish from the kernel.", "mutants"}),
        field(&Of::caught, {"caught", "By a wrong verdict.", "mutants"}),
        field(&Of::survived, {"survived", "Neither caught nor argued to be equivalent.", "mutants"}),
        field(&Of::caught_within_10000,
              {"caught_within_10000", "By so many queries, of all families together.", "mutants"}),
        field(&Of::median_queries,
              {"median_queries",
               "The number of queries by which half of the mutants that are not equivalent are caught; null: they "
               "never are."}),
        field(&Of::caught_by_formulae_alone,
              {"caught_by_formulae_alone", "Where they claim the formulae and not their bits.", "mutants"}));
  }
};

struct CaughtMutantData {
  MutantData mutant;
  std::optional<CatchData> caught, caught_by_formulae_alone;
  std::optional<Name> equivalent;

  static constexpr auto fields(auto&& visit) {
    using Of = CaughtMutantData;
    return visit(
        inlined(&Of::mutant),
        field(&Of::caught, {"caught", "The catch where it claims the bits of its base; null: none."}),
        field(&Of::caught_by_formulae_alone,
              {"caught_by_formulae_alone",
               "The catch where it claims the formulae and not their bits; `queries` are those in exact "
               "arithmetic; null: none."}),
        field(&Of::equivalent,
              {"equivalent", "The argument that no query distinguishes it from its base; null where one should."}));
  }
};

struct ControlData {
  Name kernel;
  Precision precision = Precision::binary32;
  Name claims;
  std::uint64_t queries = 0, flagged = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = ControlData;
    return visit(field(&Of::kernel, {"kernel", "The kernel."}),
                 field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::claims, {"claims", "What it claims: its own bits, or the formulae alone."}),
                 field(&Of::queries, {"queries", "Queries asked."}),
                 field(&Of::flagged, {"flagged", "Wrong verdicts that `logic` does not allow."}));
  }
};

struct MutationData : CommandData<MutationData> {
  static constexpr std::string_view format = "axiscert-mutation/2",
                                    title = "What the harness catches of the faults planted in a kernel";
  MutationRunData run;
  std::map<Precision, CatchScoreData> score;
  std::vector<CaughtMutantData> mutants;
  std::vector<ControlData> controls;

  static constexpr std::string_view about =
      "mutation.json, which `axiscert mutate` writes. It depends on the plan alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = MutationData;
    return visit(
        base<Of, CommandData<Of>>(), inlined(&Of::run), field(&Of::score, {"score", "Scores by precision."}),
        field(&Of::mutants, {"mutants", "The mutants by precision, in the order of `axiscert mutate --list`."}),
        field(&Of::controls,
              {"controls", "Correct kernels that are written in another way; empty where they were left out."}));
  }
};

// mutation-by-verdict.json.

struct FailureData {
  std::string family;
  Name what;

  static constexpr std::string_view about = "What the gate says.";
  static constexpr auto fields(auto&& visit) {
    return visit(field(&FailureData::family, {"family", "The family; empty: none in particular."}),
                 field(&FailureData::what, {"what", "Why the kernel does not meet it."}));
  }
};

struct GateScoreData {
  std::uint64_t mutants = 0, equivalent = 0, refused = 0;
  std::uint64_t survived() const { return mutants - equivalent - refused; }

  static constexpr auto fields(auto&& visit) {
    using Of = GateScoreData;
    return visit(
        field(&Of::mutants, {"mutants", "All.", "mutants"}),
        field(&Of::equivalent, {"equivalent", "Mutants that no query can distinguish from the kernel.", "mutants"}),
        field(&Of::refused, {"refused", "By the gate.", "mutants"}),
        field(&Of::survived, {"survived", "Neither refused nor equivalent.", "mutants"}));
  }
};

struct DeepestWrongData {
  Name family, address;
  double depth = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = DeepestWrongData;
    return visit(field(&Of::family, {"family", "The family."}),
                 field(&Of::address, {"address", "The address, from which `axiscert query ADDRESS` makes it again."}),
                 field(&Of::depth, {"depth", "As a share of the scene."}));
  }
};

struct SurvivalData {
  Survival counts;
  std::optional<DeepestWrongData> deepest;

  static constexpr auto fields(auto&& visit) {
    return visit(
        inlined(&SurvivalData::counts),
        field(&SurvivalData::deepest,
              {"deepest",
               "The deepest of the first four wrong ones in each family and batch of 251; null: none but of touching "
               "spheres."}));
  }
};

struct JudgedMutantData {
  MutantData mutant;
  std::optional<double> magnitude;
  std::uint64_t trials = 0;
  std::optional<FailureData> refused;
  std::optional<Name> reason;
  std::optional<SurvivalData> survival;

  static constexpr auto fields(auto&& visit) {
    using Of = JudgedMutantData;
    return visit(
        inlined(&Of::mutant), field(&Of::magnitude, {"magnitude", "E; null for a fault without one."}),
        field(&Of::trials, {"trials", "Queries of each family after which it was refused, or which it passed."}),
        field(&Of::refused, {"refused", "What the gate says; null: nothing."}),
        field(&Of::reason,
              {"reason",
               "Why it passed: equivalent, no-other-verdict, never-wrong, not-in-exact-arithmetic, touching or "
               "let-pass; null where it was refused."}),
        field(&Of::survival,
              {"survival", "How a survivor differs from the kernel without the fault; null for others."}));
  }
};

struct GateControlData {
  Name kernel;
  Precision precision = Precision::binary32;
  std::optional<FailureData> refused;

  static constexpr auto fields(auto&& visit) {
    using Of = GateControlData;
    return visit(field(&Of::kernel, {"kernel", "The kernel."}),
                 field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::refused, {"refused", "What the gate says; null: nothing."}));
  }
};

struct MutationByVerdictData : CommandData<MutationByVerdictData> {
  static constexpr std::string_view format = "axiscert-mutation-by-verdict/2",
                                    title =
                                        "What a gate refuses of the faults planted in a kernel that shows its verdict "
                                        "alone";
  MutationRunData run;
  std::map<Precision, GateScoreData> score;
  std::vector<JudgedMutantData> mutants;
  std::vector<GateControlData> controls;

  static constexpr std::string_view about =
      "mutation-by-verdict.json, which `axiscert mutate --verdict-only` writes. It depends on the plan alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = MutationByVerdictData;
    return visit(
        base<Of, CommandData<Of>>(), inlined(&Of::run), field(&Of::score, {"score", "Scores by precision."}),
        field(&Of::mutants,
              {"mutants", "The mutants by precision, in the order of `axiscert mutate --verdict-only --list`."}),
        field(&Of::controls, {"controls", "Kernels that are right, judged in the same way."}));
  }
};

// mutation-of-certified.json.

struct CertifiedStepData {
  Name step, precision;
  std::uint64_t mutants = 0, shown = 0;
  std::vector<Name> equivalent_faults, faults_by_the_recording_alone;
  std::uint64_t equivalent() const { return equivalent_faults.size(); }
  std::uint64_t by_the_recording_alone() const { return faults_by_the_recording_alone.size(); }

  static constexpr auto fields(auto&& visit) {
    using Of = CertifiedStepData;
    return visit(
        field(&Of::step, {"step", "The step."}),
        field(&Of::precision, {"precision", "The precision of the step's own numbers."}),
        field(&Of::mutants, {"mutants", "Faults.", "faults"}),
        field(&Of::shown,
              {"shown", "Faults with which some answer of the step differs on one of the queries.", "faults"}),
        field(&Of::equivalent,
              {"equivalent", "Faults that no query shows, by an argument in proofs/certified/mutants.cpp.", "faults"}),
        field(&Of::by_the_recording_alone,
              {"by_the_recording_alone", "Faults that none of the queries shows, and for which there is no argument.",
               "faults"}),
        field(&Of::equivalent_faults, {"equivalent_faults", "Each by the operation that it is planted in."}),
        field(&Of::faults_by_the_recording_alone,
              {"faults_by_the_recording_alone", "Each by the operation that it is planted in."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = MutationOfCertifiedData;
    return visit(
        base<Of, CommandData<Of>>(), field(&Of::queries, {"queries", "Queries of each step."}),
        field(&Of::seed, {"seed", "The seed of the queries."}),
        field(&Of::steps, {"steps", "The steps as proofs/certified records them, without fused multiply-add."}));
  }
};

// Faults of the harness, or of an argument for equivalence; empty if there are none.
std::vector<std::string> mutation_faults(const MutationResult& result, const std::vector<Control>& controls);

// `whole`: include a row for each mutant.
InstrumentReport mutation_report(const MutationPlan& plan, const MutationResult& result,
                                 const std::vector<Control>& controls, const std::string& command, bool whole);
std::string instrument_markdown(const InstrumentReport& report);

}  // namespace axiscert

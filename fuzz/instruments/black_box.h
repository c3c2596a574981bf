// The score of the harness where a mutant shows its verdict alone, as most kernels of others do: which mutants a gate
// refuses, and why it lets the others pass.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/instruments/mutation.h"
#include "fuzz/record/record.h"
#include "fuzz/text/merge.h"

namespace axiscert {

// A gate's answer to a record: an entry for each way in which a kernel does not meet it. The gates are in a later
// layer, and the only place where a requirement is judged.
struct GateFailure {
  std::string kernel, precision, family, what;
};
using Gate = std::function<std::vector<GateFailure>(const Record& record)>;

// A wrong verdict: the deeper of two, or the earlier.
struct DeepestWrong {
  const Family* family;
  std::uint64_t position;
  double depth;

  void merge(const DeepestWrong& later) {
    if (later.depth > depth) *this = later;
  }
};

// Why a mutant passes: how it differs from the kernel that it is made from on all queries asked.
struct Survival {
  std::uint64_t queries = 0, valid = 0, other_verdicts = 0, wrong = 0, wrong_in_exact = 0, touching_in_exact = 0;
  std::optional<DeepestWrong> deepest;  // of the first wrong ones of each family and batch

  double depth() const { return deepest ? deepest->depth : 0; }
  AXISCERT_FIELDS(Survival, AXISCERT_FIELD(queries, "Of all families together."),
                  AXISCERT_FIELD(valid, "Of these, the valid ones; 0: it was not judged."),
                  AXISCERT_FIELD(other_verdicts, "Verdicts other than that of the kernel without the fault."),
                  AXISCERT_FIELD(wrong, "Other verdicts that are wrong."),
                  field(&Of::wrong_in_exact, {"wrong_in_exact_arithmetic",
                                              "Of these, in families with exact arithmetic, touching spheres apart."}),
                  field(&Of::touching_in_exact,
                        {"touching_in_exact_arithmetic",
                         "Of the wrong ones, touching spheres in families with exact arithmetic."}),
                  journalled(&Of::deepest))
};

struct BlackBoxResult {
  const mutants::Mutant* mutant;
  Precision precision;
  bool is_as_base = false;  // its magnitude is lost in this precision: nothing distinguishes it from its base
  std::optional<GateFailure> refused;
  std::uint64_t trials = 0;  // queries of each family that it was refused after, or passed
  std::optional<Survival> survival;
};

// A kernel that is right, as a black box: the gate must let it pass.
struct BlackBoxControl {
  std::string id;
  Precision precision;
  std::optional<GateFailure> refused;
};

struct BlackBoxScore {
  std::vector<BlackBoxResult> mutants;  // by precision, in the order of the plan
  std::vector<BlackBoxControl> controls;
  bool complete = true;  // false: interrupted
};

// The record that `run` makes of these kernels, of one predicate, on the first `trials` queries of each of the plan's
// families. Throws OracleDisagreement.
Record record_of_kernels(const MutationPlan& plan, Precision precision, std::uint64_t trials,
                         std::vector<const Kernel*> kernels);

// Runs each mutant in rounds of more and more queries, until the gate refuses it or it has passed on all of the plan's.
// The mutants may be of both kinds (mutants_of, value_mutants_of). `interrupted` is polled between groups of mutants;
// `report` may be empty. The result depends on the plan and the gate, not on the threads. Throws OracleDisagreement.
BlackBoxScore judge_black_boxes(const MutationPlan& plan, const Gate& gate, const std::atomic<bool>& interrupted,
                                const ShowProgress& report);

}  // namespace axiscert

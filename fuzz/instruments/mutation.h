// The score of the harness itself: which mutants a run would detect, by which family and after how many queries.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/mutants/mutant.h"

namespace axiscert {

struct MutationPlan {
  std::vector<const mutants::Mutant*> mutants;  // all of one base
  std::string base;
  std::vector<const Family*> families;
  std::vector<Precision> precisions;
  std::uint64_t trials = 0;  // per family and precision
  std::uint64_t seed = 1;
  int threads = 1;
  bool controls = true;  // judge_black_boxes also judges kernels that are right
};

// The level of `run --require` by which mutants are judged.
inline constexpr const char* level_of_mutation = "logic";

// The first wrong verdict that it does not allow. Families are asked in turn, one batch each.
struct Catch {
  const Family* family;
  std::uint64_t position;  // position in the family
  std::uint64_t queries;   // number asked up to and including this one, over all families
  FlipKind kind;
  double depth;
};

struct MutantResult {
  const mutants::Mutant* mutant;
  Precision precision;
  // Claiming the bits of its base, so that every wrong verdict that the base does not give is one of implementation.
  std::optional<Catch> by_bits;
  // Claiming only the formulae, as a user's own kernel does: a wrong verdict counts if arithmetic is exact and the
  // sphere does not touch. `queries` are those of such families.
  std::optional<Catch> by_formulae;
  // Whether its comparison bits equalled the base's on all queries asked.
  bool same_bits = true;
};

struct MutationResult {
  std::vector<MutantResult> mutants;  // by precision, in the order of the plan
  std::set<Precision> judged;         // those with a valid query: no other shows a fault
  bool complete = true;               // false: interrupted
};

// `interrupted` is polled, and `report` called, between batches; `report` may be empty. The result depends on the plan,
// not on its threads. Every catch is confirmed by all oracles. Throws OracleDisagreement, and HarnessFault if the judge
// does not confirm a catch.
MutationResult run_mutation(const MutationPlan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report);

// Whether a wrong verdict on a family counts against a kernel that claims formulae, but not how it rounds: arithmetic
// is exact there, and in one unit of length, as `--require logic` has it. In others a kernel that computes in a
// narrower precision may leave its range.
inline bool shows_formulae(std::string_view family, bool exact_arithmetic) {
  return exact_arithmetic && image_group(family) == nullptr;
}

// A correct kernel in another form, judged in the same way as a mutant.
struct Control {
  std::string id;
  bool claims_bits;  // those of its own arithmetic; otherwise the formulae only
  Precision precision;
  std::uint64_t queries = 0, flagged = 0;  // valid ones; flagged: wrong verdicts that `logic` does not allow
};
std::vector<Control> run_controls(const MutationPlan& plan, std::uint64_t trials, const std::atomic<bool>& interrupted,
                                  const ShowProgress& report = {});

// Mutants that no query can distinguish from their base, each with the reason: fuzz/instruments/equivalent_mutants.txt.
// A line is NAME: REASON. Each of them has the same comparison bits as its base on every query; the tests check that in
// addition to checking that none is ever caught.
using Equivalents = std::map<std::string, std::string>;
const Equivalents& equivalent_mutants();
// Throws Error that names the line and says what would be right.
Equivalents parse_equivalent_mutants(const std::string& text, const std::string& file);

}  // namespace axiscert

// Which mutants a run would catch, by which family and after how many queries: the score of the harness itself.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "kernel/sphere_triangle/mutants/mutant.h"

namespace axiscert {

struct MutationPlan {
  std::vector<const mutants::Mutant*> mutants;  // of one base
  std::string base;
  std::vector<const Family*> families;
  std::vector<Precision> precisions;
  std::uint64_t trials = 0;  // per family and precision
  std::uint64_t seed = 1;
  int threads = 1;
};

// The first wrong verdict that a requirement of `logic` does not allow. Families are asked in turn, a batch of each.
struct Catch {
  const Family* family;
  std::uint64_t position;  // in the family
  std::uint64_t queries;   // that were asked until then, it included, of all families
  FlipKind kind;
  double depth;
};

struct MutantResult {
  const mutants::Mutant* mutant;
  Precision precision;
  // It claims the bits of its base, so every wrong verdict that the base does not give is one of implementation.
  std::optional<Catch> by_bits;
  // It claims the formulae alone, as somebody's own kernel does: a wrong verdict counts where arithmetic is exact and
  // the sphere does not touch. `queries` are those of such families.
  std::optional<Catch> by_formulae;
  // Its comparison bits were the base's on all queries that it was asked.
  bool same_bits = true;
};

struct MutationResult {
  std::vector<MutantResult> mutants;  // by precision, in the order of the plan
  bool complete = true;               // false: interrupted
};

// `interrupted` is polled, and `report` called, between batches. The result depends on the plan, and not on its
// threads. Every catch is confirmed by all oracles. Throws OracleDisagreement, and HarnessFault where the judge does
// not confirm.
MutationResult run_mutation(const MutationPlan& plan, const std::atomic<bool>& interrupted,
                            const std::function<void(const Progress&)>& report);

// A kernel that is right and written otherwise, judged as a mutant is.
struct Control {
  std::string id;
  bool claims_bits;  // of its own arithmetic; else the formulae alone
  Precision precision;
  std::uint64_t queries = 0, flagged = 0;  // wrong verdicts that `logic` does not allow
};
std::vector<Control> run_controls(const MutationPlan& plan, std::uint64_t trials, const std::atomic<bool>& interrupted);

// Mutants that no query can tell from their base, each with the reason: fuzz/mutation/equivalent.txt. A line is NAME:
// REASON. All of them answer their base's comparison bits, every one, which is what is checked beside that none is ever
// caught.
using Equivalents = std::map<std::string, std::string>;
const Equivalents& equivalent_mutants();
// Throws Error that names the line and says what would be right.
Equivalents parse_equivalent_mutants(const std::string& text, const std::string& file);

}  // namespace axiscert

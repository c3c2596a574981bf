// The report of `axiscert mutate --verdict-only`: why a mutant that shows its verdict alone passed a gate, and how many
// did.
#pragma once

#include <string>
#include <vector>

#include "fuzz/instruments/black_box.h"
#include "reports/instrument/instrument.h"
#include "reports/instrument/mutation_report.h"
#include "reports/wording/summary.h"

namespace axiscert::black_box {
inline bool is_equivalent(const BlackBoxResult& r) {
  return r.is_as_base || equivalent_mutants().contains(r.mutant->id);
}
inline bool has_survived(const BlackBoxResult& r) { return !r.refused && !is_equivalent(r); }
inline bool has_magnitude(const BlackBoxResult& r) { return r.mutant->value != mutants::ValueFault::none; }

// Why a mutant passed: the first of these that holds.
struct PassReason {
  const char *id, *sentence;
};
inline constexpr PassReason
    equivalent = {"equivalent", "nothing distinguishes it from the kernel"},
    not_shown = {"no-other-verdict", "no verdict differs from the kernel's on any query asked"},
    never_wrong = {"never-wrong", "its verdicts differ, and none of those is wrong"},
    rounding = {"not-in-exact-arithmetic",
                "wrong only in families whose arithmetic rounds, where a kernel without formulae may be"},
    touching = {"touching", "in exact arithmetic wrong only on spheres that touch, which are not counted"},
    let_pass = {"let-pass", "wrong in exact arithmetic, and the gate does not count it"},
    no_valid_query = {"not-judged", "no query asked was valid: it was not judged"};

inline bool is_not_judged(const BlackBoxResult& r) { return has_survived(r) && r.survival && r.survival->valid == 0; }

inline const PassReason& reason_of(const BlackBoxResult& r) {
  if (is_equivalent(r)) return equivalent;
  const Survival& s = *r.survival;
  if (s.valid == 0) return no_valid_query;
  if (s.other_verdicts == 0) return not_shown;
  if (s.wrong == 0) return never_wrong;
  if (s.wrong_in_exact != 0) return let_pass;
  return s.touching_in_exact != 0 ? touching : rounding;
}

struct BoxScore : GateScoreData {
  void add(const BlackBoxResult& r) {
    ++mutants;
    equivalent += is_equivalent(r);
    refused += !is_equivalent(r) && r.refused;
    not_judged += is_not_judged(r);
  }
  std::vector<std::string> cells() const {
    if (not_judged != 0) return {thousands(mutants), thousands(equivalent), "-", "not judged"};
    return {thousands(mutants), thousands(equivalent), thousands(refused), thousands(survived())};
  }
};

}  // namespace axiscert::black_box

namespace axiscert {
// Answers that a gate that is right would not give: it refused a kernel that is right, or a mutant that nothing
// distinguishes from one. Empty if there is none.
std::vector<std::string> black_box_faults(const BlackBoxScore& score);

InstrumentReport black_box_report(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                                  const std::string& command);

// The figures of the report.
Json black_box_json(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                    const std::string& command);

}  // namespace axiscert

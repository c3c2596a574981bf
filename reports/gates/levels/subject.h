// A kernel in one precision, as a level judges it: its entry of a record, with what the levels ask of it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/record/record.h"
#include "reports/evidence/evidence.h"

namespace axiscert {

// One way in which a kernel falls short.
struct Failure {
  std::string kernel, precision, family;  // precision and family are empty for a kernel that could not be loaded
  std::uint64_t count;                    // number of wrong verdicts, or of the cases that `what` names
  std::string what;                       // for example "missed contacts"
  std::string witness;                    // the deepest one that shows it; empty where none was stored

  std::string text() const;
  static constexpr auto fields(auto&& visit) {
    using Of = Failure;
    return visit(
        journalled(&Of::kernel), journalled(&Of::precision),
        field(&Of::family, {"family", "Empty for a kernel that could not be loaded."}),
        field(&Of::count, {"count", "Number of queries."}), field(&Of::what, {"what", "What is wrong with them."}),
        field(&Of::witness, {"witness", "The deepest one, by its id in the record; empty where none was stored."}));
  }
};

// A family as a level looks at it, in queries, or in pairs of a query and its image.
struct FamilyLook {
  std::uint64_t concerned = 0;  // valid ones of the plan that the level's definition concerns
  std::uint64_t looked_at = 0;  // those that are promised, and whose answer the level judged
  std::uint64_t declined = 0;   // of pairs: those with an answer `undecided`; declined queries are in the evidence
};

class Subject {
 public:
  // `kernel` is one of the record's. Both have to outlive the subject.
  Subject(const Record& record, const KernelRecord& kernel) : record_(record), kernel_(kernel) {}

  const Record& record() const { return record_; }
  const KernelRecord& kernel() const { return kernel_; }
  const NamedValues<FamilyRecord>& families() const { return kernel_.families; }

  // The cause of a wrong verdict is told by these.
  enum class Basis {
    reference,  // its formulae and their bits: every link is told apart
    formulae,   // its formulae, evaluated in its own way: range, rounding and implementation are not told apart
    verdicts    // nothing but the verdict
  };
  Basis basis() const;
  // How much of a family there is to judge it by.
  Evidence evidence(const FamilyRecord& result) const { return evidence_of(kernel_, result); }
  // The look of a level that judges every verdict of a family.
  FamilyLook whole_look(const FamilyRecord& result) const;
  // The look of one that judges pairs of a query and its image. Pairs with a query outside the limits are in no count:
  // there may be as many as such queries.
  FamilyLook pairs_look(const FamilyRecord& result, std::uint64_t compared, std::uint64_t declined) const;

  using Shows = std::function<bool(const FlipRecord& verdict_flip)>;
  // Adds a failure of this kernel, unless `count` is 0; its witness is the deepest of which a flip of the verdict
  // `shows` it.
  void add(std::vector<Failure>& failures, const std::string& family, std::uint64_t count, const std::string& what,
           const Shows& shows, bool touching_counts = true) const;
  // The same for wrong verdicts with a broken link; for an unattributed one, those in exact arithmetic.
  void add_link(std::vector<Failure>& failures, const std::string& family, Link link, std::uint64_t count) const;

  // Adds a failure of this kernel, unless `count` is 0; its witness is the first that was kept for a reason that begins
  // with `reason`.
  void add_shown(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                 const std::string& what, std::string_view reason) const;

  // Adds a failure of this kernel that two queries show together, unless `count` is 0; the witness is the image. Empty:
  // none is known.
  void add_pair(std::vector<Failure>& failures, const std::string& family, std::uint64_t count, const std::string& what,
                const std::optional<AddressPair>& pair) const;

  std::uint64_t wrong_verdicts() const;  // over all families
  std::uint64_t decided() const;         // over all families
  std::string list_of_families() const;  // "general, tangent", or "26 families"

 private:
  Failure failure(const std::string& family, std::uint64_t count, const std::string& what) const;
  bool is_of(const WitnessRecord& witness, const std::string& family) const;

  const Record& record_;
  const KernelRecord& kernel_;
};

}  // namespace axiscert

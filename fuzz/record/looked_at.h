// How much an instrument looked at: the queries that it asked a kernel, by what became of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "exact/judge/oracles.h"
#include "fuzz/record/tally.h"
#include "fuzz/text/merge.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/query_shape.h"
#include "kernel/kernel.h"

namespace axiscert {

// Only decided queries show anything about a kernel: nothing wrong among none of them says nothing.
struct LookedAt {
  std::uint64_t decided = 0, undecided = 0, invalid = 0, unanswered = 0;  // promised queries, by the answer
  std::uint64_t outside_limits = 0;  // valid ones on which the kernel promises nothing, whatever it answered
  std::uint64_t no_query = 0;        // not valid: no answer could be wrong

  // An answer to a promised query that no kernel may give: `invalid`, none, or `undecided` of one that does not declare
  // that it may decline.
  struct Fault {
    std::uint64_t place;  // the first is that of the least place
    Verdict said;
    QueryLine query;

    void merge(const Fault& other) {
      if (other.place < place) *this = other;
    }
    bool operator==(const Fault&) const = default;
    AXISCERT_FIELDS(Fault, journalled(&Fault::place), AXISCERT_FIELD(said, "The answer."),
                    AXISCERT_FIELD(query, "A line of a query file."))
  };
  std::optional<Fault> first_fault = {};

  std::uint64_t promised() const { return decided + undecided + invalid + unanswered; }
  std::uint64_t asked() const { return promised() + outside_limits + no_query; }
  std::uint64_t faults(bool may_decline) const { return invalid + unanswered + (may_decline ? 0 : undecided); }

  void add(Verdict said) {
    switch (said) {
      case Verdict::contact:
      case Verdict::separated:
        ++decided;
        break;
      case Verdict::undecided:
        ++undecided;
        break;
      case Verdict::invalid:
        ++invalid;
        break;
      case Verdict::unanswered:
        ++unanswered;
        break;
    }
  }
  bool operator==(const LookedAt&) const = default;

  static constexpr std::string_view about =
      "Queries that were asked, by what became of them. Only decided ones show anything about the kernel.";
  AXISCERT_FIELDS(
      LookedAt, AXISCERT_FIELD(asked, "All of them."),
      AXISCERT_FIELD(decided, "Valid, within the kernel's limits, and called contact or separated."),
      AXISCERT_FIELD(undecided, "It declined: a fault, unless it declares that it may."),
      AXISCERT_FIELD(invalid, "It called a valid query invalid: a fault."),
      AXISCERT_FIELD(unanswered, "It gave no answer, or one that is none: a fault."),
      AXISCERT_FIELD(outside_limits, "Outside its limits or policies, whatever it answered."),
      AXISCERT_FIELD(no_query, "Not valid, whatever it answered."),
      AXISCERT_FIELD(first_fault,
                     "The first answer that no kernel may give to a query within its limits; null: none, or not kept."))
};

// The counts of a cell of a run, without its first fault.
inline LookedAt looked_at_of(const Tally& tally) {
  const VerdictTally& verdict = tally.verdict;
  LookedAt found;
  found.undecided = verdict.undecided;
  found.invalid = verdict.invalid;
  found.unanswered = verdict.unanswered;
  found.outside_limits = verdict.outside_limits->trials;
  found.no_query = tally.truth.invalid;
  found.decided = tally.trials - found.asked();
  return found;
}

// Counts what one kernel answers. Keeps a reference to it.
template <class Real>
class AnswerCounter {
 public:
  // `are_valid`: the queries are known to be; else the oracles are asked where a fault would be counted.
  explicit AnswerCounter(const Kernel& kernel, bool are_valid = false)
      : kernel_(kernel), are_valid_(are_valid), shape_(shape_of(kernel.predicate->entries[kernel.entry])) {}

  // `place` orders the faults.
  void add(LookedAt& into, const Numbers<Real>& q, Verdict said, std::uint64_t place) const {
    const bool is_decided = said == Verdict::contact || said == Verdict::separated;
    if (!may_be_valid(shape_, q) || (!is_decided && is_no_query(q))) {
      ++into.no_query;
      return;
    }
    if (!is_promised(kernel_, q)) {
      ++into.outside_limits;
      return;
    }
    into.add(said);
    if (is_decided || (said == Verdict::undecided && kernel_.may_decline)) return;
    if (into.first_fault && into.first_fault->place <= place) return;
    into.first_fault = {place, said, query_line({"", precision_of<Real>, q, kernel_.predicate, kernel_.entry})};
  }

 private:
  bool is_no_query(const Numbers<Real>& q) const { return !are_valid_ && !oracles_of(kernel_).is_valid(q); }

  const Kernel& kernel_;
  bool are_valid_;
  QueryShape shape_;
};

}  // namespace axiscert

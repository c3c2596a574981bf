// The evidence of a run about one kernel in one precision: how many queries there were, what the kernel's own promise
// leaves out, what it declined, and what is left to judge it by. Everything that says "met" says it of these counts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"
#include "kernel/names.h"
#include "reports/wording/summary.h"

namespace axiscert {

struct Tally;

// So many right answers show, with 95 % confidence, that fewer than 5 % of such queries are answered wrongly:
// 0.95^59 < 0.05. Fewer in a family are no evidence about it.
inline constexpr std::uint64_t least_looked_at = 59;
// Contacts, and separations, over all families: fewer than 10 % of either are answered wrongly, 0.9^29 < 0.05. Limits
// that leave one kind alone are no evidence about a predicate.
inline constexpr std::uint64_t least_of_each_kind = 29;
// The share of a family's promised contacts, and of its promised separations, that a kernel which may decline has to
// decide, unless --require decided=SHARE names another.
inline constexpr double least_decided_share = 0.5;

// Numbers of queries of one family, or of several added up.
struct Evidence {
  std::uint64_t population = 0;  // valid ones of the plan
  std::uint64_t outside = 0;     // of these, beyond the kernel's limits or policies
  std::uint64_t touching = 0;    // of the rest, touching, where it makes no promise of touch
  // The rest is promised, and counted here by the right verdict: a query that touches is a separation to a kernel that
  // promises so.
  std::uint64_t contacts = 0, separations = 0;
  std::uint64_t declined_contacts = 0, declined_separations = 0;  // promised, and answered `undecided`
  std::uint64_t invalid = 0, unanswered = 0;  // within the limits, and answered `invalid` or not at all
  std::uint64_t decided_contacts = 0, decided_separations = 0;  // promised, and called one of the two

  std::uint64_t promised() const { return contacts + separations; }
  std::uint64_t declined() const { return declined_contacts + declined_separations; }
  NoVerdict no_verdict() const { return {declined(), invalid, unanswered}; }
  // Promised, and called separated or contact. An answer `invalid` or none may be to a touching query, which is not
  // promised: then this is too small, and the level fails in any case.
  std::uint64_t decided() const;
  // Those of them that could be wrong in this way: contacts could be missed, separations called contact.
  std::uint64_t decided_for(FlipKind kind) const;
  std::uint64_t promised_for(FlipKind kind) const {
    return kind == FlipKind::false_separation ? contacts : separations;
  }
  void add(const Evidence& other);

  static constexpr std::string_view about = "The queries of the families that a level requires.";
  AXISCERT_FIELDS(Evidence, AXISCERT_FIELD(population, "Valid queries."),
                  field(&Of::outside, {"outside_limits", "Of these, beyond the kernel's limits or policies."}),
                  field(&Of::touching, {"touching_not_promised",
                                        "Of the rest, those that touch, where the kernel promises nothing of touch."}),
                  journalled(&Of::contacts), journalled(&Of::separations), AXISCERT_FIELD(promised, "The rest."),
                  journalled(&Of::declined_contacts), journalled(&Of::declined_separations),
                  journalled(&Of::decided_contacts), journalled(&Of::decided_separations),
                  AXISCERT_FIELD(declined, "Promised, and answered undecided."),
                  AXISCERT_FIELD(invalid, "Within the limits, and called invalid."),
                  AXISCERT_FIELD(unanswered, "Within the limits, and without an answer."),
                  AXISCERT_FIELD(decided, "Promised, and called separated or contact."))
};

// `touching`: what the kernel promises of touch. Contacts by that, whatever the kernel's limits.
std::uint64_t contacts_of(TouchingPolicy touching, const TruthCounts& truth);
Evidence evidence_of(TouchingPolicy touching, const Tally& tally);
Evidence evidence_of(TouchingPolicy touching, const FamilyCounts& counts);
Evidence evidence_of(const KernelRecord& kernel, const FamilyRecord& result);
// The evidence of all families of a kernel.
Evidence evidence_of(const KernelRecord& kernel);

// Whether `declined` of so many is more than the kernel may: fewer than `share` of them are decided.
bool declines_too_many(std::uint64_t declined, std::uint64_t of, double share);

// "1 of 45 promised queries looked at", and where there are some ", 44 declined: it decides 2.2 %", ", 2 called
// invalid", ", 7 without an answer", ", 2,655 of 2,700 outside its limits", ", 3 touching, of which it promises
// nothing".
std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at);
// The same of a part of them, of `of` promised: "1 of 12 promised contacts looked at, ...".
std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at, std::uint64_t of, std::string_view part);

// "34 of 834 separations decided", or of the contacts, which could be wrong in this way.
std::string decided_text(const Evidence& evidence, FlipKind kind);

// 100 (1 - 0.05^(1/n)): the per cent of wrong answers below which the rate is, with 95 % confidence, after n right
// ones.
double upper_bound_percent(std::uint64_t n);

// For zero failures of a kernel in a family, or in all of them: the 95 % upper limit of their rate, per million
// queries of this generator, 1e6 (1 - 0.05^(1/N)) for N base triangles, or N decided queries where these are fewer.
// Negative where none was decided.
double zero_limit_per_million(const KernelRecord& kernel, const FamilyRecord& family);
// The same of the decided queries that could be wrong in this way.
double zero_limit_per_million(const KernelRecord& kernel, const FamilyRecord& family, FlipKind kind);
// Wrong verdicts with their rate: "0 (< 11.4 per million, 95 %)", "12 (45.8 per million)"; "not checked" where no
// decided query could be wrong in this way.
std::string with_rate(FlipKind kind, const KernelRecord& kernel, const FamilyRecord& family);

}  // namespace axiscert

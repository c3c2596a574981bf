// A diagnosis: what a kernel of which only the verdicts are seen is like, found by asking it.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/text/json.h"
#include "kernel/kernel.h"

namespace axiscert {

// Values that every property may have. `not_known`: the kernel was asked, and its answers do not decide. `not_asked`:
// the probe does not apply to this predicate or precision; the sentence says why.
inline constexpr std::string_view not_known = "not_known", not_asked = "not_asked";

// A property as it is defined, whatever the kernel.
struct PropertyKind {
  std::string_view name;                 // stable, for files: "touching"
  std::string_view asks;                 // one line
  std::vector<std::string_view> values;  // besides not_known and not_asked; empty: the ids of the built-in kernels
};
// In the order in which a diagnosis has them.
std::span<const PropertyKind> property_kinds();

// How much a value matters to somebody who uses the kernel, 0 the most: answers that change by themselves, then wrong
// logic, numbers of its own, its range, conventions, and how it computes. Empty of what is to be expected, or not
// known.
std::optional<std::size_t> importance_of(std::string_view property, std::string_view value);

// A query that shows why a property has its value.
struct DiagnosisWitness {
  QueryLine query;
  std::string answered, truth, shows;

  AXISCERT_FIELDS(
      DiagnosisWitness, AXISCERT_FIELD(query, "A query as in a query file."),
      AXISCERT_FIELD(answered, "The kernel's verdict; where it was asked in two ways both, with a comma."),
      AXISCERT_FIELD(truth, "The exact answer: contact, separated, invalid, or touching, at a distance of exactly r."),
      AXISCERT_FIELD(shows, "How it was asked, and what follows, in a line."))
};

struct Property {
  std::string name, value, sentence;
  std::uint64_t queries = 0;
  std::vector<DiagnosisWitness> witnesses = {};
  Json measured = nullptr;
  LookedAt looked_at = {};

  static constexpr std::string_view about = "One property, with what its value rests on.";
  AXISCERT_FIELDS(
      Property, AXISCERT_FIELD(name, "Which property."),
      AXISCERT_FIELD(
          value, "One of the property's values, not_known or not_asked; of nearest_form the id of a built-in kernel."),
      AXISCERT_FIELD(sentence, "The same in words, for a reader who has not read the probe."),
      AXISCERT_FIELD(queries, "Answers of the kernel that were looked at."),
      AXISCERT_FIELD(witnesses, "A few queries that show it; none where no single query does."),
      AXISCERT_FIELD(measured, "Numbers by name, such as the size of a threshold; null: none."),
      AXISCERT_FIELD(looked_at,
                     "What became of them, without those that invariance is counted from. A value needs half of them "
                     "decided and within the limits, but where one answer shows it."))
};

struct Diagnosis {
  std::string kernel;  // id
  const Predicate* predicate = nullptr;
  Precision precision = Precision::binary32;
  std::uint64_t seed = 1;
  bool may_decline = false, complete = true;
  std::vector<Property> properties = {};  // in the order of property_kinds()

  // Null where there is none of that name.
  const Property* find(std::string_view name) const;
  // Those that matter most first, and in their order those of equals and those that are as expected or not known.
  std::vector<const Property*> most_important_first() const;
  // Over all properties. Where nothing was decided, nothing is known of the kernel.
  LookedAt looked_at() const;
  std::string predicate_id() const { return std::string(predicate->id); }
  WholeNumber whole_seed() const { return {seed}; }

  AXISCERT_FIELDS(Diagnosis, AXISCERT_FIELD(kernel, "The kernel as given."), journalled(&Of::predicate),
                  field(&Of::predicate_id, {"predicate", "The predicate that it answers."}),
                  AXISCERT_FIELD(precision, "The precision of the queries."), journalled(&Of::seed),
                  field(&Of::whole_seed, {"seed", "The seed of all random choices."}),
                  AXISCERT_FIELD(may_decline, "Whether the kernel declares that it may answer `undecided`."),
                  AXISCERT_FIELD(complete,
                                 "False where it was interrupted: the properties that were not reached are missing."),
                  AXISCERT_FIELD(looked_at,
                                 "The answers over all properties, without those that invariance is counted from. With "
                                 "none decided, nothing is known of the kernel."),
                  AXISCERT_FIELD(properties, "In the order in which they were asked."))
};

struct DiagnosisOptions {
  Precision precision = Precision::binary32;
  std::uint64_t seed = 1;
  std::string target = std::string(scalar_target);  // resolved
  const std::atomic<bool>* interrupted = nullptr;   // polled between batches
  ShowProgress report = {};                         // may be empty; a unit is a property
};

// Asks the kernel: some ten thousands of queries, in a few seconds for a built-in kernel. Depends on the kernel, the
// precision and the seed alone. Throws Error where the kernel does not exist in the precision, and OracleDisagreement.
Diagnosis diagnose(const Kernel& kernel, const DiagnosisOptions& options);

}  // namespace axiscert

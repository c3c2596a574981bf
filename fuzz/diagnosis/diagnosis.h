// A diagnosis: what a kernel of which only the verdicts are seen is like, found by asking it.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/counts/looked_at.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/text/json.h"
#include "kernel/kernel.h"

namespace axiscert {

// Values that every property may have. `not_known`: the kernel was asked, and its answers do not decide. `not_asked`:
// the probe does not apply to this test or precision; the sentence says why.
inline constexpr std::string_view not_known = "not_known", not_asked = "not_asked";

// A property as it is defined, whatever the kernel.
struct PropertyKind {
  std::string_view name;                 // stable, for files: "touching"
  std::string_view asks;                 // one line
  std::vector<std::string_view> values;  // besides not_known and not_asked; empty: the ids of the built-in kernels
};
// In the order in which a diagnosis has them.
std::span<const PropertyKind> property_kinds();

// A query that shows why a property has its value.
struct DiagnosisWitness {
  std::string query;     // a line of a query file
  std::string answered;  // what the kernel said: a verdict's name, or several in the order of `asked`
  std::string truth;     // "separated", "contact" or "touching"
  std::string shows;     // one line: how it was asked, and what follows
};

struct Property {
  std::string name;                              // of its kind
  std::string value;                             // one of its kind's values, or not_known or not_asked
  std::string sentence;                          // plain English, for a reader who has not read the probe
  std::uint64_t queries = 0;                     // answers on which the value rests
  std::vector<DiagnosisWitness> witnesses = {};  // a few, or none where no single query shows it
  Json measured = nullptr;                       // numbers by name, such as the size of a threshold; null: none
  LookedAt looked_at = {};                       // the answers that were asked for here, by what became of them
};

struct Diagnosis {
  std::string kernel;  // id
  const TestDescription* test = nullptr;
  Precision precision = Precision::binary32;
  std::uint64_t seed = 1;
  bool may_decline = false;               // the kernel declares that it may answer `undecided`
  bool complete = true;                   // false: interrupted, and the properties that were not reached are missing
  std::vector<Property> properties = {};  // in the order of property_kinds()

  // Null where there is none of that name.
  const Property* find(std::string_view name) const;
  // Over all properties. Where nothing was decided, nothing is known of the kernel.
  LookedAt looked_at() const;
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

// A property and a diagnosis as JSON: what `axiscert diagnose --format json` prints.
Json property_json(const Property& property);
Json diagnosis_json(const Diagnosis& diagnosis);

}  // namespace axiscert

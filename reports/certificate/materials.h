// What a certificate is made from, as it states it: the counts of a stretch, and parts of a record.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "fuzz/campaign/stretch.h"
#include "fuzz/record/record.h"
#include "kernel/predicate.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/certificate_data.h"

namespace axiscert {
// Sums: all but the medians.
struct RadiiAdded {
  static void merge(CriticalRadiusRecord& into, const CriticalRadiusRecord& from);
};

// The counts of one stretch, or of several of a family added up, without zeros: what counts_json
// (fuzz/confirm/record.h) has of them, and nothing in all other members.
struct StretchCounts : FamilyCounts {
  CriticalRadiusRecord critical_radius;
  std::optional<std::map<InputClass, ClassCount>> classes;
  std::map<FindingKind, std::uint64_t> findings;

  AXISCERT_FIELDS(StretchCounts, base<Of, FamilyCounts>(),
                  field(&Of::critical_radius, {"critical_radius", {}}, RadiiAdded()), AXISCERT_OPTIONAL_FIELD(classes),
                  AXISCERT_FIELD(findings))
};

// The counts of counts_json without zeros, nulls and empty objects; fractions are decimal
// texts.
Json sparse_counts(const Json& counts);

// A finished stretch as a certificate has it.
TallyMaterial tally_of_stretch(const std::vector<const Kernel*>& kernels, const Stretches& stretches,
                               const Entry& entry);

// All counts that a kernel's entry of a record has in a family, each zero.
Json no_counts(const KernelRecord& entry, const Predicate& predicate);

// The whole counts again, from `none`, what no_counts gave. Throws NotValid, which begins with `where`, for a member
// that is not there, a number that is none, or a count above `most`.
Json whole_counts(const Json& none, const Json& sparse, std::uint64_t most, const std::string& where);

// Decimal text as a number again. Throws NotValid, which begins with `where`, for what is none, or not finite.
Json number_of_text(const Json& text, const std::string& where);

// Parts of a record as a certificate states them, which may come from anybody: checked, and brought back to the
// record's form. All throw NotValid, which begins with `where`.

// A part of a record, from its JSON.
template <class T>
T form_again(const Json& part, const std::string& where) {
  try {
    return read_as<T>(part);
  } catch (const Error& fault) {
    throw NotValid(fmt::format("{}: {}", where, fault.what()));
  }
}

// A kernel's entry of the record, without its families; `id` is the kernel's.
KernelRecord entry_again(Json entry, const std::string& id, const std::string& where);
// A family's "invariance".
std::map<ImageKind, ImageChangesRecord> invariance_again(Json invariance, const std::string& where);
// The "numbers" of a family's "asymmetry".
ImageNumbersRecord image_numbers_again(Json numbers, const std::string& where);

// The whole counts of one stretch, of so many queries, which agree with each other and with the promise of touch.
StretchCounts counts_again(const Json& whole, TouchingPolicy touching, std::uint64_t queries, const std::string& where);

}  // namespace axiscert

// Parts of a record as a certificate states them, which may come from anybody: checked, and brought back to the
// record's form. All throw NotValid, which begins with `where`.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <string>

#include "fuzz/record/record.h"
#include "reports/certificate/derived/counts.h"
#include "reports/certificate/statement/canonical.h"

namespace axiscert {

// The id of its kernel in a certificate, in all that does not depend on where the kernel's files are.
inline constexpr const char* portable_id = "kernel";

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

// The whole counts of one stretch, of so many queries, which agree with each other.
StretchCounts counts_again(const Json& whole, std::uint64_t queries, const std::string& where);

}  // namespace axiscert

// Parts of a record as a certificate states them, which may come from anybody: checked, and brought back to the
// record's form. All throw NotValid, which begins with `where`.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "fuzz/record/record.h"
#include "reports/certificate/statement/canonical.h"

namespace axiscert {

// The id of its kernel in a certificate, in all that does not depend on where the kernel's files are.
inline constexpr const char* portable_id = "kernel";

// That a part of a record is what such a struct is in JSON.
template <class T>
void require_form(const Json& part, const std::string& where) {
  try {
    read_as<T>(part);
  } catch (const JsonFault& fault) {
    throw NotValid(fmt::format("{}: {}", where, fault.what()));
  }
}

// A kernel's entry of the record, without its families; `id` is the kernel's.
Json entry_again(Json entry, const Json& id, const std::string& where);
// A family's "invariance".
Json invariance_again(Json invariance, const std::string& where);

// The counts of one stretch, of so many queries, agree with each other.
void require_counts(const Json& counts, std::uint64_t queries, const std::string& where);

}  // namespace axiscert

// One line of a query file as one query: the two formats behind query_file.h.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/files/query_file.h"

namespace axiscert {

using KnownPredicates = std::span<const Predicate* const>;

// The numbers' columns of a CSV header, as messages show them: those of the first entry of the predicate that files
// imply.
std::string csv_columns(KnownPredicates known);

// The position of a line, for messages.
struct Place {
  std::string_view file;
  std::size_t line;

  std::string default_id() const;
  // Throws Error; `field` is empty if no field is at fault.
  [[noreturn]] void fail(std::string_view field, std::string_view what) const;
};

// A predicate and one of its entries: the meaning of a line's numbers.
struct EntryOfPredicate {
  const Predicate* predicate;
  std::size_t entry;

  const PredicateEntry& columns() const { return predicate->entries[entry]; }
};

// One of the numbers of a query as text, with the beginning of a message about it.
struct NumberText {
  std::string field, element, text;
};
// `numbers` are as many as the entry has columns.
StoredQuery stored_query(std::string_view id, Precision precision, const EntryOfPredicate& of,
                         const std::vector<NumberText>& numbers, const Place& place);

// The name of a member that is neither the query's nor one that axiscert writes beside it, and the member that may have
// been meant, or nothing.
struct UnreadField {
  std::string name, meant;
};
// Adds to `unread`, where it is given, the fields that were passed over.
StoredQuery query_of_json(std::string_view line, const Place& place, KnownPredicates known = predicates(),
                          std::vector<UnreadField>* unread = nullptr);

struct CsvHeader {
  bool has_id;
  EntryOfPredicate of;
};
// Empty if the line does not begin like a CSV header of any entry; throws Error if it does but is not a valid header.
std::optional<CsvHeader> csv_header(std::string_view line, const Place& place, KnownPredicates known = predicates());
StoredQuery query_of_csv(std::string_view line, const CsvHeader& header, Precision precision, const Place& place);

}  // namespace axiscert

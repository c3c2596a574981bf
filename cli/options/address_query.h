// Generates the query of an address.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "fuzz/queries/address.h"
#include "fuzz/files/query_file.h"

namespace axiscert {

// Present paths of the files in which addresses can be.
struct AddressFiles {
  std::string mesh, queries, corpus;
};
void add_address_files(CLI::App& command, AddressFiles& files);

// The queries of files (- for standard input) and of addresses, one after the other; `csv_precision` as in
// query_file.h.
std::vector<StoredQuery> queries_given(const std::vector<std::string>& given, const std::string& csv_precision,
                                       const AddressFiles& files);

// Generates the query again, with its address as its id. Throws Error where the source is not available here, or
// differs in its version or its SHA-256.
StoredQuery query_at(const Address& address, const AddressFiles& files);

}  // namespace axiscert

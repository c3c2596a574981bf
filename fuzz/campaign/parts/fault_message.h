// An exception as bytes: from the rank that met it to rank 0, which tells it.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace axiscert {

std::string fault_message(const std::exception_ptr& fault);
// Throws what was made a message of: Error, HarnessFault, OracleDisagreement with its query, or a std::runtime_error.
[[noreturn]] void rethrow_fault(std::string_view message, int rank);

}  // namespace axiscert

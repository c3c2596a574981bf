// An exception as bytes: sent by the rank that met it to rank 0, which reports it.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace axiscert {

std::string fault_message(const std::exception_ptr& fault);
// Throws the exception that the message was made from: Error, HarnessFault, OracleDisagreement with its query, or a
// std::runtime_error.
[[noreturn]] void rethrow_fault(std::string_view message, int rank);

}  // namespace axiscert

#include "kernel/program/stream_header.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <cstring>

#include "kernel/base/error.h"

namespace axiscert::plugin {

std::string program_header(const TestDescription& test, std::size_t entry, Precision precision) {
  const TestEntry& given = test.entries[entry];
  std::string plan = fmt::format(R"({{"precision":"{}","test":"{}","entry":"{}","columns":{}}})"
                                 "\n",
                                 name(precision), test.id, given.name, given.columns.size());
  const std::size_t whole = sizeof(pipe::Head) + plan.size();
  plan.append((pipe::header_multiple - whole % pipe::header_multiple) % pipe::header_multiple, ' ');
  pipe::Head head{pipe::magic,
                  pipe::version_of(test),
                  pipe::code_of(precision),
                  0,
                  static_cast<std::uint32_t>(sizeof(pipe::Head) + plan.size()),
                  pipe::record_size_of(precision, given.columns.size()),
                  {}};
  unsigned size = 0;
  auto* const digest = reinterpret_cast<unsigned char*>(head.plan_sha256.data());
  if (EVP_Digest(plan.data(), plan.size(), digest, &size, EVP_sha256(), nullptr) != 1 ||
      size != head.plan_sha256.size()) {
    throw HarnessFault("OpenSSL refused to compute a SHA-256");
  }
  std::string bytes(sizeof head, '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes + plan;
}

}  // namespace axiscert::plugin

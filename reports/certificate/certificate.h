// A certificate: a Statement of in-toto about a kernel, alone or in a signed envelope; written and read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/text/json.h"
#include "reports/certificate/statement/certificate_data.h"
#include "reports/certificate/statement/envelope.h"

namespace axiscert {

inline constexpr std::size_t most_certificate_bytes = std::size_t{64} << 20;

// predicate.digest: the SHA-256 of the canonical JSON of all else. It tells of a slip; against a forger there is the
// signature.
std::string digest_without_itself(Json statement);
// Canonical JSON of the statement, or the envelope around it, with a line end. Throws HarnessFault where it could not
// be read again.
std::string certificate_text(const CertificateStatement& statement, const SigningKey* key);

struct Certificate {
  CertificateStatement statement;
  std::optional<Envelope> envelope;  // of a signed one; the signature is not checked yet
  const CertificatePredicate& predicate() const { return statement.predicate; }
};

// Reads a certificate from anybody. Throws Error, which begins with `name`, for what is no certificate, or one of a
// version that this axiscert does not read; NotValid for one that was changed after it was written.
Certificate read_certificate(std::string_view bytes, const std::string& name);
// The certificate in a file, which is not read beyond most_certificate_bytes.
Certificate read_certificate_file(const std::string& path);

}  // namespace axiscert

// A certificate: a Statement of in-toto about a kernel, alone or in a signed envelope; written and read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/text/json.h"
#include "reports/certificate/statement/envelope.h"

namespace axiscert {

inline constexpr const char* statement_schema = "https://in-toto.io/Statement/v1";
inline constexpr const char* certificate_type = "urn:axiscert:certificate:2";
inline constexpr const char* certificate_schema = "axiscert-certificate/2";
inline constexpr std::size_t most_certificate_bytes = std::size_t{64} << 20;

// A statement without its digest, with it: predicate.digest is the SHA-256 of the canonical JSON of all else. It tells
// of a slip; against a forger there is the signature.
Json with_digest(Json statement);
// Canonical JSON of the statement, or the envelope around it, with a line end. Throws HarnessFault where the statement
// does not conform to certificate.schema.json.
std::string certificate_text(const Json& statement, const SigningKey* key);

struct Certificate {
  Json statement;                    // conforms to certificate.schema.json
  std::optional<Envelope> envelope;  // of a signed one; the signature is not checked yet
  const Json& predicate() const { return statement["predicate"]; }
  std::string digest() const { return predicate()["digest"]; }
};

// Reads a certificate from anybody. Throws Error, which begins with `name`, for what is no certificate, or one of a
// version that this axiscert does not read; NotValid for one that was changed after it was written.
Certificate read_certificate(std::string_view bytes, const std::string& name);
// The certificate in a file, which is not read beyond most_certificate_bytes.
Certificate read_certificate_file(const std::string& path);

}  // namespace axiscert

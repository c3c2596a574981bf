// The parts of a certificate's statement that say what it is about, and what it was made from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/json_fwd.h"
#include "kernel/kernel.h"
#include "reports/certificate/certificate_data.h"
#include "reports/certificate/envelope.h"

namespace axiscert {
// The digests of this axiscert's sources, made when it was built: SHA-256, 64 hex digits.
struct SourceDigests {
  std::string sources;  // everything that judges: kernel/, exact/, fuzz/, reports/, cli/, without tests
  std::string kernels;  // kernel/ alone: what a built-in kernel is made of
  std::string proofs;   // proofs/, without what is built there
};
const SourceDigests& source_digests();

KernelKind kind_of_kernel(const Kernel& kernel);

// A file as a subject; throws Error where it cannot be read.
SubjectStatement file_subject(const std::string& path, const std::string& what);
// A built-in kernel of this axiscert, by its id and the sources of kernels.
SubjectStatement built_in_subject(const std::string& id);
// The subjects of a kernel: of a built-in one the above, else all its files. Nothing is loaded or started.
std::vector<SubjectStatement> subjects_of(const Kernel& kernel);

// Fractions as decimal text, the shortest that is the same double again; canonical JSON has none.
Json without_fractions(const Json& value);

// A record's plan, or that of a plan file, as a certificate has it: the kernel, its first, under the name "kernel", and
// no file of kernels, whose digests are the subjects'. So a plan does not depend on where files are.
Json portable_plan(Json plan);
std::string digest_of_json(const Json& value);  // SHA-256 of its canonical form

// A certificate: a Statement of in-toto about a kernel, alone or in a signed envelope; written and read.

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

// The parts of a certificate's statement that say what it is about, and what it was made from.
#pragma once

#include <string>
#include <vector>

#include "fuzz/text/json.h"
#include "kernel/kernel.h"
#include "reports/certificate/statement/certificate_data.h"

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

}  // namespace axiscert

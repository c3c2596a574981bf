// Verifies a certificate: its form, digests and signature, that a kernel is the one that it is about, and, where it is
// asked for, that a sample of its run comes out the same here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/reply_plan.h"
#include "fuzz/campaign/campaign.h"
#include "reports/certificate/certificate_data.h"
#include "reports/certificate/statement.h"

namespace axiscert {
struct VerifyOptions {
  std::string certificate, key;  // key: a public one; empty: no signature is checked
  // The kernel that has to be the one: a file, "plugin:FILE", "program:MANIFEST", or the id of a peer or a built-in
  // kernel; empty: of a built-in kernel this axiscert's, else none is looked at.
  std::string kernel;
  std::string recheck;  // "1%": that share of its stretches; empty: nobody's code is run
  std::optional<std::uint64_t> recheck_seed;
  // For a certificate of replies these, whose claim the certificate has; for any the present paths of the files of its
  // plan.
  ReplyOptions replies;
  int threads = 0;
};

// Prints what it finds, line by line. Returns exit_done, or exit_requirement_failed where the certificate does not
// hold. Throws Error for what cannot be read, or not be checked here.
int verify(const VerifyOptions& options);

// Runs a certificate's kernel again on a sample of its stretches.

// "1%", "0.5%" or a share from 0 to 1, as a share. Throws Error.
double recheck_share(const std::string& given);

// Says what it runs, and runs it: each kernel has to say of itself what the certificate states of it, each tally of the
// sample has to have the digest and the counts, and each family of images in it has to come to the same again. Where
// every stretch is done again, the medians of the critical radius are compared too, and nothing is left that was made
// of the run's counts. `id` is the kernel's here. Throws NotValid for a difference, Error where the plan cannot be run
// here.
bool recheck_certificate(const Certificate& certificate, const VerifyOptions& options, const std::string& id);

// Compares what a certificate states of its kernels with what the kernels here declare.

// How a kernel's entry in a certificate differs from what the kernel declares, given by these files or built in: a
// sentence for each part of it that does.
std::vector<std::string> declared_differences(const KernelMaterial& stated, const std::vector<FileInfo>& plugins,
                                              const Kernel& kernel, Precision precision);

// How the numbers of triangles of the kernels' entries differ from those of the families asked. A family that was not
// asked is left out.
std::vector<std::string> triangle_differences(const CertificatePredicate& predicate, const Questions& questions);

}  // namespace axiscert

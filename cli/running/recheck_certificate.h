// Runs a certificate's kernel again on a sample of its stretches.
#pragma once

#include <string>

#include "cli/running/verify.h"
#include "reports/certificate/certificate.h"

namespace axiscert {

// "1%", "0.5%" or a share from 0 to 1, as a share. Throws Error.
double recheck_share(const std::string& given);

// Says what it runs, and runs it: each kernel has to say of itself what the certificate states of it, each tally of the
// sample has to have the digest and the counts, and each family of images in it has to come to the same again. Where
// every stretch is done again, the medians of the critical radius are compared too, and nothing is left that was made
// of the run's counts. `id` is the kernel's here. Throws NotValid for a difference, Error where the plan cannot be run
// here.
void recheck_certificate(const Certificate& certificate, const VerifyOptions& options, const std::string& id);

}  // namespace axiscert

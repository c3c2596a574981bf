// Certifies a kernel: the run of its plan, what else a certificate rests on, and the certificate's files.
#pragma once

#include <optional>
#include <string>

#include "cli/options/certified_plan.h"
#include "cli/options/reply_plan.h"

namespace axiscert {

struct CertifyOptions : CertifiedRun {
  std::string out = "certificate", key;  // key: a private one; empty: the certificate is not signed
  std::optional<double> seconds;         // of the run of the plan
  bool resume = false, quiet = false;
  bool is_of_replies = false;  // of these, in place of a kernel: its id, effort's plan, seed and meshes are theirs
  ReplyOptions replies;
};

// Writes certificate.json, certificate.html, certificate.txt, badge.svg and, in `run`, the run's folder. Returns an
// ExitCode; only rank 0 writes anything. Throws Error, HarnessFault.
int certify(const CertifyOptions& options);

}  // namespace axiscert

// Verifies a certificate: its form, digests and signature, that a kernel is the one that it is about, and, where it is
// asked for, that a sample of its run comes out the same here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/reply_plan.h"

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

}  // namespace axiscert

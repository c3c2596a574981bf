#include "cli/running/verify.h"

#include "cli/commands.h"
#include "cli/options/run_options.h"
#include "cli/progress_line.h"
#include "cli/values.h"

namespace axiscert {

void add_verify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "verify",
      "Check a certificate: that it is whole, who signed it, that it is about this kernel; runs nobody's code");
  auto options = std::make_shared<VerifyOptions>();
  VerifyOptions& o = *options;
  o.replies.replies.clear();
  command->add_option("CERT", o.certificate, "certificate.json")->required();
  command->add_option("--key", o.key, "public Ed25519 key in PEM that has to have signed it");
  command->add_option("--kernel", o.kernel,
                      "kernel that it has to be about: the file of a plug-in, a program's manifest, or an id");
  auto* recheck =
      command->add_option("--recheck", o.recheck,
                          "share of its stretches, as 1%, that the kernel is run on again: the tallies have to be "
                          "those of the certificate");
  command->add_option("--recheck-seed", o.recheck_seed, "seed that selects them (default: chosen anew, and printed)")
      ->check(whole_number())
      ->needs(recheck);
  command->add_option("--replies", o.replies.replies, "reply file that it has to be about, repeatable")
      ->allow_extra_args(false);
  add_reply_files(*command, o.replies);
  add_thread_option(*command, o.threads);
  add_plugin_seconds(*command);
  add_progress(*command);
  command->callback([&action, options] { action = [options] { return verify(*options); }; });
}

}  // namespace axiscert

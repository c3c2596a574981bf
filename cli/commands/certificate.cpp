#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/commands/certify.h"
#include "cli/commands/verify.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/instruments/effort.h"

namespace axiscert {
void add_certify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "certify", "Ask a kernel everything, and write a certificate of what it is, which others can check");
  auto options = std::make_shared<CertifyOptions>();
  CertifyOptions& o = *options;
  const KernelArguments kernel = add_kernel(*command, o.kernel, "kernel to certify");
  command
      ->add_option(
          "--replies", o.replies.replies,
          "in place of a kernel: a file of a program's replies to `generate --binary`, one for each precision, "
          "repeatable")
      ->allow_extra_args(false)
      ->excludes(kernel.named)
      ->excludes(kernel.argument)
      ->group(asked_group);
  add_reply_options(*command, o.replies);
  command
      ->add_option("--effort", o.effort,
                   "how much is asked: quick and standard take a built-in kernel some 2 and 20 minutes on two cores, "
                   "deep takes an hour and a half; smoke takes seconds, to try a workflow")
      ->check(one_of(std::vector<std::string>(effort_names.begin(), effort_names.end())))
      ->capture_default_str();
  add_seed(*command, o.seed);
  command
      ->add_option(
          "--time", o.seconds,
          "seconds after which the run of the plan begins no further stretch; the certificate lists those done")
      ->check(number_above_zero());
  command->add_option("--key", o.key, "private Ed25519 key in PEM that signs the certificate, with the time");
  add_out(*command, o.out, "certificate.json, its page, text and badge, and the run");
  command->add_flag("--resume", o.resume, "continue in the folder of --out");
  add_quiet(*command, o.quiet, "print only errors");
  add_thread_option(*command, o.threads);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_examples(
      *command,
      {{"The least that is a certificate, in seconds", "axiscert certify published --effort smoke --out certificate"},
       {"A kernel of one's own, signed", "axiscert certify plugin:./my_kernel.so --effort standard --key signing.pem"},
       {"Go on after an interruption", "axiscert certify published --out certificate --resume"}});
  command->callback([&action, options, command] {
    options->is_of_replies = command->count("--replies") != 0;
    options->meshes = options->replies.meshes;
    if (!options->is_of_replies && options->kernel.empty()) throw CLI::RequiredError("KERNEL, or --replies FILE,");
    action = [options] { return certify(*options); };
  });
}

void add_verify(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "verify",
      "Check a certificate: that it is whole, who signed it, that it is about this kernel; runs nobody's code");
  auto options = std::make_shared<VerifyOptions>();
  VerifyOptions& o = *options;
  o.replies.replies.clear();
  command->add_option("CERT", o.certificate, "certificate.json")->required()->check(no_kernel());
  command->add_option("--key", o.key, "public Ed25519 key in PEM that has to have signed it");
  add_kernel(*command, o.kernel,
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
  add_examples(*command,
               {{"Is it whole?", "axiscert verify certificate/certificate.json"},
                {"Is it about this kernel?", "axiscert verify certificate/certificate.json plugin:./my_kernel.so"},
                {"Do a hundredth of its stretches come out the same here?",
                 "axiscert verify certificate/certificate.json --recheck 1%"}});
  command->callback([&action, options] { action = [options] { return verify(*options); }; });
}

}  // namespace axiscert

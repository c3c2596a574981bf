// Certifies a kernel: the run of its plan, what else a certificate rests on, and the certificate's files.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "cli/commands/run_output.h"
#include "cli/reply_plan.h"
#include "fuzz/instruments/effort.h"
#include "fuzz/search/search.h"
#include "fuzz/text/json_form.h"
#include "plans/plan_file.h"
#include "reports/certificate/certificate_data.h"

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

// The stages of a certificate besides its run: each asks something else of the kernel, and gives its part of the
// certificate's predicate.

// Thrown where an interrupt ended a stage.
struct StageInterrupted {};

// The stages that are done, in a file of the certificate's folder, so that --resume does not do them again.
class Stages {
 public:
  // Continues the file where it is there and of the same plan.
  Stages(const OutputFolder& folder, const std::string& path, const std::string& plan_digest, bool resume);
  // The part of this name: as it was done, or made now.
  Json get(const std::string& name, const std::function<Json()>& make);
  template <class Part>
  Part part(const std::string& name, const std::function<Part()>& make) {
    return read_as<Part>(get(name, [&] { return json_of(make()); }));
  }
  // The state of a part that is not done yet, from which it goes on; empty where none was kept.
  std::optional<std::string> state(const std::string& name) const;
  void keep_state(const std::string& name, const std::string& state);

 private:
  const OutputFolder& folder_;
  Json done_;
};

struct StagedCertificate {
  const CertifyOptions& options;
  const Kernel& kernel;
  const Questions& questions;  // of the run
  const RunningOptions& running;
  const Record& record;  // of the run
  EffortSize size;

  std::vector<Precision> precisions() const;  // in which the kernel exists
};

// The whole search of a plan with a number of evaluations, whose state is kept under `name` every so many seconds: an
// end without notice costs no more than those. What it finds does not depend on where it was ended.
SearchResult run_resumable_search(SearchPlan plan, Stages& stages, const std::string& name, double seconds,
                                  const std::atomic<bool>& interrupted,
                                  const std::function<void(const SearchProgress&)>& report);

SearchesStatement run_search_stage(const StagedCertificate& staged, Stages& stages);
DiagnosisStatement run_diagnosis_stage(const StagedCertificate& staged, Stages& stages);
// After the search, whose finds are asked too.
SafeMarginStatement run_margin_stage(const StagedCertificate& staged, Stages& stages, const SearchesStatement& search);
HarnessStatement run_harness_stage(const StagedCertificate& staged, Stages& stages);

}  // namespace axiscert

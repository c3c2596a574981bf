// The diagnosis of a kernel in one precision, as a certificate has it.
#include <fmt/format.h>

#include "cli/progress_line.h"
#include "cli/running/certify_stages.h"
#include "fuzz/diagnosis/diagnosis.h"

namespace axiscert {

Json diagnosed(const Staged& staged, Precision precision) {
  ProgressLine progress(fmt::format("certify: diagnosis, {}", name(precision)), staged.options.quiet);
  DiagnosisOptions options;
  options.precision = precision;
  options.seed = staged.options.seed;
  options.target = staged.plan.target;
  options.interrupted = &watch_for_interrupts();
  options.report = progress.report();
  const auto found = diagnose(staged.kernel, options);
  if (!found.complete) throw StageInterrupted();
  Json properties = Json::array();
  for (const auto& p : found.properties) {
    properties.push_back({{"name", p.name}, {"value", p.value}, {"sentence", p.sentence}, {"queries", p.queries}});
  }
  return {{"precision", name(precision)}, {"properties", properties}};
}

}  // namespace axiscert

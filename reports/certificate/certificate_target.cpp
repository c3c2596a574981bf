// Fuzzes certificates: they are refused, by Error or NotValid, or read; and what was read is written to the same bytes,
// shown, and held to its counts. The digest is corrected first, or nearly no input would pass it; every input is also
// read unchanged.
#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"
#include "fuzz/text/json.h"
#include "reports/certificate/statement.h"
#include "reports/certificate/derived.h"
#include "reports/certificate/page.h"
#include "reports/certificate/canonical.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

void check(std::string_view text) {
  Certificate certificate;
  try {
    if (!accepts([&] { certificate = read_certificate(text, "cert.json"); })) return;
  } catch (const NotValid& wrong) {
    check_message(wrong.what());
    return;
  }
  if (!certificate.envelope) {
    const std::string written = certificate_text(certificate.statement, nullptr);
    if (written != text && written != std::string(text) + "\n")
      report_fault("a certificate that was read is written otherwise");
  }
  try {
    accepts([&] { require_derived(certificate.predicate(), "cert.json"); });
  } catch (const NotValid& wrong) {
    check_message(wrong.what());
  }
  const InstrumentReport report = certificate_report(certificate.statement, "axiscert certify");
  if (instrument_page(report).empty() || certificate_words(report).empty() ||
      certificate_badge(certificate.statement).empty()) {
    report_fault("a certificate that was read is not shown");
  }
}

std::string with_digest_again(std::string_view text) {
  try {
    Json statement = strict_json(text, "cert.json", most_certificate_bytes);
    if (!statement.is_object() || !statement.value("predicate", Json()).is_object()) return std::string(text);
    statement["predicate"]["digest"] = digest_without_itself(statement);
    return canonical_json(statement) + "\n";
  } catch (const Error&) {
    return std::string(text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  check(text);
  check(with_digest_again(text));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return mutate_json(data, size, room, seed);
}
